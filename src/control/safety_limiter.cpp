#include "vfh_astar/control/safety_limiter.h"

#include <algorithm>
#include <cmath>

namespace vfh_astar {
namespace {

/// m that no point of the footprint moves between two poses that are checked.
constexpr double kSweepStep = 0.02;

/// A sweep that would need more, of some hundred metres, is beyond any robot.
constexpr double kMostSteps = 1e4;

/// m by which a point within the margin may come nearer through rounding.
constexpr double kTolerance = 1e-4;

/// m/s below which driving on is not worth giving up a turn for.
constexpr double kCreep = 0.02;

struct Obstacle {
  Eigen::Vector2d point;
  double required;  ///< m to keep from it.
};

}  // namespace

void SafetyLimiterParameters::Read(ParameterReader& reader) {
  reader.Number("margin", margin, 0.0, 1.0);
  reader.Number("reaction_time", reaction_time, 0.0, 2.0);
  reader.Number("deceleration", deceleration, 0.05, 50.0);
  reader.Number("angular_deceleration", angular_deceleration, 0.05, 100.0);
  reader.Number("scan_timeout", scan_timeout, 0.01, 5.0);
}

SafetyLimiter::SafetyLimiter(const SafetyLimiterParameters& parameters,
                             const Footprint& footprint)
    : parameters_(parameters), footprint_(footprint) {}

bool SafetyLimiter::CanStop(
    const Twist2D& command, double hold,
    const std::vector<Eigen::Vector2d>& obstacles) const {
  const double braking_time =
      std::max(std::abs(command.v) / parameters_.deceleration,
               std::abs(command.w) / parameters_.angular_deceleration);
  // Speed falls to 0 along the same arc, so braking covers half its time's arc.
  const double duration = hold + 0.5 * braking_time;
  const double circumscribed = footprint_.CircumscribedRadius();
  const double reach = std::abs(command.v) * duration + circumscribed +
                       parameters_.margin + kSweepStep;
  std::vector<Obstacle> near;
  for (const Eigen::Vector2d& point : obstacles) {
    if (point.squaredNorm() > reach * reach) continue;
    const double distance = footprint_.SignedDistance(point);
    near.push_back(
        {point, std::min(parameters_.margin, distance) - kTolerance});
  }
  if (near.empty()) return true;

  const double travel =
      (std::abs(command.v) + std::abs(command.w) * circumscribed) * duration;
  const double least_steps = std::ceil(travel / kSweepStep);
  if (!(least_steps <= kMostSteps)) return false;
  const int steps = static_cast<int>(least_steps);
  for (int step = 1; step <= steps; ++step) {
    const Pose2D pose = Integrate(Pose2D(), command, duration * step / steps);
    const PointTransform robot_from_start(pose.Inverse());
    for (const Obstacle& obstacle : near) {
      const double distance =
          footprint_.SignedDistance(robot_from_start * obstacle.point);
      if (distance < obstacle.required) return false;
    }
  }
  return true;
}

Twist2D SafetyLimiter::ScaleDown(
    const Twist2D& command,
    const std::vector<Eigen::Vector2d>& obstacles) const {
  double safe = 0.0;
  double unsafe = 1.0;
  for (int halving = 0; halving < 8; ++halving) {
    const double scale = 0.5 * (safe + unsafe);
    const Twist2D slower{scale * command.v, scale * command.w};
    (CanStop(slower, parameters_.reaction_time, obstacles) ? safe : unsafe) =
        scale;
  }
  return {safe * command.v, safe * command.w};
}

LimitedCommand SafetyLimiter::Limit(
    const Twist2D& command, const Twist2D& twist,
    const std::vector<Eigen::Vector2d>& obstacles) const {
  if (!command.IsFinite() || !twist.IsFinite()) return {{0.0, 0.0}, true};
  if (!CanStop(twist, 0.0, obstacles)) return {{0.0, 0.0}, true};
  if (CanStop(command, parameters_.reaction_time, obstacles)) {
    return {command, false};
  }
  const Twist2D scaled = ScaleDown(command, obstacles);
  if (std::abs(scaled.v) >= kCreep || command.v == 0.0) return {scaled, true};
  const Twist2D turn{0.0, command.w};
  if (CanStop(turn, parameters_.reaction_time, obstacles)) return {turn, true};
  return {ScaleDown(turn, obstacles), true};
}

}  // namespace vfh_astar
