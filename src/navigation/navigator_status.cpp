#include "vfh_astar/navigation/navigator_status.h"

#include <algorithm>
#include <limits>

namespace vfh_astar {

NavigatorStatus Describe(State state, const std::string& reason,
                         const GoalRecord& record,
                         const Observation& observation, const Driver& driver,
                         bool avoiding, const NavigatorParameters& parameters) {
  NavigatorStatus status;
  status.state = state;
  const bool is_held = observation.fault && HasGoal(status.state);
  status.reason = is_held ? observation.fault->message : reason;
  status.replans = record.Replans();
  if (HasGoal(status.state)) status.goal_id = record.goal().id;
  status.pose = observation.pose;
  status.speed = observation.twist.v;
  for (const MovingObstacle& mover : observation.movers) {
    status.movers.push_back(Transform(observation.pose, mover));
  }
  status.clearance = observation.fault
                         ? std::numeric_limits<double>::quiet_NaN()
                         : std::min(FootprintClearance(parameters.footprint,
                                                       observation.obstacles),
                                    FootprintClearance(parameters.footprint,
                                                       observation.mover_hits));
  if (HasGoal(status.state)) {
    status.distance_to_goal =
        (record.goal().pose.position() - observation.pose.position()).norm();
  }
  if (driver.follower().active()) {
    status.reference = driver.follower().At(0.0);
    status.error = driver.Error(observation);
  }
  if (avoiding) {
    status.vfh_histogram = driver.avoidance().histogram;
    status.vfh_blocked = driver.avoidance().blocked;
    status.vfh_direction = driver.avoidance().direction;
  }
  return status;
}

}  // namespace vfh_astar
