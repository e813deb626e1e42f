#ifndef VFH_ASTAR_CONTROL_SAFETY_LIMITER_H_
#define VFH_ASTAR_CONTROL_SAFETY_LIMITER_H_

#include <Eigen/Core>
#include <vector>

#include "vfh_astar/footprint.h"
#include "vfh_astar/geometry.h"
#include "vfh_astar/parameters.h"

namespace vfh_astar {

struct SafetyLimiterParameters {
  double margin = 0.03;        ///< m kept around the footprint.
  double reaction_time = 0.1;  ///< s from a scan until a command acts on it.
  double deceleration = 2.5;   ///< m/s^2 the robot brakes with for certain.
  double angular_deceleration = 8.0;  ///< rad/s^2
  double scan_timeout = 0.25;         ///< s; older scans stop the robot.

  void Read(ParameterReader& reader);
};

struct LimitedCommand {
  Twist2D command;
  bool limited = false;  ///< the command was changed.
};

/// The last stage before cmd_vel: passes on only commands from which the robot
/// can stop before its footprint, grown by the margin, reaches a hit of the
/// latest scan.
///
/// The motion that is checked is the command held for reaction_time, then
/// braking along the same arc to rest; sweeping it is sweeping the arc of the
/// command for reaction_time plus half the braking time. A command that fails
/// is scaled down along its arc, and where that leaves no way forward the robot
/// may still turn on the spot. A point that lies within the margin already
/// forbids only what brings it nearer, so that the robot can leave.
class SafetyLimiter {
 public:
  SafetyLimiter(const SafetyLimiterParameters& parameters,
                const Footprint& footprint);

  /// @param[in] command wanted.
  /// @param[in] twist measured. When braking from it at once would not do, the
  ///   answer is to stop, whatever was wanted; so it is when either is not
  ///   finite.
  /// @param[in] obstacles points in the robot's frame now, m.
  LimitedCommand Limit(const Twist2D& command, const Twist2D& twist,
                       const std::vector<Eigen::Vector2d>& obstacles) const;

  /// True when the robot, driving `command` for `hold` seconds and braking
  /// then, keeps clear.
  bool CanStop(const Twist2D& command, double hold,
               const std::vector<Eigen::Vector2d>& obstacles) const;

 private:
  Twist2D ScaleDown(const Twist2D& command,
                    const std::vector<Eigen::Vector2d>& obstacles) const;

  SafetyLimiterParameters parameters_;
  Footprint footprint_;
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_CONTROL_SAFETY_LIMITER_H_
