#ifndef VFH_ASTAR_SIMULATION_SOLIDS_H_
#define VFH_ASTAR_SIMULATION_SOLIDS_H_

#include <Eigen/Core>
#include <string>
#include <vector>

#include "vfh_astar/simulation/shape.h"
#include "vfh_astar/simulation/shape_index.h"
#include "vfh_astar/simulation/walker_motion.h"
#include "vfh_astar/simulation/world.h"

namespace vfh_astar {

/// A solid shape and the name of what it belongs to.
struct NamedShape {
  Shape shape;
  const std::string* name = nullptr;
};

/// Everything solid in a world but the robots, as it is at one time.
class Solids {
 public:
  explicit Solids(const World& world);

  /// Moves the movers to where they are at `time` (s) and lets appear what is
  /// due.
  /// @param[in] robots the first one is who pop-ups wait for; walkers mind all
  ///   of them, and nothing appears where one stands.
  void Update(double time, const std::vector<SeenRobot>& robots);

  /// False when nothing ever moves or appears, so that there is no need for
  /// Update.
  bool MayChange() const {
    return !(world_.movers.empty() && world_.pop_ups.empty() &&
             world_.walkers.empty());
  }

  /// The shapes that may come within `radius` (m) of a point.
  std::vector<NamedShape> Near(const Eigen::Vector2d& point,
                               double radius) const;

  /// What does not move.
  const ShapeIndex& statics() const { return statics_; }
  /// Movers, walkers, and pop-ups that have appeared.
  const std::vector<NamedShape>& moving() const { return moving_; }

  /// True when something solid touches the shape.
  bool IsOccupied(const Shape& shape) const;

  /// @return false when the name is taken.
  bool Add(const StaticObstacle& obstacle);
  /// @return false when there is nothing of this name.
  bool Remove(const std::string& name);

 private:
  bool HasName(const std::string& name) const;
  void IndexStatics();

  World world_;
  ShapeIndex statics_;
  std::vector<int> static_owners_;  ///< by shape in statics_.
  std::vector<NamedShape> moving_;
  std::vector<WalkerMotion> walkers_;
  std::vector<bool> appeared_;  ///< by pop-up.
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_SIMULATION_SOLIDS_H_
