#include "benchmark/figure_eight.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "vfh_astar/grid/clearance.h"
#include "vfh_astar/trajectory/pose_check.h"
#include "vfh_astar/trajectory/timing.h"

namespace vfh_astar {
namespace {

constexpr double kLateralAcceleration = 1.5;  // m/s^2
constexpr int kPoints = 400;

/// The half width `a` of the curve, m.
double HalfWidth(double speed, const RobotLimits& limits) {
  return 3.0 * speed * speed /
         std::min(kLateralAcceleration, limits.max_lateral_acceleration);
}

/// Backwards in t from the crossing at t = pi/2: to the right and up first.
std::vector<CurvePoint> Lap(double a) {
  std::vector<CurvePoint> points;
  const double dt = 2.0 * kPi / kPoints;
  for (int i = 0; i <= kPoints; ++i) {
    const double t = 0.5 * kPi - i * dt;
    const double s = std::sin(t);
    const double c = std::cos(t);
    const double d = 1.0 + s * s;
    CurvePoint point;
    point.position = a * c / d * Eigen::Vector2d(1.0, s);
    // dx/dt = -a s (3 - s^2) / d^2, dy/dt = a (1 - 3 s^2) / d^2; t falls.
    point.heading = std::atan2(-(1.0 - 3.0 * s * s), s * (2.0 + c * c));
    // |r'| = a / sqrt(d); kappa = 3 c / (a sqrt(d)) where t rises.
    point.curvature = -3.0 * c / (a * std::sqrt(d));
    const double curvature_by_t =
        3.0 * s / (a * std::sqrt(d)) * (1.0 + c * c / d);
    point.curvature_rate = -curvature_by_t * std::sqrt(d) / a;
    if (i > 0) {
      // Simpson's rule for the length since the point before.
      const auto rate = [a](double at) {
        const double sine = std::sin(at);
        return a / std::sqrt(1.0 + sine * sine);
      };
      point.length =
          dt / 6.0 * (rate(t) + 4.0 * rate(t + 0.5 * dt) + rate(t + dt));
    }
    point.knot = i;
    points.push_back(point);
  }
  return points;
}

}  // namespace

Pose2D FigureEightStart() {
  const CurvePoint start = Lap(1.0).front();
  return {start.position, start.heading};
}

Trajectory FigureEight(double speed, RobotLimits limits) {
  limits.max_v = speed;
  const std::vector<CurvePoint> points = Lap(HalfWidth(speed, limits));
  const ClearanceMap nothing(100, 1.0);
  const PoseCheck check(Footprint(), nothing, 0.0, FigureEightStart());
  TimedPieces timed = TimeDrive(points, false, {}, limits, RoomSpeed(), check);
  return Trajectory(std::move(timed.pieces));
}

}  // namespace vfh_astar
