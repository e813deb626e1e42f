#include "vfh_astar/trajectory/polyline.h"

#include <gtest/gtest.h>

namespace vfh_astar {
namespace {

TEST(Polyline, LengthAndSplitByHand) {
  const Polyline line = {{0, 0}, {3, 4}, {3, 6}};
  EXPECT_DOUBLE_EQ(Length(line), 7.0);
  const SplitLine parts = SplitAt(line, 5.5);
  EXPECT_DOUBLE_EQ(Length(parts.before), 5.5);
  EXPECT_DOUBLE_EQ(Length(parts.after), 1.5);
  EXPECT_EQ(parts.before.back(), Eigen::Vector2d(3, 4.5));
  EXPECT_EQ(parts.after.front(), Eigen::Vector2d(3, 4.5));
  EXPECT_EQ(SplitAt(line, 99.0).before.back(), line.back());
  EXPECT_EQ(SplitAt(line, 0.0).after.front(), line.front());
}

TEST(Polyline, ResamplesAtEqualDistances) {
  const Polyline points = Resample({{0, 0}, {1, 0}, {1, 0.5}}, 7);
  ASSERT_EQ(points.size(), 7u);
  EXPECT_NEAR((points[3] - Eigen::Vector2d(0.75, 0)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((points[5] - Eigen::Vector2d(1, 0.25)).norm(), 0.0, 1e-12);
  EXPECT_EQ(points.front(), Eigen::Vector2d(0, 0));
  EXPECT_EQ(points.back(), Eigen::Vector2d(1, 0.5));
}

TEST(Polyline, Directions) {
  const Polyline line = {{0, 0}, {1, 1}, {0, 1}};
  EXPECT_DOUBLE_EQ(FirstDirection(line), kPi / 4);
  EXPECT_DOUBLE_EQ(LastDirection(line), kPi);
}

TEST(Polyline, JoinsAPathFromBesideIt) {
  const Polyline path = {{0, 0}, {1, 0}, {2, 0}, {3, 0}};
  EXPECT_DOUBLE_EQ(NearestPlace(path, {2.1, 5}), 2.0);
  const Polyline from = PathFrom({1.1, 1}, path);
  ASSERT_EQ(from.size(), 4u);
  EXPECT_EQ(from[0], Eigen::Vector2d(1.1, 1));
  EXPECT_EQ(from[1], Eigen::Vector2d(1, 0));
  const Polyline to = PathTo({1.9, 1}, path);
  ASSERT_EQ(to.size(), 3u);
  EXPECT_EQ(to[1], Eigen::Vector2d(1, 0));
  EXPECT_EQ(to[2], Eigen::Vector2d(1.9, 1));
}

TEST(Polyline, ArcsByHand) {
  // A quarter of a circle of 1 m, to the left.
  const Polyline forward = Points({kPi / 2, 1.0, 1.0, false}, {0, 0, 0});
  EXPECT_NEAR((forward.back() - Eigen::Vector2d(1, 1)).norm(), 0.0, 1e-12);
  // In reverse, turning to the left, the tail swings to the right.
  const Polyline reverse = Points({kPi / 2, 1.0, 1.0, true}, {0, 0, 0});
  EXPECT_NEAR((reverse.back() - Eigen::Vector2d(-1, -1)).norm(), 0.0, 1e-12);
}

TEST(Polyline, ClothoidTurnsByItsMeanCurvature) {
  const ArcShape clothoid = {2.0, 0.5, 1.5, false};
  EXPECT_DOUBLE_EQ(clothoid.turn(), 2.0);
  // Against small steps.
  Pose2D pose(1, 2, 0.3);
  for (int i = 0; i < 20000; ++i) {
    pose = Integrate(pose, {1.0, 0.5 + (i + 0.5) / 20000.0}, 1e-4);
  }
  const Eigen::Vector2d end = Points(clothoid, {1, 2, 0.3}).back();
  EXPECT_NEAR((end - pose.position()).norm(), 0.0, 2e-3);
}

}  // namespace
}  // namespace vfh_astar
