#include "vfh_astar/control/safety_limiter.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

namespace vfh_astar {
namespace {

/// m that no point of the footprint moves between two poses that are checked.
constexpr double kSweepStep = 0.02;

constexpr double kShownStep = 0.1;  ///< m likewise, for people.

/// A sweep that would need more, of some hundred metres, is beyond any robot.
constexpr double kMostSteps = 1e4;

/// m by which a point within the margin may come nearer through rounding.
constexpr double kTolerance = 1e-4;

constexpr double kMoverStep = 0.05;  ///< s between two checks at most.
constexpr double kSlowest = 0.1;     ///< m/s, so that a step is finite.

/// m/s below which driving on is not worth giving up a turn for.
constexpr double kCreep = 0.02;

struct Obstacle {
  Eigen::Vector2d point;
  double distance;  ///< m from the footprint at the start.
  double required;  ///< m to keep from it.
};

/// A motion in steps.
class Sweep {
 public:
  Sweep(const Twist2D& command, double duration, int steps)
      : command_(command), duration_(duration), robot_from_start_(steps) {}

  std::size_t size() const { return robot_from_start_.size(); }

  /// @param[in] step from 1 to size().
  const PointTransform& RobotFromStart(std::size_t step) {
    std::optional<PointTransform>& transform = robot_from_start_[step - 1];
    if (!transform) {
      transform = PointTransform::Into(Integrate(
          Pose2D(), command_,
          duration_ * static_cast<double>(step) / static_cast<double>(size())));
    }
    return *transform;
  }

