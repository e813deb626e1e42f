#include "vfh_astar/trajectory/spline_curve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "vfh_astar/geometry.h"
#include "vfh_astar/trajectory/curve_smoother.h"

namespace vfh_astar {
namespace {

TEST(SplineCurve, StraightControlPointsMakeAStraightLine) {
  std::vector<Eigen::Vector2d> points;
  for (int i = -2; i <= 12; ++i) points.emplace_back(0.1 * i, 0.2 * i);
  const std::vector<CurvePoint> samples = SplineCurve(points).Sample();
  ASSERT_EQ(samples.size(), 21u);
  double length = 0.0;
  for (const CurvePoint& sample : samples) {
    length += sample.length;
    EXPECT_NEAR(sample.heading, std::atan2(2.0, 1.0), 1e-12);
    EXPECT_NEAR(sample.curvature, 0.0, 1e-9);
    EXPECT_NEAR(sample.curvature_rate, 0.0, 1e-7);
  }
  EXPECT_EQ(samples.front().length, 0.0);
  EXPECT_NEAR(length, std::hypot(1.0, 2.0), 1e-9);
  EXPECT_NEAR(samples.back().position.x(), 1.0, 1e-12);
}

TEST(SplineCurve, EndPointsFixPositionDirectionAndCurvature) {
  const CurveEnd start{{1.0, 2.0}, 0.7, 1.3};
  const CurveEnd end{{2.1, 2.5}, -0.4, -0.6};
  const auto first = SplineCurve::EndPoints(start, 0.1);
  const auto last = SplineCurve::EndPoints(end, 0.1);
  std::vector<Eigen::Vector2d> points(first.begin(), first.end());
  points.emplace_back(1.6, 2.4);
  points.insert(points.end(), last.begin(), last.end());
  const std::vector<CurvePoint> samples = SplineCurve(points).Sample();
  EXPECT_NEAR((samples.front().position - start.position).norm(), 0.0, 1e-12);
  EXPECT_NEAR(samples.front().heading, 0.7, 1e-12);
  EXPECT_NEAR(samples.front().curvature, 1.3, 1e-9);
  EXPECT_NEAR((samples.back().position - end.position).norm(), 0.0, 1e-12);
  EXPECT_NEAR(samples.back().heading, -0.4, 1e-12);
  EXPECT_NEAR(samples.back().curvature, -0.6, 1e-9);
}

// A curve through wobbling control points.
std::vector<CurvePoint> Wobble(unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<> noise(0.0, 0.004);
  std::vector<Eigen::Vector2d> points;
  for (int i = 0; i < 40; ++i) {
    points.emplace_back(0.1 * i + noise(random), noise(random));
  }
  return SplineCurve(points).Sample();
}

TEST(SplineCurve, HeadingIntegratesCurvature) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const std::vector<CurvePoint> samples = Wobble(seed);
    for (std::size_t i = 1; i < samples.size(); ++i) {
      const CurvePoint& a = samples[i - 1];
      const CurvePoint& b = samples[i];
      // Hermite quadrature of the curvature over the span.
      const double turn =
          0.5 * b.length * (a.curvature + b.curvature) +
          b.length * b.length / 12.0 * (a.curvature_rate - b.curvature_rate);
      EXPECT_NEAR(b.heading - a.heading, turn, 2e-4);
      EXPECT_NEAR((b.position - a.position).norm(), b.length, 2e-3 * b.length);
    }
  }
}

TEST(SplineCurve, SharpBendsGetMorePoints) {
  std::vector<Eigen::Vector2d> points;
  for (int i = -2; i <= 10; ++i) points.emplace_back(0.1 * i, 0.0);
  for (int i = 1; i <= 12; ++i) points.emplace_back(1.0, 0.1 * i);
  const SplineCurve curve(points);
  const std::vector<CurvePoint> samples = curve.Sample();
  EXPECT_GT(samples.size(), 2u * curve.intervals() + 1);
  EXPECT_EQ(samples.front().knot, 0.0);
  EXPECT_EQ(samples.back().knot, curve.intervals());
  for (std::size_t i = 1; i < samples.size(); ++i) {
    EXPECT_GT(samples[i].knot, samples[i - 1].knot);
  }
}

std::vector<Bubble> Zigzag(int count, double radius) {
  std::vector<Bubble> bubbles;
  for (int i = 0; i < count; ++i) {
    bubbles.push_back({{0.1 * i, i % 6 < 3 ? 0.05 : -0.05}, radius});
  }
  return bubbles;
}

TEST(SmoothThroughBubbles, WideBubblesLeaveAStraightLine) {
  const SplineCurve curve = SmoothThroughBubbles(
      {{0.0, 0.0}, 0.0, 0.0}, {{4.0, 0.0}, 0.0, 0.0}, 0.1, Zigzag(41, 0.3));
  for (const CurvePoint& point : curve.Sample()) {
    EXPECT_NEAR(point.position.y(), 0.0, 2e-3);
  }
}

TEST(SmoothThroughBubbles, StaysNearBubbles) {
  // Bubbles on an arc of 90 degrees, 2 m radius.
  for (const double radius : {0.0, 0.02, 0.1}) {
    std::vector<Bubble> bubbles;
    const int n = 31;
    for (int i = 0; i < n; ++i) {
      const double angle = kPi / 2 * i / (n - 1);
      bubbles.push_back(
          {{2.0 * std::sin(angle), 2.0 - 2.0 * std::cos(angle)}, radius});
    }
    const SplineCurve curve =
        SmoothThroughBubbles({{0.0, 0.0}, 0.0, 0.5}, {{2.0, 2.0}, kPi / 2, 0.5},
                             kPi / (n - 1), bubbles);
    for (const CurvePoint& point : curve.Sample()) {
      const double off =
          std::abs((point.position - Eigen::Vector2d(0.0, 2.0)).norm() - 2.0);
      // A control point lies off the curve by a quarter of its spacing's
      // square times the curvature.
      EXPECT_LE(off, radius + 0.004);
    }
  }
}

}  // namespace
}  // namespace vfh_astar
