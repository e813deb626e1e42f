#include "vfh_astar/navigation/arrival.h"

#include <cmath>

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

}  // namespace vfh_astar
