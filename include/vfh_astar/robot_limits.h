#ifndef VFH_ASTAR_ROBOT_LIMITS_H_
#define VFH_ASTAR_ROBOT_LIMITS_H_

#include "vfh_astar/parameters.h"

namespace vfh_astar {

/// How fast the robot may be driven. The defaults are what trajectories are
/// planned for.
struct RobotLimits {
  double max_v = 1.9;                     ///< m/s, forward.
  double max_v_reverse = 0.5;             ///< m/s, backward.
  double max_w = 3.0;                     ///< rad/s
  double max_acceleration = 2.0;          ///< m/s^2, speeding up.
  double max_deceleration = 2.5;          ///< m/s^2, braking.
  double max_angular_acceleration = 8.0;  ///< rad/s^2
  double max_lateral_acceleration = 2.0;  ///< m/s^2, v * w.
  double max_wheel_speed = 2.5;    ///< m/s on the ground, of the faster side.
  double wheel_separation = 0.56;  ///< m; effective, as the wheel controller
                                   ///< takes it: skidding makes it wider than
                                   ///< the track.

  /// What commands may ask of a Jackal, whose own controller allows 2.0 m/s, 20
  /// m/s^2, 4.0 rad/s and 25 rad/s^2. More than what trajectories are planned
  /// for: a robot that has fallen behind could never catch up otherwise.
  static RobotLimits ForCommands() {
    RobotLimits limits;
    limits.max_v = 2.0;
    limits.max_v_reverse = 0.6;
    limits.max_w = 4.0;
    limits.max_acceleration = 5.0;
    limits.max_deceleration = 6.0;
    limits.max_angular_acceleration = 20.0;
    limits.max_lateral_acceleration = 3.0;
    return limits;
  }

  void Read(ParameterReader& reader) {
    reader.Number("max_v", max_v, 0.05, 20.0);
    reader.Number("max_v_reverse", max_v_reverse, 0.0, 20.0);
    reader.Number("max_w", max_w, 0.05, 20.0);
    reader.Number("max_acceleration", max_acceleration, 0.05, 50.0);
    reader.Number("max_deceleration", max_deceleration, 0.05, 50.0);
    reader.Number("max_angular_acceleration", max_angular_acceleration, 0.05,
                  100.0);
    reader.Number("max_lateral_acceleration", max_lateral_acceleration, 0.05,
                  50.0);
    reader.Number("max_wheel_speed", max_wheel_speed, 0.05, 20.0);
    reader.Number("wheel_separation", wheel_separation, 0.0, 5.0);
  }
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_ROBOT_LIMITS_H_
