#ifndef VFH_ASTAR_TRAJECTORY_TIMING_H_
#define VFH_ASTAR_TRAJECTORY_TIMING_H_

#include <optional>
#include <vector>

#include "vfh_astar/geometry.h"
#include "vfh_astar/robot_limits.h"
#include "vfh_astar/trajectory/pose_check.h"
#include "vfh_astar/trajectory/spline_curve.h"
#include "vfh_astar/trajectory/trajectory.h"

namespace vfh_astar {

/// How speed depends on the room between footprint and obstacle.
struct RoomSpeed {
  double slow_room = 0.1;   ///< m at which `near_speed` is allowed.
  double fast_room = 0.6;   ///< m from which on room is no limit.
  double near_speed = 0.8;  ///< m/s
};

/// m/s allowed at a curvature (1/m) by the limits on speed, turning rate,
/// lateral acceleration and the faster side's wheels.
double SpeedAtCurvature(double curvature, double max_v,
                        const RobotLimits& limits);

/// m/s allowed with `room` metres between footprint and obstacle: rises in
/// proportion to `near_speed` at `slow_room` (from a quarter of it, so that the
/// robot never crawls), then linearly to `max_v` at `fast_room`.
double SpeedAtRoom(double room, double max_v, const RoomSpeed& rule);

/// The motion that a drive starts from.
struct DriveStart {
  double speed = 0.0;  ///< m/s, 0 or more, along the direction of travel.
  std::optional<double> acceleration;  ///< m/s^2
};

struct TimedPieces {
  std::vector<TrajectoryPiece> pieces;
  bool keeps_limits = true;  ///< see SpeedProfile.
};

/// Drives along a curve to rest at its end, as fast as the limits allow: a
/// quintic piece between each two neighbouring points, meeting position,
/// velocity and acceleration of curve and speed profile there.
/// @param[in] points at least two, as SplineCurve::Sample gives them.
TimedPieces TimeDrive(const std::vector<CurvePoint>& points, bool reverse,
                      const DriveStart& start, const RobotLimits& limits,
                      const RoomSpeed& rule, const PoseCheck& check);

/// Turns on the spot, to rest, as fast as the limits allow.
/// @param[in] angle rad, signed, not 0.
/// @param[in] w rad/s at the start; of the same sign as `angle`, and no faster
///   than what can be braked within it.
std::vector<TrajectoryPiece> TimeTurn(const Pose2D& pose, double angle,
                                      double w, const RobotLimits& limits);

}  // namespace vfh_astar

#endif  // VFH_ASTAR_TRAJECTORY_TIMING_H_
