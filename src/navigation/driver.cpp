#include "vfh_astar/navigation/driver.h"

#include <algorithm>
#include <cmath>

#include "vfh_astar/control/command_shaping.h"
#include "vfh_astar/control/tracking_law.h"
#include "vfh_astar/navigation/collision_watch.h"

namespace vfh_astar {

Driver::Driver(const NavigatorParameters& parameters)
    : parameters_(parameters),
      vfh_(parameters.vfh),
      evasion_(parameters.evasion, parameters.footprint, parameters.limits),
      limiter_(parameters.safety, parameters.footprint) {}

void Driver::ParametersChanged() {
  vfh_ = Vfh(parameters_.vfh);
  evasion_ =
      Evasion(parameters_.evasion, parameters_.footprint, parameters_.limits);
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

Eigen::Vector2d Driver::Target(const Observation& observation,
                               double distance) const {
  constexpr double kStep = 0.1;
  const double remaining =
      follower_.trajectory().duration() - follower_.clock();
  Eigen::Vector2d target = follower_.End().position();
  for (double ahead = 0.0; ahead < remaining; ahead += kStep) {
    const Eigen::Vector2d point = follower_.At(ahead).pose.position();
    if ((point - observation.pose.position()).norm() >= distance) {
      target = point;
      break;
    }
  }
  return observation.pose.Inverse() * target;
}

void Driver::LetReferenceWait(const Observation& observation, double duration) {
  if (parameters_.replan.lag == 0.0) {
    follower_.Advance(duration, 1.0);
  } else {
    constexpr double kHorizon = 2.0;  // s along the trajectory
    follower_.AdvanceToNearest(observation.pose.position(), kHorizon);
  }
}

Twist2D Driver::Avoid(const Observation& observation, double duration) {
  LetReferenceWait(observation, duration);
  const Eigen::Vector2d target =
      Target(observation, parameters_.vfh.look_ahead);
  avoidance_ =
      vfh_.Update(observation.obstacles, std::atan2(target.y(), target.x()));
  return avoidance_.command;
}

Twist2D Driver::Evade(const Observation& observation, double duration) {
  constexpr double kLookAhead = 4.0;  // m
  LetReferenceWait(observation, duration);
  return EvadeTowards(Target(observation, kLookAhead), observation, duration);
}

bool Driver::IsMoverComing(const Observation& observation) const {
  const EvasionParameters& evasion = parameters_.evasion;
  return TimeToMoverContact(evasion.horizon, parameters_.footprint,
                            evasion.margin, evasion.growth,
                            observation) < kNever;
}

Twist2D Driver::Yield(const Observation& observation, double duration) {
  return EvadeTowards(Eigen::Vector2d::Zero(), observation, duration);
}

Twist2D Driver::EvadeTowards(const Eigen::Vector2d& target,
                             const Observation& observation, double duration) {
  EvasionScene scene;
  scene.twist = previous_;
  scene.target = target;
  scene.movers = observation.movers;
  if (observation.map != nullptr) {
    // Asked thousands of times: the turn is worked out once.
    const Eigen::Vector2d x_axis = observation.pose.heading();
    const Eigen::Vector2d y_axis(-x_axis.y(), x_axis.x());
    const Eigen::Vector2d origin = observation.pose.position();
    const ClearanceMap& map = *observation.map;
    scene.room = [=, &map](const Eigen::Vector2d& point) {
      return map.At(origin + point.x() * x_axis + point.y() * y_axis);
    };
  }
  const std::vector<Eigen::Vector2d> hits = HitsWithinReach(observation);
  scene.is_allowed = [&](const Twist2D& wanted) {
    return limiter_.IsSafe(Shape(wanted, duration), hits, observation.movers);
  };
  const EvasionResult result = evasion_.Update(scene);
  avoidance_ = VfhResult();
  avoidance_.open = true;
  avoidance_.direction = result.direction;
  return result.command;
}

std::vector<Eigen::Vector2d> Driver::HitsWithinReach(
    const Observation& observation) const {
  const RobotLimits& limits = parameters_.limits;
  const Twist2D& measured = observation.twist;
  // Neither what is measured nor a command after a change of the limits has to
  // keep to them.
  const Twist2D fastest{
      std::max({limits.max_v, limits.max_v_reverse, std::abs(previous_.v),
                std::abs(measured.v)}),
      std::max({limits.max_w, std::abs(previous_.w), std::abs(measured.w)})};
  const double reach = limiter_.Reach(fastest);
  std::vector<Eigen::Vector2d> hits;
  hits.reserve(observation.obstacles.size() + observation.mover_hits.size());
  for (const auto* points : {&observation.obstacles, &observation.mover_hits}) {
    for (const Eigen::Vector2d& point : *points) {
      if (point.squaredNorm() <= reach * reach) hits.push_back(point);
    }
  }
  return hits;
}

Twist2D Driver::Shape(const Twist2D& wanted, double duration) const {
  return LimitAcceleration(LimitSpeed(wanted, parameters_.limits), previous_,
                           parameters_.limits, duration);
}

LimitedCommand Driver::Limit(const Twist2D& wanted,
                             const Observation& observation, double duration) {
  const LimitedCommand limited =
      limiter_.Limit(Shape(wanted, duration), observation.twist,
                     HitsWithinReach(observation), observation.movers);
  previous_ = limited.command;
  return limited;
}

}  // namespace vfh_astar
