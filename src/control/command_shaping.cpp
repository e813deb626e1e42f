#include "vfh_astar/control/command_shaping.h"

#include <algorithm>
#include <cmath>

namespace vfh_astar {

Twist2D LimitSpeed(const Twist2D& command, const RobotLimits& limits) {
  double scale = 1.0;
  const double max_v = command.v < 0.0 ? limits.max_v_reverse : limits.max_v;
  if (std::abs(command.v) > max_v) scale = max_v / std::abs(command.v);
  if (scale * std::abs(command.w) > limits.max_w) {
    scale = limits.max_w / std::abs(command.w);
  }
  // v * w falls with the square of the scale.
  const double lateral = scale * scale * std::abs(command.v * command.w);
  if (lateral > limits.max_lateral_acceleration) {
    scale *= std::sqrt(limits.max_lateral_acceleration / lateral);
  }
  const double wheel =
      scale * (std::abs(command.v) +
               0.5 * limits.wheel_separation * std::abs(command.w));
  if (wheel > limits.max_wheel_speed) scale *= limits.max_wheel_speed / wheel;
  return {scale * command.v, scale * command.w};
}

Twist2D LimitAcceleration(const Twist2D& command, const Twist2D& previous,
                          const RobotLimits& limits, double duration) {
  // Braking is whatever brings |v| down; a change of sign brakes first.
  const double up = limits.max_acceleration * duration;
  const double down = limits.max_deceleration * duration;
  const double lowest = previous.v - (previous.v > 0.0 ? down : up);
  const double highest = previous.v + (previous.v < 0.0 ? down : up);
  const double turn = limits.max_angular_acceleration * duration;
  return {std::clamp(command.v, lowest, highest),
          std::clamp(command.w, previous.w - turn, previous.w + turn)};
}

}  // namespace vfh_astar
