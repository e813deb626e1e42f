#include "vfh_astar/navigation/request_start.h"

#include <cmath>

#include "vfh_astar/navigation/arrival.h"

namespace vfh_astar {
namespace {

bool IsOnReference(const Driver& driver, const Observation& observation,
                   const NavigatorParameters& parameters) {
  const TrajectoryFollower& follower = driver.follower();
  if (!follower.active() || follower.pending()) return false;
  const Eigen::Vector3d error = driver.Error(observation);
  const Twist2D reference = follower.At(0.0).twist;
  return error.head<2>().norm() < 0.5 * parameters.replan.max_error &&
         std::abs(error[2]) < 0.5 * parameters.replan.max_heading_error &&
         std::abs(reference.v - observation.twist.v) <
             0.25 * parameters.limits.max_v;
}

}  // namespace

RequestStart ChooseStart(const Driver& driver, const Observation& observation,
                         bool avoiding, double time,
                         const NavigatorParameters& parameters) {
  const double latency = parameters.replan.latency;
  RequestStart result;
  if (!avoiding && IsOnReference(driver, observation, parameters)) {
    result.join = driver.follower().clock() + latency;
    result.start = driver.follower().At(latency);
    result.time = time + latency;
  } else if (IsStanding(observation.twist, parameters.goal)) {
    result.start.pose = observation.pose;
    result.time = time;
  } else {
    result.start.twist = driver.previous();
    result.start.pose =
        Integrate(observation.pose, result.start.twist, latency);
    result.time = time + latency;
  }
  return result;
}

}  // namespace vfh_astar
