#include "vfh_astar/navigation/navigator_parameters.h"

namespace vfh_astar {

void GoalParameters::Read(ParameterReader& reader) {
  reader.Number("tolerance", tolerance, 0.0, 10.0);
  reader.Number("xy_goal_tolerance", xy_goal_tolerance, 0.01, 5.0);
  reader.Number("yaw_goal_tolerance", yaw_goal_tolerance, 0.01, 3.15);
  reader.Number("stopped_v", stopped_v, 0.001, 0.5);
  reader.Number("stopped_w", stopped_w, 0.001, 1.0);
  reader.Number("settle_time", settle_time, 0.1, 60.0);
  reader.Number("patience", patience, 0.0, 600.0);
}

void ReplanParameters::Read(ParameterReader& reader) {
  reader.Number("max_error", max_error, 0.02, 10.0);
  reader.Number("max_heading_error", max_heading_error, 0.1, 3.15);
  reader.Number("blocked_time", blocked_time, 0.0, 1e6);
  reader.Number("horizon", horizon, 0.0, 60.0);
  reader.Number("margin", margin, 0.0, 1.0);
  reader.Number("period", period, 0.02, 10.0);
  reader.Number("timeout", timeout, 0.1, 60.0);
  reader.Number("latency", latency, 0.0, 1.0);
  reader.Number("lag", lag, 0.0, 5.0);
}

void AvoidanceParameters::Read(ParameterReader& reader) {
  reader.Choice("rule", rule, {"time_to_collision", "distance"});
  reader.Number("enter_time", enter_time, 0.0, 10.0);
  reader.Number("leave_time", leave_time, 0.0, 10.0);
  reader.Number("enter_distance", enter_distance, 0.0, 5.0);
  reader.Number("leave_distance", leave_distance, 0.0, 5.0);
  reader.Number("min_time", min_time, 0.0, 10.0);
  reader.Number("blocked_time", blocked_time, 0.0, 1e6);
}

void RecoveryParameters::Read(ParameterReader& reader) {
  reader.Number("stuck_time", stuck_time, 0.2, 60.0);
  reader.Number("stuck_distance", stuck_distance, 0.005, 2.0);
  reader.Number("stuck_angle", stuck_angle, 0.01, 3.15);
  reader.Number("back_up_distance", back_up_distance, 0.05, 5.0);
  reader.Number("speed", speed, 0.02, 2.0);
  reader.Number("turn_speed", turn_speed, 0.05, 4.0);
  reader.Number("max_time", max_time, 0.5, 60.0);
  reader.Integer("max_attempts", max_attempts, 0, 100);
}

void OscillationParameters::Read(ParameterReader& reader) {
  reader.Number("time", time, 0.0, 600.0);
  reader.Number("distance", distance, 0.05, 10.0);
}

void WatchdogParameters::Read(ParameterReader& reader) {
  reader.Number("odometry_timeout", odometry_timeout, 0.02, 5.0);
  reader.Number("transform_timeout", transform_timeout, 0.05, 60.0);
  reader.Number("fault_patience", fault_patience, 0.1, 60.0);
}

void NavigatorParameters::Read(ParameterReader& reader) {
  reader.Group("footprint", footprint);
  reader.Group("limits", limits);
  reader.Integer("occupied_threshold", occupied_threshold, 1, 100);
  reader.Number("actuation_delay", actuation_delay, 0.0, 0.5);
  reader.Group("tracking", tracking);
  reader.Group("vfh", vfh);
  reader.Group("movers", movers);
  reader.Group("evasion", evasion);
  reader.Group("safety", safety);
  reader.Group("goal", goal);
  reader.Group("replan", replan);
  reader.Group("avoidance", avoidance);
  reader.Group("recovery", recovery);
  reader.Group("oscillation", oscillation);
  reader.Group("watchdog", watchdog);
}

}  // namespace vfh_astar
