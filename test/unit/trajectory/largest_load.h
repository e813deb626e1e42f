#ifndef TEST_UNIT_TRAJECTORY_LARGEST_LOAD_H_
#define TEST_UNIT_TRAJECTORY_LARGEST_LOAD_H_

#include <algorithm>
#include <cmath>

#include "vfh_astar/robot_limits.h"
#include "vfh_astar/trajectory/trajectory.h"

namespace vfh_astar {

/// Fraction of its limits that a trajectory takes, at worst.
inline double LargestLoad(const Trajectory& trajectory,
                          const RobotLimits& limits) {
  const double h = 1e-4;
  double load = 0.0;
  for (double t = 0.0; t < trajectory.duration(); t += 0.004) {
    const Reference at = trajectory.Sample(t);
    const double v = std::abs(at.twist.v);
    const double w = std::abs(at.twist.w);
    const double sign = at.twist.v < 0.0 ? -1.0 : 1.0;
    // At a standstill nothing says whether it speeds up or brakes.
    const double a = v > 0.0 ? sign * at.acceleration : 0.0;
    load = std::max(
        {load, v / (at.twist.v < 0.0 ? limits.max_v_reverse : limits.max_v),
         v * w / limits.max_lateral_acceleration, w / limits.max_w,
         (v + 0.5 * limits.wheel_separation * w) / limits.max_wheel_speed,
         a / limits.max_acceleration, -a / limits.max_deceleration});
    // At a standstill between two pieces w jumps by a rounding error.
    if (v < 0.03 || t < h || t + h > trajectory.duration()) continue;
    const double dw =
        trajectory.Sample(t + h).twist.w - trajectory.Sample(t - h).twist.w;
    load = std::max(load,
                    std::abs(dw) / (2 * h) / limits.max_angular_acceleration);
  }
  return load;
}

}  // namespace vfh_astar

#endif  // TEST_UNIT_TRAJECTORY_LARGEST_LOAD_H_
