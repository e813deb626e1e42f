#include "vfh_astar/mapping/scan_alignment.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace vfh_astar {
namespace {

constexpr int kMostSteps = 12;
constexpr double kShortestStep = 2e-4;  // m or rad; ends the climb
constexpr double kLongestStep = 0.1;    // m or rad

/// The points' part of the utility and its first two derivatives.
struct Slope {
  double sum = 0.0;
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
  Eigen::Matrix3d curvature = Eigen::Matrix3d::Zero();
};

Slope MeasureSlope(const HitField& field,
                   const std::vector<Eigen::Vector2d>& points,
                   const Pose2D& pose, double sigma) {
  Slope slope;
  const double c = std::cos(pose.theta);
  const double s = std::sin(pose.theta);
  // Values next to 1 say little of their distance in a field of bytes.
  constexpr double kLeastDrop = 0.05;
  double xx = 0, xy = 0, xt = 0, yy = 0, yt = 0, tt = 0;
  for (const Eigen::Vector2d& point : points) {
    const double rx = c * point.x() - s * point.y();
    const double ry = s * point.x() + c * point.y();
    const HitField::Sample sample = field.At({pose.x + rx, pose.y + ry});
    if (sample.value <= 0.0) continue;
    slope.sum += sample.value;
    const double gx = sample.slope.x();
    const double gy = sample.slope.y();
    const double gt = gy * rx - gx * ry;
    slope.gradient += Eigen::Vector3d(gx, gy, gt);
    // The curvature at the top of a Gaussian, found from value and slope on its
    // flank: f'^2 / (2 (1 - f)) comes to 1 / sigma^2 there. Nowhere more.
    const double steepness = gx * gx + gy * gy;
    if (steepness <= 0.0) continue;
    const double weight = std::min(0.5 / (1.0 - sample.value + kLeastDrop),
                                   1.0 / (sigma * sigma * steepness));
    xx += weight * gx * gx;
    xy += weight * gx * gy;
    xt += weight * gx * gt;
    yy += weight * gy * gy;
    yt += weight * gy * gt;
    tt += weight * gt * gt;
  }
  slope.curvature << xx, xy, xt, xy, yy, yt, xt, yt, tt;
  return slope;
}

Eigen::Vector3d Difference(const Pose2D& from, const Pose2D& to) {
  return {to.x - from.x, to.y - from.y, NormalizeAngle(to.theta - from.theta)};
}

}  // namespace

Alignment AlignScan(const HitField& field,
                    const std::vector<Eigen::Vector2d>& points,
                    const Pose2D& start, const PoseBelief& prior,
                    double point_weight, double sigma) {
  const auto utility = [&](const Slope& slope, const Pose2D& pose) {
    const Eigen::Vector3d off = Difference(prior.mean, pose);
    return point_weight * slope.sum - 0.5 * off.dot(prior.information * off);
  };
  Pose2D pose = start;
  Slope slope = MeasureSlope(field, points, pose, sigma);
  double best = utility(slope, pose);
  double damping = 1.0;
  // Keeps the step finite where nothing holds a direction.
  const Eigen::Matrix3d floor = Eigen::Matrix3d::Identity();
  for (int i = 0; i < kMostSteps; ++i) {
    const Eigen::Matrix3d curvature =
        point_weight * slope.curvature + prior.information + floor;
    const Eigen::Vector3d gradient =
        point_weight * slope.gradient -
        prior.information * Difference(prior.mean, pose);
    Eigen::Vector3d step = damping * curvature.ldlt().solve(gradient);
    const double largest = step.cwiseAbs().maxCoeff();
    if (largest < kShortestStep) break;
    if (largest > kLongestStep) step *= kLongestStep / largest;
    const Pose2D next(pose.x + step.x(), pose.y + step.y(),
                      NormalizeAngle(pose.theta + step.z()));
    const Slope next_slope = MeasureSlope(field, points, next, sigma);
    const double next_utility = utility(next_slope, next);
    if (next_utility <= best) {
      damping *= 0.4;
      continue;
    }
    pose = next;
    slope = next_slope;
    best = next_utility;
    damping = std::min(1.0, 2.0 * damping);
  }
  Alignment alignment;
  alignment.scan_information = point_weight * slope.curvature;
  alignment.belief = {pose, alignment.scan_information + prior.information};
  alignment.fit = points.empty() ? 0.0 : slope.sum / points.size();
  alignment.utility = best;
  return alignment;
}

}  // namespace vfh_astar
