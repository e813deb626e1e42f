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
/// The motion that is checked: the command held for reaction_time, then braking
/// along the same arc to rest. A command that fails is scaled down along its
/// arc. Points that lie within the margin already do not forbid a motion that
/// takes the robot away from them.
class SafetyLimiter {
 public:
  SafetyLimiter(const SafetyLimiterParameters& parameters,
                const Footprint& footprint);

  /// @param[in] command wanted.
  /// @param[in] twist measured; the robot cannot stop faster than from this.
  /// @param[in] obstacles points in the robot's frame now, m.
  LimitedCommand Limit(const Twist2D& command, const Twist2D& twist,
                       const std::vector<Eigen::Vector2d>& obstacles) const;

  /// True when stopping from `command`, driven from now on, keeps clear.
  bool IsSafe(const Twist2D& command,
              const std::vector<Eigen::Vector2d>& obstacles) const;

 private:
  SafetyLimiterParameters parameters_;
  Footprint footprint_;
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_CONTROL_SAFETY_LIMITER_H_
