#include "vfh_astar/navigation/recovery.h"

#include <algorithm>
#include <cmath>

namespace vfh_astar {
namespace {

constexpr double kTrailSpacing = 0.05;  ///< m
constexpr double kTrailLength = 3.0;    ///< m
constexpr double kJump = 0.3;           ///< m
constexpr double kLookBack = 0.2;       ///< m along the trail that is aimed at.
constexpr double kTurnDone = 0.15;      ///< rad
constexpr double kProgress = 1.0;       ///< m after which attempts count anew.

}  // namespace

Recovery::Recovery(const RecoveryParameters& parameters,
                   const Footprint& footprint)
    : parameters_(parameters), footprint_(footprint) {}

void Recovery::Record(const Pose2D& pose) {
  // Whatever carried the robot here, it cannot drive back along a jump.
  if (!trail_.empty() &&
      (trail_.back().position() - pose.position()).norm() > kJump) {
    trail_.clear();
  }
  if (!trail_.empty() &&
      (trail_.back().position() - pose.position()).norm() < kTrailSpacing) {
    return;
  }
  trail_.push_back(pose);
  if (trail_.size() > kTrailLength / kTrailSpacing) trail_.pop_front();
}

bool Recovery::HasLeft(const Pose2D& pose) const {
  return (pose.position() - start_.position()).norm() > kProgress;
}

bool Recovery::HasAttemptLeft(const Pose2D& pose) const {
  return parameters_.max_attempts > 0 &&
         (attempts_ < parameters_.max_attempts || HasLeft(pose));
}

void Recovery::Start(const Observation& observation) {
  if (HasLeft(observation.pose)) attempts_ = 0;
  start_time_ = observation.time;
  start_ = observation.pose;
  const bool can_back_up = trail_.size() > 1;
  manoeuvre_ = attempts_++ % 2 == 0 && can_back_up ? Manoeuvre::kBackUp
                                                   : Manoeuvre::kTurn;
  turn_target_ =
      NormalizeAngle(observation.pose.theta +
                     MostOpenDirection(observation.obstacles, footprint_));
}

std::optional<Twist2D> Recovery::Update(const Observation& observation) {
  if (observation.time - start_time_ > parameters_.max_time)
    return std::nullopt;
  return manoeuvre_ == Manoeuvre::kBackUp ? BackUp(observation)
                                          : Turn(observation);
}

std::optional<Twist2D> Recovery::BackUp(const Observation& observation) {
  const Pose2D& pose = observation.pose;
  const double driven = (pose.position() - start_.position()).norm();
  if (driven >= parameters_.back_up_distance) return std::nullopt;
  while (!trail_.empty() &&
         (trail_.back().position() - pose.position()).norm() < kLookBack) {
    trail_.pop_back();
  }
  if (trail_.empty()) return std::nullopt;

  const Eigen::Vector2d target = pose.Inverse() * trail_.back().position();
  // Only what lies behind can be reached in reverse.
  if (target.x() >= 0.0) return std::nullopt;
  const double curvature = 2.0 * target.y() / target.squaredNorm();
  const Twist2D command{-parameters_.speed, -parameters_.speed * curvature};
  // The laser may not see behind the robot; the map remembers.
  const Pose2D next =
      Integrate(pose, command, 0.5 * kLookBack / parameters_.speed);
  if (observation.map != nullptr &&
      observation.map->IsFree(footprint_, pose, 0.0) &&
      !observation.map->IsFree(footprint_, next, 0.0)) {
    return std::nullopt;
  }
  return command;
}

std::optional<Twist2D> Recovery::Turn(const Observation& observation) const {
  const double remaining =
      NormalizeAngle(turn_target_ - observation.pose.theta);
  if (std::abs(remaining) < kTurnDone) return std::nullopt;
  return Twist2D{0.0, std::copysign(parameters_.turn_speed, remaining)};
}

std::string Recovery::Description() const {
  return manoeuvre_ == Manoeuvre::kBackUp
             ? "backing up along the way it came"
             : "turning towards the most open direction";
}

double MostOpenDirection(const std::vector<Eigen::Vector2d>& obstacles,
                         const Footprint& footprint) {
  constexpr int kDirections = 36;
  constexpr double kFar = 3.0;  // m; beyond this, open is open.
  double best_direction = 0.0;
  double best_distance = -1.0;
  for (int i = 0; i < kDirections; ++i) {
    // 0, 1, -1, 2, -2, ... so that the first of equals is the nearest to ahead.
    const int step = (i % 2 == 0 ? -1 : 1) * ((i + 1) / 2);
    const double direction = NormalizeAngle(step * 2.0 * kPi / kDirections);
    const Pose2D turned(0.0, 0.0, direction);
    double distance = kFar;
    for (const Eigen::Vector2d& point : obstacles) {
      const Eigen::Vector2d seen = turned.Inverse() * point;
      if (seen.x() > 0.0 && std::abs(seen.y()) <= footprint.half_width) {
        distance = std::min(distance, seen.x());
      }
    }
    if (distance > best_distance + 1e-9) {
      best_distance = distance;
      best_direction = direction;
    }
  }
  return best_direction;
}

}  // namespace vfh_astar
