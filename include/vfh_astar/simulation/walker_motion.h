#ifndef VFH_ASTAR_SIMULATION_WALKER_MOTION_H_
#define VFH_ASTAR_SIMULATION_WALKER_MOTION_H_

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "vfh_astar/geometry.h"
#include "vfh_astar/simulation/shape.h"
#include "vfh_astar/simulation/world.h"

namespace vfh_astar {

/// A robot as those see it who react to it.
struct SeenRobot {
  Pose2D pose;
  Shape outline;
  double speed = 0.0;  ///< m/s
};

/// Where a Walker is and what it is about to do. It waits until a moving robot
/// comes near, steps in front of it, stands there for a while, and does so
/// again; after the last time it goes home. It takes care not to walk into
/// anything: it waits before a robot or an obstacle, and where it has waited
/// for too long it stands as if it had arrived.
class WalkerMotion {
 public:
  explicit WalkerMotion(const Walker& walker)
      : walker_(walker), position_(walker.home) {}

  /// Moves on to `time` (s).
  /// @param[in] is_free says whether a shape would touch nothing that stands.
  void Update(double time, const std::vector<SeenRobot>& robots,
              const std::function<bool(const Shape&)>& is_free);

  Shape shape() const { return MakeDisc(position_, walker_.radius); }

 private:
  enum class State { kWaiting, kStepping, kStanding, kLeaving };

  /// The place on the robot's way that is `ahead` of the robot when the walker
  /// gets there, if the robot goes on as it does.
  Eigen::Vector2d PlaceToMeet(const SeenRobot& robot) const;
  void Notice(const std::vector<SeenRobot>& robots);
  /// @return false when something is in the way.
  bool Walk(double duration, const std::vector<SeenRobot>& robots,
            const std::function<bool(const Shape&)>& is_free);

  Walker walker_;
  State state_ = State::kWaiting;
  Eigen::Vector2d position_;
  Eigen::Vector2d target_ = Eigen::Vector2d::Zero();
  double time_ = 0.0;        ///< s, of the last update.
  double state_time_ = 0.0;  ///< s spent standing, or stopped on the way.
  int times_ = 0;            ///< that it has stepped into a way.
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_SIMULATION_WALKER_MOTION_H_
