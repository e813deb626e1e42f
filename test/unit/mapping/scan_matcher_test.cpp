#include "vfh_astar/mapping/scan_matcher.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "mapping/building.h"

namespace vfh_astar {
namespace {

PoseBelief Belief(const Pose2D& mean, double linear, double angular) {
  PoseBelief belief;
  belief.mean = mean;
  belief.information.diagonal() << 1.0 / (linear * linear),
      1.0 / (linear * linear), 1.0 / (angular * angular);
  return belief;
}

TEST(ScanMatcher, FindsKnownOffsetsInARoom) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> shift(-0.4, 0.4);
  std::uniform_real_distribution<double> turn(-0.3, 0.3);
  const Building room = Room();
  const ScanMatcher matcher{ScanMatcherParameters()};
  HitField field = matcher.MakeField();
  for (const double heading : {0.0, 0.5 * kPi, kPi, -0.5 * kPi}) {
    const Pose2D pose(0.0, 0.0, heading);
    field.Add(matcher.Shape(Look(room, pose, 0.01, random), {}).walls, pose);
  }
  for (int trial = 0; trial < 30; ++trial) {
    const Pose2D truth(shift(random), shift(random), 10.0 * turn(random));
    const auto points =
        matcher.Shape(Look(room, truth, 0.01, random), {}).probes;
    const PoseBelief prior =
        Belief({truth.x + shift(random), truth.y + shift(random),
                truth.theta + turn(random)},
               0.5, 0.5);
    const Pose2D coarse = matcher.FindCoarse(field, points, prior);
    const Pose2D found =
        matcher.Align(field, points, coarse, prior).belief.mean;
    EXPECT_NEAR(found.x, truth.x, 0.02);
    EXPECT_NEAR(found.y, truth.y, 0.02);
    EXPECT_NEAR(NormalizeAngle(found.theta - truth.theta), 0.0, 0.015);
  }
}

TEST(ScanMatcher, AlongAFeaturelessCorridorOdometryDecides) {
  std::mt19937 random(2);
  const Building corridor = {{{-90, -1}, {90, -1}}, {{-90, 1}, {90, 1}}};
  const ScanMatcher matcher{ScanMatcherParameters()};
  HitField field = matcher.MakeField();
  for (double x = -3.0; x < 3.0; x += 0.37) {
    const Pose2D pose(x, 0.0, 0.0);
    field.Add(matcher.Shape(Look(corridor, pose, 0.01, random), {}).walls,
              pose);
  }
  const auto points =
      matcher.Shape(Look(corridor, Pose2D(), 0.01, random), {}).probes;
  const PoseBelief prior = Belief({0.3, 0.2, 0.05}, 0.3, 0.3);
  const Alignment alignment = matcher.Align(
      field, points, matcher.FindCoarse(field, points, prior), prior);
  EXPECT_NEAR(alignment.belief.mean.x, 0.3, 0.1);
  EXPECT_NEAR(alignment.belief.mean.y, 0.0, 0.02);
  EXPECT_NEAR(alignment.belief.mean.theta, 0.0, 0.005);
}

TEST(ScanMatcher, AScanThatSeesNothingStaysWithOdometry) {
  const ScanMatcher matcher{ScanMatcherParameters()};
  const PoseBelief prior = Belief({1.0, 2.0, 0.5}, 0.1, 0.1);
  const HitField field = matcher.MakeField();
  const Pose2D found = matcher.Align(field, {}, prior.mean, prior).belief.mean;
  EXPECT_EQ(found.x, 1.0);
  EXPECT_EQ(found.y, 2.0);
  EXPECT_EQ(found.theta, 0.5);
}

TEST(ScanMatcher, PointsAreThinnedAndCutOff) {
  ScanMatcherParameters parameters;
  parameters.max_range = 5.0;
  parameters.point_spacing = 0.5;
  const ScanMatcher matcher(parameters);
  LaserScan scan;
  scan.angle_increment = 0.01;
  scan.range_max = 50.0;
  scan.ranges.assign(101, 2.0f);
  scan.ranges[100] = 6.0f;
  // An arc of 2 m in pieces of 0.5 m.
  const auto points = matcher.Shape(scan, {1.0, 0.0, 0.0}).probes;
  ASSERT_EQ(points.size(), 4u);
  EXPECT_NEAR(points[0].x(), 3.0, 1e-6);
}

TEST(ScanMatcher, WallsAreFilledBetweenHitsOnOneSurfaceOnly) {
  const ScanMatcher matcher{ScanMatcherParameters()};
  LaserScan scan;
  scan.angle_min = -0.3;
  scan.angle_increment = 0.1;
  scan.range_max = 10.0;
  // A wall at x = 4 m with hits 0.4 m apart, then an edge 2 m behind it.
  for (int i = 0; i < 5; ++i) {
    scan.ranges.push_back(static_cast<float>(4.0 / std::cos(scan.Angle(i))));
  }
  for (int i = 5; i < 8; ++i) {
    scan.ranges.push_back(static_cast<float>(6.0 / std::cos(scan.Angle(i))));
  }
  const auto walls = matcher.Shape(scan, {}).walls;
  for (std::size_t i = 1; i < walls.size(); ++i) {
    const bool is_edge = walls[i - 1].x() < 5.0 && walls[i].x() > 5.0;
    const double gap = (walls[i] - walls[i - 1]).norm();
    EXPECT_TRUE(is_edge ? gap > 1.9 : gap < 0.08) << i << ": " << gap;
    EXPECT_TRUE(std::abs(walls[i].x() - 4.0) < 1e-3 ||
                std::abs(walls[i].x() - 6.0) < 1e-3);
  }
}

}  // namespace
}  // namespace vfh_astar
