#include "vfh_astar/control/evasion.h"

#include <algorithm>
#include <cmath>
#include <limits>

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
    : parameters_(parameters), footprint_(footprint), limits_(limits) {}

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

Evasion::Outlook Evasion::Play(const Motion& motion,
                               const EvasionScene& scene) const {
  RobotLimits reliable = limits_;
  reliable.max_acceleration *= kReliable;
  reliable.max_deceleration *= kReliable;
  reliable.max_angular_acceleration *= kReliable;
  constexpr double kNone = std::numeric_limits<double>::infinity();
  Outlook outlook{kNone, kNone, 0.0, kNone};
  Pose2D pose;
  Twist2D twist = scene.twist;
  const double room_here = scene.room ? scene.room(pose.position()) : kNone;
  const double least_room =
      std::min(footprint_.InscribedRadius() + kStaticRoom, room_here - 0.01);
  double time = 0.0;
  while (time < parameters_.horizon) {
    twist =
        LimitAcceleration(Steer(motion, pose.theta), twist, reliable, kStep);
    const Twist2D slowed = Slowed(twist, pose, time, scene);
    const Pose2D next = Integrate(pose, slowed, kStep);
    time += kStep;
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
    for (std::size_t i = 0; i < scene.movers.size(); ++i) {
      const MovingObstacle& mover = scene.movers[i];
      // Of what is far away there is no need to know how far.
      if (IsBeyond(mover, pose.position(), time, parameters_.comfort)) continue;
      const double gap = Gap(mover, pose.position(), time);
      outlook.gap = std::min(outlook.gap, gap);
      if (gap < margins_[i]) {
        outlook.contact_time = std::min(outlook.contact_time, time);
      }
    }
  }
  outlook.way = scene.target.norm() - (scene.target - pose.position()).norm();
  return outlook;
}

Twist2D Evasion::Slowed(const Twist2D& twist, const Pose2D& pose, double time,
                        const EvasionScene& scene) const {
  Twist2D slowed = twist;
  const double radius = footprint_.CircumscribedRadius();
  for (const MovingObstacle& mover : scene.movers) {
    const Eigen::Vector2d way = mover.At(time) - pose.position();
    const double near = kNearEnough + mover.radius + radius;
    if (way.squaredNorm() > near * near) continue;
    const double speed = mover.velocity.norm();
    for (int halving = 0; halving < 3; ++halving) {
      const double stop_time = kReaction + std::abs(slowed.v) / kBraking;
      const double stop_way =
          slowed.v * (kReaction + 0.5 * std::abs(slowed.v) / kBraking);
      const double left =
          (way - stop_way * pose.heading()).norm() - mover.radius - radius;
      if (left > speed * stop_time) break;
      slowed.v *= 0.5;
    }
  }
  return slowed;
}

bool Evasion::IsBeyond(const MovingObstacle& mover,
                       const Eigen::Vector2d& place, double time,
                       double gap) const {
  const double reach = gap + mover.radius + footprint_.CircumscribedRadius() +
                       parameters_.growth * time +
                       parameters_.lead * mover.velocity.norm();
  return (mover.At(time) - place).squaredNorm() > reach * reach;
}

double Evasion::Gap(const MovingObstacle& mover, const Eigen::Vector2d& place,
                    double time) const {
  const Eigen::Vector2d ahead = parameters_.lead * mover.velocity;
  const Eigen::Vector2d offset = place - mover.At(time);
  const double length = ahead.squaredNorm();
  const double along =
      length == 0.0 ? 0.0 : std::clamp(offset.dot(ahead) / length, 0.0, 1.0);
  return (offset - along * ahead).norm() - mover.radius -
         footprint_.CircumscribedRadius() - parameters_.growth * time;
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

EvasionResult Evasion::Update(const EvasionScene& scene) {
  struct Choice {
    double cost;
    Motion motion;
    double contact_time;
  };
  std::vector<Choice> choices;
  margins_.clear();
  for (const MovingObstacle& mover : scene.movers) {
    // Who is nearer than the margin already has to get away as best it can.
    margins_.push_back(
        std::clamp(Gap(mover, Eigen::Vector2d::Zero(), 0.0) - 0.02,
                   kLeastMargin, parameters_.margin));
  }
  for (const Motion& motion : Motions(scene)) {
    const Outlook outlook = Play(motion, scene);
    choices.push_back({Cost(motion, outlook), motion, outlook.contact_time});
  }
  std::stable_sort(
      choices.begin(), choices.end(),
      [](const Choice& a, const Choice& b) { return a.cost < b.cost; });
  const auto allowed =
      std::find_if(choices.begin(), choices.end(), [&](const Choice& choice) {
        return !scene.is_allowed || scene.is_allowed(Steer(choice.motion, 0.0));
      });
  const Choice& best = allowed == choices.end() ? choices.front() : *allowed;
  last_heading_ = best.motion.heading;
  EvasionResult result;
  result.contact_time = best.contact_time;
  result.command = Steer(best.motion, 0.0);
  result.direction = best.motion.speed < 0.0
                         ? NormalizeAngle(best.motion.heading + kPi)
                         : best.motion.heading;
  return result;
}

}  // namespace vfh_astar
