#include "vfh_astar/navigation/driver.h"

#include <algorithm>
#include <cmath>

#include "vfh_astar/control/command_shaping.h"
#include "vfh_astar/control/tracking_law.h"

namespace vfh_astar {

Driver::Driver(const NavigatorParameters& parameters)
    : parameters_(parameters),
      vfh_(parameters.vfh),
      limiter_(parameters.safety, parameters.footprint) {}

void Driver::ParametersChanged() {
  vfh_ = Vfh(parameters_.vfh);
  limiter_ = SafetyLimiter(parameters_.safety, parameters_.footprint);
}

Eigen::Vector3d Driver::Error(const Observation& observation) const {
  return TrackingError(observation.pose, follower_.At(0.0).pose);
}

double Driver::ReferenceRate(double lag) const {
  const double start = parameters_.replan.lag;
  if (start == 0.0) return 1.0;
  const double end = std::max(parameters_.replan.max_error, start + 0.01);
  return std::clamp((end - lag) / (end - start), 0.0, 1.0);
}

Twist2D Driver::Track(const Observation& observation, double duration,
                      bool hold_position) {
  const double rate = ReferenceRate(Error(observation)[0]);
  follower_.Advance(duration, rate);

  // The command acts after the actuation delay: track where the robot and the
  // reference will be then.
  const double delay = parameters_.actuation_delay;
  const Pose2D pose = Integrate(observation.pose, previous_, delay);
  Reference reference = follower_.At(delay * rate);
  reference.twist.v *= rate;
  reference.twist.w *= rate;
  Eigen::Vector3d error = TrackingError(pose, reference.pose);
  if (hold_position) error.head<2>().setZero();
  return TrackingCommand(error, reference.twist, parameters_.tracking);
}

double Driver::TargetDirection(const Observation& observation) const {
  constexpr double kStep = 0.1;
  const double look_ahead = parameters_.vfh.look_ahead;
  const double remaining =
      follower_.trajectory().duration() - follower_.clock();
  Eigen::Vector2d target = follower_.End().position();
  for (double ahead = 0.0; ahead < remaining; ahead += kStep) {
    const Eigen::Vector2d point = follower_.At(ahead).pose.position();
    if ((point - observation.pose.position()).norm() >= look_ahead) {
      target = point;
      break;
    }
  }
  const Eigen::Vector2d in_robot = observation.pose.Inverse() * target;
  return std::atan2(in_robot.y(), in_robot.x());
}

Twist2D Driver::Avoid(const Observation& observation, double duration) {
  if (parameters_.replan.lag == 0.0) {
    follower_.Advance(duration, 1.0);
  } else {
    constexpr double kHorizon = 2.0;  // s along the trajectory
    follower_.AdvanceToNearest(observation.pose.position(), kHorizon);
  }
  avoidance_ = vfh_.Update(observation.obstacles, TargetDirection(observation));
  return avoidance_.command;
}

LimitedCommand Driver::Limit(const Twist2D& wanted,
                             const Observation& observation, double duration) {
  const Twist2D command =
      LimitAcceleration(LimitSpeed(wanted, parameters_.limits), previous_,
                        parameters_.limits, duration);
  const LimitedCommand limited =
      limiter_.Limit(command, observation.twist, observation.obstacles);
  previous_ = limited.command;
  return limited;
}

}  // namespace vfh_astar
