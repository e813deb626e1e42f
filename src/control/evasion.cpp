#include "vfh_astar/control/evasion.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "vfh_astar/control/command_shaping.h"

namespace vfh_astar {
namespace {

constexpr double kStep = 0.15;        ///< s between two looks.
constexpr double kTurnGain = 3.0;     ///< 1/s, from heading error to w.
constexpr double kMostTurn = 2.5;     ///< rad/s
constexpr double kReliable = 0.6;     ///< of the limits, what is counted on.
constexpr double kReverse = 0.5;      ///< m/s
constexpr double kStaticRoom = 0.06;  ///< m beside what stands.
/// s in which a robot must be able to stop before what stands.
constexpr double kTimeToStop = 0.8;

/// After so many steps it is asked whether a motion can still be the best.
constexpr std::size_t kStepsPerJudgement = 2;
constexpr double kRounding = 1e-9;  ///< of a cost.

constexpr double kLeastMargin = 0.03;  ///< m
constexpr double kDeepest = 1.5;       ///< m short of comfort that still count.

// What SafetyLimiter will do beside something that might turn around: with less
// room, speed falls to what can be braked.
constexpr double kReaction = 0.1;    ///< s
constexpr double kBraking = 5.0;     ///< m/s^2
constexpr double kNearEnough = 1.5;  ///< m

constexpr double kSpeeds[] = {0.3, 0.7, 1.1, 1.5, 1.9};  ///< m/s
constexpr double kTurns[] = {0.0,  0.25,  -0.25, 0.5,   -0.5, 0.85, -0.85,
                             1.25, -1.25, 1.75,  -1.75, 2.4,  -2.4, kPi};
constexpr double kReverseTurns[] = {0.0, 0.4, -0.4, 0.8, -0.8};

RobotLimits ReliableOf(RobotLimits limits) {
  limits.max_acceleration *= kReliable;
  limits.max_deceleration *= kReliable;
  limits.max_angular_acceleration *= kReliable;
  return limits;
}

}  // namespace

void EvasionParameters::Read(ParameterReader& reader) {
  reader.Number("horizon", horizon, 0.5, 10.0);
  reader.Number("margin", margin, 0.0, 2.0);
  reader.Number("growth", growth, 0.0, 2.0);
  reader.Number("lead", lead, 0.0, 3.0);
  reader.Number("comfort", comfort, 0.0, 5.0);
  reader.Number("room_weight", room_weight, 0.0, 100.0);
  reader.Number("contact_cost", contact_cost, 0.0, 100.0);
  reader.Number("haste_cost", haste_cost, 0.0, 100.0);
  reader.Number("change_weight", change_weight, 0.0, 100.0);
  reader.Number("reverse_weight", reverse_weight, 0.0, 100.0);
}

Evasion::Evasion(const EvasionParameters& parameters,
                 const Footprint& footprint, const RobotLimits& limits)
    : parameters_(parameters),
      footprint_(footprint),
      limits_(limits),
      reliable_(ReliableOf(limits)),
      radius_(footprint.CircumscribedRadius()) {}

Evasion::Forecast Evasion::Foresee(const EvasionScene& scene) const {
  Forecast forecast;
  for (const MovingObstacle& mover : scene.movers) {
    Body body{parameters_.lead * mover.velocity, mover.radius,
              mover.velocity.norm(), 0.0};
    const double gap = Gap(body, mover.position, Eigen::Vector2d::Zero(), 0.0);
    // Who is nearer than the margin already has to get away as best it can.
    body.margin = std::clamp(gap - 0.02, kLeastMargin, parameters_.margin);
    forecast.bodies.push_back(body);
  }
  double time = 0.0;
  forecast.times = {time};
  while (time < parameters_.horizon) {
    time += kStep;
    forecast.times.push_back(time);
  }
  for (const double at : forecast.times) {
    for (const MovingObstacle& mover : scene.movers) {
      const double reach = parameters_.comfort + mover.radius + radius_ +
                           parameters_.growth * at +
                           parameters_.lead * mover.velocity.norm();
      forecast.places.push_back({mover.At(at), reach * reach});
    }
  }
  return forecast;
}

std::vector<Evasion::Motion> Evasion::Motions(const EvasionScene& scene) const {
  const double target = std::atan2(scene.target.y(), scene.target.x());
  std::vector<Motion> motions = {{0.0, 0.0}, {0.0, target}};
  for (const double speed : kSpeeds) {
    if (speed > limits_.max_v) continue;
    motions.push_back({speed, 0.0});
    for (const double turn : kTurns) {
      motions.push_back({speed, NormalizeAngle(target + turn)});
    }
  }
  const double reverse = std::min(kReverse, limits_.max_v_reverse);
  if (reverse <= 0.0) return motions;
  for (const double turn : kReverseTurns) motions.push_back({-reverse, turn});
  return motions;
}

Twist2D Evasion::Steer(const Motion& motion, double heading) const {
  const double error = NormalizeAngle(motion.heading - heading);
  const double w = std::clamp(kTurnGain * error, -kMostTurn, kMostTurn);
  return LimitSpeed({motion.speed * std::max(0.0, std::cos(error)), w},
                    limits_);
}

std::optional<Evasion::Outlook> Evasion::Play(const Motion& motion,
                                              const EvasionScene& scene,
                                              const Forecast& forecast,
                                              double most) const {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  Outlook outlook{kNone, kNone, 0.0, kNone};
  Pose2D pose;
  Twist2D twist = scene.twist;
  const double fastest = std::max(std::abs(twist.v), std::abs(motion.speed));
  const double room_here = scene.room ? scene.room(pose.position()) : kNone;
  const double least_room =
      std::min(footprint_.InscribedRadius() + kStaticRoom, room_here - 0.01);
  const double target_distance = scene.target.norm();
  for (std::size_t step = 1; step < forecast.times.size(); ++step) {
    twist =
        LimitAcceleration(Steer(motion, pose.theta), twist, reliable_, kStep);
    const Twist2D slowed = Slowed(twist, pose, forecast, step - 1);
    const Pose2D next = Integrate(pose, slowed, kStep);
    const double time = forecast.times[step];
    // Before what stands the robot will be stopped, and what moves comes on.
    const bool is_stopped =
        outlook.free_time < kNone ||
        (scene.room && scene.room(next.position()) < least_room);
    if (is_stopped) {
      outlook.free_time = std::min(outlook.free_time, time);
      twist = Twist2D();
    } else {
      pose = next;
      twist.v = slowed.v;
    }
    outlook.way = target_distance - (scene.target - pose.position()).norm();
    LookAround(pose.position(), forecast, step, &outlook);
    if (step % kStepsPerJudgement != 0) continue;
    Outlook at_best = outlook;
    at_best.way += fastest * (forecast.times.back() - time);
    if (Cost(motion, at_best) > most + kRounding) return std::nullopt;
  }
  return outlook;
}

void Evasion::LookAround(const Eigen::Vector2d& place, const Forecast& forecast,
                         std::size_t step, Outlook* outlook) const {
  const double time = forecast.times[step];
  const Place* places = forecast.At(step);
  for (std::size_t i = 0; i < forecast.bodies.size(); ++i) {
    const Eigen::Vector2d& position = places[i].position;
    // Of what is far away there is no need to know how far.
    if ((position - place).squaredNorm() > places[i].beyond) continue;
    const double gap = Gap(forecast.bodies[i], position, place, time);
    outlook->gap = std::min(outlook->gap, gap);
    if (gap < forecast.bodies[i].margin) {
      outlook->contact_time = std::min(outlook->contact_time, time);
    }
  }
}

Twist2D Evasion::Slowed(const Twist2D& twist, const Pose2D& pose,
                        const Forecast& forecast, std::size_t step) const {
  Twist2D slowed = twist;
  const Place* places = forecast.At(step);
  for (std::size_t i = 0; i < forecast.bodies.size(); ++i) {
    const Body& body = forecast.bodies[i];
    const Eigen::Vector2d way = places[i].position - pose.position();
    const double near = kNearEnough + body.radius + radius_;
    if (way.squaredNorm() > near * near) continue;
    const Eigen::Vector2d heading = pose.heading();
    for (int halving = 0; halving < 3; ++halving) {
      const double stop_time = kReaction + std::abs(slowed.v) / kBraking;
      const double stop_way =
          slowed.v * (kReaction + 0.5 * std::abs(slowed.v) / kBraking);
      const double left =
          (way - stop_way * heading).norm() - body.radius - radius_;
      if (left > body.speed * stop_time) break;
      slowed.v *= 0.5;
    }
  }
  return slowed;
}

double Evasion::Gap(const Body& body, const Eigen::Vector2d& position,
                    const Eigen::Vector2d& place, double time) const {
  const Eigen::Vector2d offset = place - position;
  const double length = body.ahead.squaredNorm();
  const double along =
      length == 0.0 ? 0.0
                    : std::clamp(offset.dot(body.ahead) / length, 0.0, 1.0);
  return (offset - along * body.ahead).norm() - body.radius - radius_ -
         parameters_.growth * time;
}

double Evasion::Cost(const Motion& motion, const Outlook& outlook) const {
  const double horizon = parameters_.horizon;
  double cost = -outlook.way;
  cost += parameters_.room_weight *
          std::clamp(parameters_.comfort - outlook.gap, 0.0, kDeepest);
  if (outlook.contact_time <= horizon) {
    cost += parameters_.contact_cost +
            parameters_.haste_cost * (1.0 - outlook.contact_time / horizon);
  }
  if (outlook.free_time < kTimeToStop) cost += parameters_.haste_cost;
  if (last_heading_) {
    cost += parameters_.change_weight *
            std::abs(NormalizeAngle(motion.heading - *last_heading_));
  }
  if (motion.speed < 0.0) {
    cost -= parameters_.reverse_weight * motion.speed * horizon;
  }
  return cost;
}

std::vector<std::size_t> Evasion::MostPromisingFirst(
    const std::vector<Motion>& motions, const EvasionScene& scene,
    double horizon) const {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  std::vector<double> least(motions.size());
  for (std::size_t i = 0; i < motions.size(); ++i) {
    const Eigen::Vector2d end = horizon * motions[i].speed *
                                Pose2D(0.0, 0.0, motions[i].heading).heading();
    const double way = scene.target.norm() - (scene.target - end).norm();
    least[i] = Cost(motions[i], {kNone, kNone, way, kNone});
  }
  std::vector<std::size_t> order(motions.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(
      order.begin(), order.end(),
      [&](std::size_t a, std::size_t b) { return least[a] < least[b]; });
  return order;
}

EvasionResult Evasion::Update(const EvasionScene& scene) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  struct Choice {
    double cost = kNone;
    std::size_t motion = 0;
    double contact_time = kNone;

    bool operator<(const Choice& other) const {
      return cost < other.cost || (cost == other.cost && motion < other.motion);
    }
  };
  const Forecast forecast = Foresee(scene);
  const std::vector<Motion> motions = Motions(scene);
  Choice best;     // of all, as long as none is allowed,
  Choice allowed;  // and of those.
  for (const std::size_t i :
       MostPromisingFirst(motions, scene, forecast.times.back())) {
    // What costs more than an allowed one is out, however it ends.
    const std::optional<Outlook> outlook =
        Play(motions[i], scene, forecast, allowed.cost);
    if (!outlook) continue;
    const Choice choice{Cost(motions[i], *outlook), i, outlook->contact_time};
    if (choice < best) best = choice;
    if (choice < allowed &&
        (!scene.is_allowed || scene.is_allowed(Steer(motions[i], 0.0)))) {
      allowed = choice;
    }
  }
  if (allowed.cost < kNone) best = allowed;
  const Motion& motion = motions[best.motion];
  last_heading_ = motion.heading;
  EvasionResult result;
  result.contact_time = best.contact_time;
  result.command = Steer(motion, 0.0);
  result.direction = motion.speed < 0.0 ? NormalizeAngle(motion.heading + kPi)
                                        : motion.heading;
  return result;
}

}  // namespace vfh_astar
