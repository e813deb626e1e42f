#include "vfh_astar/navigation/arrival.h"

#include <cmath>
#include <cstdio>

namespace vfh_astar {

bool Arrival::Update(const Pose2D& pose, const Twist2D& twist,
                     const Pose2D& end) {
  const double distance = (pose.position() - end.position()).norm();
  if (distance <= parameters_.xy_goal_tolerance) latched_ = true;
  const double heading_error = std::abs(NormalizeAngle(end.theta - pose.theta));
  return latched_ && heading_error <= parameters_.yaw_goal_tolerance &&
         IsStanding(twist, parameters_);
}

bool IsStanding(const Twist2D& twist, const GoalParameters& parameters) {
  return std::abs(twist.v) <= parameters.stopped_v &&
         std::abs(twist.w) <= parameters.stopped_w;
}

std::string ArrivalMessage(const Pose2D& end, const Pose2D& goal,
                           const GoalParameters& parameters) {
  const double moved = (end.position() - goal.position()).norm();
  const double turned = NormalizeAngle(end.theta - goal.theta);
  char text[128] = "goal reached";
  if (moved > parameters.xy_goal_tolerance) {
    std::snprintf(text, sizeof(text),
                  "reached the nearest free place, %.2f m from the goal",
                  moved);
  } else if (std::abs(turned) > parameters.yaw_goal_tolerance) {
    std::snprintf(text, sizeof(text),
                  "goal reached, but the trajectory did not turn to its "
                  "heading, which is %.2f rad off",
                  turned);
  }
  return text;
}

}  // namespace vfh_astar
