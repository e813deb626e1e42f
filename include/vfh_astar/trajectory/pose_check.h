#ifndef VFH_ASTAR_TRAJECTORY_POSE_CHECK_H_
#define VFH_ASTAR_TRAJECTORY_POSE_CHECK_H_

#include <Eigen/Core>
#include <vector>

#include "vfh_astar/footprint.h"
#include "vfh_astar/geometry.h"
#include "vfh_astar/grid/clearance.h"

namespace vfh_astar {

/// Where the footprint may stand, and how much room it has there.
///
/// Everywhere `margin` is kept between the footprint and the edge of an
/// occupied cell, but a robot that stands nearer to one already is not refused
/// for what it can do nothing about: where it starts, it keeps what it has but
/// for a centimetre, and the margin grows to its full value within
/// kLeavingDistance metres.
class PoseCheck {
 public:
  static constexpr double kLeavingDistance = 1.0;  ///< m

  /// Keeps a reference to `clearance`.
  PoseCheck(const Footprint& footprint, const ClearanceMap& clearance,
            double margin, const Pose2D& start);

  /// True when the footprint stands free, with its centre on the map.
  bool IsFree(const Pose2D& pose) const;

  /// True when the footprint may turn on the spot by `angle` (rad, signed).
  bool IsTurnFree(const Pose2D& pose, double angle) const;

  /// m from the footprint to the nearest occupied cell's edge, by probes along
  /// its outline: for choosing a speed, not for deciding on a collision. At
  /// least 0, and at most the clearance map's max_distance().
  double Room(const Pose2D& pose) const;

  /// m from a point to the nearest occupied cell's edge.
  double RoomAt(const Eigen::Vector2d& point) const;

  const ClearanceMap& clearance() const { return clearance_; }
  const Footprint& footprint() const { return footprint_; }
  double margin() const { return margin_; }

 private:
  double MarginAt(const Eigen::Vector2d& point) const;

  Footprint footprint_;
  const ClearanceMap& clearance_;
  double margin_;
  Eigen::Vector2d start_;
  double start_margin_;
  std::vector<Eigen::Vector2d> outline_;  ///< robot frame.
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_TRAJECTORY_POSE_CHECK_H_
