#include "vfh_astar/geometry.h"

#include <gtest/gtest.h>

#include <random>

namespace vfh_astar {
namespace {

TEST(NormalizeAngleTest, WrapsToTheHalfOpenTurn) {
  EXPECT_EQ(NormalizeAngle(1.25), 1.25);
  EXPECT_EQ(NormalizeAngle(kPi), kPi);
  EXPECT_EQ(NormalizeAngle(-kPi), kPi);
  EXPECT_NEAR(NormalizeAngle(1.5 * kPi), -0.5 * kPi, 1e-12);
  EXPECT_NEAR(NormalizeAngle(-7.5 * kPi), 0.5 * kPi, 1e-12);
}

TEST(PointTransformTest, IntoAPoseIsItsInverse) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> number(-3.0, 3.0);
  for (int run = 0; run < 1000; ++run) {
    const Pose2D pose(number(random), number(random), number(random));
    const Eigen::Vector2d point(number(random), number(random));
    EXPECT_EQ(PointTransform(pose) * point, pose * point);
    EXPECT_EQ(PointTransform::Into(pose) * point, pose.Inverse() * point);
  }
  // A metre to the left of a robot that looks along y.
  const Eigen::Vector2d left =
      PointTransform::Into({2.0, 1.0, 0.5 * kPi}) * Eigen::Vector2d(1.0, 1.0);
  EXPECT_NEAR(left.x(), 0.0, 1e-12);
  EXPECT_NEAR(left.y(), 1.0, 1e-12);
}

}  // namespace
}  // namespace vfh_astar
