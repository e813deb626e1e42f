#include "vfh_astar/ros/reconfiguration.h"

namespace vfh_astar {

LimitsConfig ToConfig(const RobotLimits& limits) {
  LimitsConfig config;
  config.max_v = limits.max_v;
  config.max_v_reverse = limits.max_v_reverse;
  config.max_w = limits.max_w;
  config.max_acceleration = limits.max_acceleration;
  config.max_deceleration = limits.max_deceleration;
  config.max_lateral_acceleration = limits.max_lateral_acceleration;
  return config;
}

void Apply(const LimitsConfig& config, RobotLimits& limits) {
  limits.max_v = config.max_v;
  limits.max_v_reverse = config.max_v_reverse;
  limits.max_w = config.max_w;
  limits.max_acceleration = config.max_acceleration;
  limits.max_deceleration = config.max_deceleration;
  limits.max_lateral_acceleration = config.max_lateral_acceleration;
}

GoalConfig ToConfig(const GoalParameters& goal) {
  GoalConfig config;
  config.tolerance = goal.tolerance;
  config.xy_goal_tolerance = goal.xy_goal_tolerance;
  config.yaw_goal_tolerance = goal.yaw_goal_tolerance;
  return config;
}

void Apply(const GoalConfig& config, GoalParameters& goal) {
  goal.tolerance = config.tolerance;
  goal.xy_goal_tolerance = config.xy_goal_tolerance;
  goal.yaw_goal_tolerance = config.yaw_goal_tolerance;
}

SafetyConfig ToConfig(const SafetyLimiterParameters& safety) {
  SafetyConfig config;
  config.margin = safety.margin;
  return config;
}

void Apply(const SafetyConfig& config, SafetyLimiterParameters& safety) {
  safety.margin = config.margin;
}

}  // namespace vfh_astar