 private:
  Twist2D command_;
  double duration_;
  std::vector<std::optional<PointTransform>> robot_from_start_;  ///< if needed.
};

/// @param[in] stride m that no point of the footprint exceeds in a step.
bool KeepsClear(const Footprint& footprint, const Obstacle& obstacle,
                double stride, Sweep* sweep) {
  // What is further away than it must be needs no look until the steps between
  // could have used that up.
  const auto until_look = [&](double distance) {
    const double spare = (distance - obstacle.required) / stride;
    return static_cast<std::size_t>(
        std::clamp(spare, 1.0, static_cast<double>(sweep->size() + 1)));
  };
  for (std::size_t step = until_look(obstacle.distance);
       step <= sweep->size();) {
    const double distance =
        footprint.SignedDistance(sweep->RobotFromStart(step) * obstacle.point);
    if (distance < obstacle.required) return false;
    step += until_look(distance);
  }
  return true;
}

}  // namespace

void SafetyLimiterParameters::Read(ParameterReader& reader) {
  reader.Number("margin", margin, 0.0, 1.0);
  reader.Number("reaction_time", reaction_time, 0.0, 2.0);
  reader.Number("deceleration", deceleration, 0.05, 50.0);
  reader.Number("angular_deceleration", angular_deceleration, 0.05, 100.0);
  reader.Number("scan_timeout", scan_timeout, 0.01, 5.0);
  reader.Number("swerve", swerve, 0.0, 2.0);
  reader.Number("surprise", surprise, 0.0, 2.0);
  reader.Number("hard_deceleration", hard_deceleration, 0.05, 50.0);
}

SafetyLimiter::SafetyLimiter(const SafetyLimiterParameters& parameters,
                             const Footprint& footprint)
    : parameters_(parameters), footprint_(footprint) {}

double SafetyLimiter::ArcTime(const Twist2D& command, double hold) const {
  const double braking_time =
      std::max(std::abs(command.v) / parameters_.deceleration,
               std::abs(command.w) / parameters_.angular_deceleration);
  // Speed falls to 0 along the same arc, so braking covers half its time's arc.
  return hold + 0.5 * braking_time;
}

std::vector<Pose2D> SafetyLimiter::StoppingMotion(
    const Twist2D& command) const {
  const double duration = ArcTime(command, parameters_.reaction_time);
  const double travel =
      duration * (std::abs(command.v) +
                  std::abs(command.w) * footprint_.CircumscribedRadius());
  const int steps = static_cast<int>(std::ceil(travel / kShownStep));
  std::vector<Pose2D> motion = {Pose2D()};
  for (int step = 1; step <= steps; ++step) {
    motion.push_back(Integrate(Pose2D(), command, duration * step / steps));
  }
  return motion;
}

bool SafetyLimiter::CanStop(
    const Twist2D& command, double hold,
    const std::vector<Eigen::Vector2d>& obstacles) const {
  const double duration = ArcTime(command, hold);
  const double circumscribed = footprint_.CircumscribedRadius();
  const double reach = std::abs(command.v) * duration + circumscribed +
                       parameters_.margin + kSweepStep;
  const double travel =
      (std::abs(command.v) + std::abs(command.w) * circumscribed) * duration;
  std::vector<Obstacle> near;
  for (const Eigen::Vector2d& point : obstacles) {
    if (point.squaredNorm() > reach * reach) continue;
    const double distance = footprint_.SignedDistance(point);
    // No point of the footprint moves by more than the travel.
    if (distance > travel + parameters_.margin) continue;
    near.push_back(
        {point, distance, std::min(parameters_.margin, distance) - kTolerance});
  }
  const double least_steps = std::ceil(travel / kSweepStep);
  if (near.empty() || least_steps == 0.0) return true;
  if (!(least_steps <= kMostSteps)) return false;
  Sweep sweep(command, duration, static_cast<int>(least_steps));
  // Rounding must not let a step pass for shorter than it is.
  const double stride = (1.0 + 1e-9) * travel / least_steps;
  return std::all_of(near.begin(), near.end(), [&](const Obstacle& obstacle) {
    return KeepsClear(footprint_, obstacle, stride, &sweep);
  });
}

bool SafetyLimiter::CanStopBefore(
    const Twist2D& command, double hold,
    const std::vector<MovingObstacle>& movers) const {
  const double braking =
      std::max(std::abs(command.v) / parameters_.deceleration,
               std::abs(command.w) / parameters_.angular_deceleration);
  if (braking == 0.0) return true;
  const double duration = hold + braking;
  const double reach = footprint_.CircumscribedRadius() + parameters_.margin +
                       std::abs(command.v) * duration;
  for (const MovingObstacle& mover : movers) {
    const double speed = mover.velocity.norm();
    if (mover.position.norm() - mover.radius >
        reach + (1.0 + parameters_.swerve) * speed * duration) {
      continue;
    }
    if (!IsReadyForTurn(command, hold, mover)) return false;
    const double step = std::min(
        kMoverStep, kSweepStep / (speed + std::abs(command.v) + kSlowest));
    for (double time = step; time < duration + step; time += step) {
      const double left = std::max(0.0, std::min(time, duration) - hold);
      const double driven =
          std::min(time, hold) + left - 0.5 * left * left / braking;
      const double radius = mover.radius + parameters_.swerve * speed * time;
      const Eigen::Vector2d centre = mover.At(time);
      const double standing = footprint_.SignedDistance(centre) - radius;
      const Pose2D pose = Integrate(Pose2D(), command, driven);
      const double distance =
          footprint_.SignedDistance(PointTransform::Into(pose) * centre) -
          radius;
      if (distance < std::min(parameters_.margin, standing) - kTolerance ||
          distance < -parameters_.swerve * speed * time) {
        return false;
      }
    }
  }
  return true;
}

bool SafetyLimiter::IsReadyForTurn(const Twist2D& command, double hold,
                                   const MovingObstacle& mover) const {
  if (parameters_.surprise == 0.0 || std::abs(command.v) < kCreep) return true;
  const double braking = std::abs(command.v) / parameters_.hard_deceleration;
  const double duration = hold + braking;
  const Pose2D end = Integrate(Pose2D(), command, hold + 0.5 * braking);
  const double distance =
      footprint_.SignedDistance(PointTransform::Into(end) * mover.position);
  return distance >
         mover.radius + parameters_.surprise * mover.velocity.norm() * duration;
}

double SafetyLimiter::Reach(const Twist2D& fastest) const {
  // Turning, too, can take long to brake.
  const double braking = std::max(fastest.v / parameters_.deceleration,
                                  fastest.w / parameters_.angular_deceleration);
  return fastest.v * (parameters_.reaction_time + 0.5 * braking) +
         footprint_.CircumscribedRadius() + parameters_.margin + kSweepStep;
}

bool SafetyLimiter::IsSafe(const Twist2D& command,
                           const std::vector<Eigen::Vector2d>& obstacles,
                           const std::vector<MovingObstacle>& movers) const {
  return CanStopBefore(command, parameters_.reaction_time, movers) &&
         CanStop(command, parameters_.reaction_time, obstacles);
}

Twist2D SafetyLimiter::ScaleDown(
    const Twist2D& command, const std::vector<Eigen::Vector2d>& obstacles,
    const std::vector<MovingObstacle>& movers) const {
  double safe = 0.0;
  double unsafe = 1.0;
  for (int halving = 0; halving < 8; ++halving) {
    const double scale = 0.5 * (safe + unsafe);
    const Twist2D slower{scale * command.v, scale * command.w};
    (IsSafe(slower, obstacles, movers) ? safe : unsafe) = scale;
  }
  return {safe * command.v, safe * command.w};
}

LimitedCommand SafetyLimiter::Limit(
    const Twist2D& command, const Twist2D& twist,
    const std::vector<Eigen::Vector2d>& obstacles,
    const std::vector<MovingObstacle>& movers) const {
  if (!command.IsFinite() || !twist.IsFinite()) return {{0.0, 0.0}, true};
  if (!CanStop(twist, 0.0, obstacles)) return {{0.0, 0.0}, true};
  if (IsSafe(command, obstacles, movers)) return {command, false};
  const Twist2D scaled = ScaleDown(command, obstacles, movers);
  if (std::abs(scaled.v) >= kCreep || command.v == 0.0) return {scaled, true};
  const Twist2D turn{0.0, command.w};
  if (IsSafe(turn, obstacles, movers)) return {turn, true};
  return {ScaleDown(turn, obstacles, movers), true};
}

}  // namespace vfh_astar
