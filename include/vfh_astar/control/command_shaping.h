#ifndef VFH_ASTAR_CONTROL_COMMAND_SHAPING_H_
#define VFH_ASTAR_CONTROL_COMMAND_SHAPING_H_

#include "vfh_astar/geometry.h"
#include "vfh_astar/robot_limits.h"

namespace vfh_astar {

/// Scales a command into the limits on v, w, v * w and the speed of the faster
/// side's wheels along its arc, so that the robot drives the curve that was
/// asked for, only slower.
Twist2D LimitSpeed(const Twist2D& command, const RobotLimits& limits);

/// Moves from the previous command towards the wanted one by no more than the
/// accelerations allow within `duration` seconds.
Twist2D LimitAcceleration(const Twist2D& command, const Twist2D& previous,
                          const RobotLimits& limits, double duration);

}  // namespace vfh_astar

#endif  // VFH_ASTAR_CONTROL_COMMAND_SHAPING_H_
