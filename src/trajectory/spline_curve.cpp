#include "vfh_astar/trajectory/spline_curve.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace vfh_astar {
namespace {

using Weights = Eigen::Matrix<double, 6, 1>;

// Row k: coefficients of tau^0..tau^5 of the basis function of the k-th control
// point of an interval, times 120.
constexpr double kBasis[6][6] = {
    {1, -5, 10, -10, 5, -1},  {26, -50, 20, 20, -20, 5},
    {66, 0, -60, 0, 30, -10}, {26, 50, 20, -20, -20, 10},
    {1, 5, 10, 10, 5, -5},    {0, 0, 0, 0, 0, 1},
};

// Weights of the six control points for the `order`-th derivative at tau.
Weights BasisWeights(double tau, int order) {
  Weights weights = Weights::Zero();
  for (int k = 0; k < 6; ++k) {
    for (int power = 5; power >= order; --power) {
      double factor = 1.0;
      for (int i = 0; i < order; ++i) factor *= power - i;
      weights[k] = weights[k] * tau + factor * kBasis[k][power] / 120.0;
    }
  }
  return weights;
}

Eigen::Vector2d Combine(const Weights& weights, const Eigen::Vector2d* points) {
  Eigen::Vector2d sum = weights[0] * points[0];
  for (int k = 1; k < 6; ++k) sum += weights[k] * points[k];
  return sum;
}

double Cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

CurvePoint DescribePoint(const std::array<Weights, 4>& weights,
                         const Eigen::Vector2d* points) {
  const Eigen::Vector2d first = Combine(weights[1], points);
  const Eigen::Vector2d second = Combine(weights[2], points);
  const Eigen::Vector2d third = Combine(weights[3], points);
  const double squared = std::max(first.squaredNorm(), 1e-18);
  const double speed = std::sqrt(squared);
  const double bend = Cross(first, second);
  CurvePoint point;
  point.position = Combine(weights[0], points);
  point.heading = std::atan2(first.y(), first.x());
  point.curvature = bend / (squared * speed);
  point.curvature_rate =
      (Cross(first, third) - 3.0 * bend * first.dot(second) / squared) /
      (squared * squared);
  return point;
}

std::array<Weights, 4> DerivativeWeights(double tau) {
  return {BasisWeights(tau, 0), BasisWeights(tau, 1), BasisWeights(tau, 2),
          BasisWeights(tau, 3)};
}

// Quadrature of the curve's speed over one part of an interval.
struct LengthRule {
  std::array<Weights, 3> first;
  std::array<double, 3> weight;
};

LengthRule MakeLengthRule(double from, double width) {
  const double offset = std::sqrt(0.6);
  LengthRule rule;
  rule.weight = {width * 5.0 / 18.0, width * 8.0 / 18.0, width * 5.0 / 18.0};
  for (int i = 0; i < 3; ++i) {
    const double tau = from + 0.5 * width * (1.0 + (i - 1) * offset);
    rule.first[i] = BasisWeights(tau, 1);
  }
  return rule;
}

double LengthOf(const LengthRule& rule, const Eigen::Vector2d* points) {
  double length = 0.0;
  for (int i = 0; i < 3; ++i) {
    length += rule.weight[i] * Combine(rule.first[i], points).norm();
  }
  return length;
}

// 1/m between two points of a curve, so that what is interpolated between them
// keeps the limits that they keep and loses little time to them.
constexpr double kMaxCurvatureStep = 0.25;

// How to describe one interval by `count` spans.
class IntervalRule {
 public:
  explicit IntervalRule(int count) {
    const double width = 1.0 / count;
    for (int i = 0; i <= count; ++i) {
      knots_.push_back(i * width);
      weights_.push_back(DerivativeWeights(i * width));
      if (i > 0) lengths_.push_back(MakeLengthRule((i - 1) * width, width));
    }
  }

  // Both ends of the interval, and what lies between.
  std::vector<CurvePoint> Describe(const Eigen::Vector2d* points,
                                   int interval) const {
    std::vector<CurvePoint> described;
    described.reserve(weights_.size());
    for (std::size_t i = 0; i < weights_.size(); ++i) {
      described.push_back(DescribePoint(weights_[i], points));
      described.back().knot = interval + knots_[i];
      if (i > 0) described.back().length = LengthOf(lengths_[i - 1], points);
    }
    return described;
  }

 private:
  std::vector<double> knots_;
  std::vector<std::array<Weights, 4>> weights_;
  std::vector<LengthRule> lengths_;
};

double LargestStep(const std::vector<CurvePoint>& points) {
  double largest = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    largest = std::max(largest,
                       std::abs(points[i].curvature - points[i - 1].curvature));
  }
  return largest;
}

}  // namespace

std::array<Eigen::Vector2d, SplineCurve::kEndPoints> SplineCurve::EndPoints(
    const CurveEnd& end, double spacing) {
  const Eigen::Vector2d tangent(std::cos(end.heading), std::sin(end.heading));
  const Eigen::Vector2d step = spacing * tangent;
  const Eigen::Vector2d bend = end.curvature * spacing * spacing *
                               Eigen::Vector2d(-tangent.y(), tangent.x());
  // Control points on a parabola make the curve that parabola, moved by the
  // basis' variance of 1/2 times half its second difference.
  std::array<Eigen::Vector2d, kEndPoints> points;
  for (int i = -2; i <= 2; ++i) {
    points[i + 2] = end.position - 0.25 * bend + i * step + 0.5 * i * i * bend;
  }
  return points;
}

SplineCurve::SplineCurve(std::vector<Eigen::Vector2d> control_points)
    : points_(std::move(control_points)) {
  assert(points_.size() >= 6);
}

std::vector<CurvePoint> SplineCurve::Sample() const {
  const std::vector<IntervalRule> rules = {IntervalRule(2), IntervalRule(4),
                                           IntervalRule(8)};
  std::vector<CurvePoint> samples;
  samples.reserve(2 * static_cast<std::size_t>(intervals()) + 1);
  double length = 0.0;
  for (int interval = 0; interval < intervals(); ++interval) {
    const Eigen::Vector2d* points = &points_[interval];
    std::vector<CurvePoint> inside;
    for (const IntervalRule& rule : rules) {
      inside = rule.Describe(points, interval);
      if (LargestStep(inside) <= kMaxCurvatureStep) break;
    }
    // The last point of an interval is the first of the next one.
    inside.front().length = length;
    length = inside.back().length;
    samples.insert(
        samples.end(), inside.begin(),
        interval + 1 < intervals() ? inside.end() - 1 : inside.end());
  }
  samples.front().length = 0.0;
  return samples;
}

}  // namespace vfh_astar
