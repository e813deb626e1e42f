#include "vfh_astar/mapping/odometry_guard.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vfh_astar {
namespace {

void ExpectPose(const Pose2D& pose, const Pose2D& expected) {
  EXPECT_NEAR(pose.x, expected.x, 1e-9);
  EXPECT_NEAR(pose.y, expected.y, 1e-9);
  EXPECT_NEAR(NormalizeAngle(pose.theta - expected.theta), 0.0, 1e-9);
}

TEST(OdometryGuard, TheFirstIsAsItCame) {
  OdometryGuard guard;
  ExpectPose(guard.Add(7.0, {100.0, -50.0, 2.0}), {100.0, -50.0, 2.0});
  EXPECT_EQ(guard.jumps(), 0);
}

TEST(OdometryGuard, KeepsWhatARobotDoes) {
  OdometryGuard guard;
  Pose2D odometry(1.0, 2.0, 3.0);
  for (int i = 0; i < 200; ++i) {
    ExpectPose(guard.Add(0.05 * i, odometry), odometry);
    odometry = Integrate(odometry, {2.0, 4.0}, 0.05);
  }
  EXPECT_EQ(guard.jumps(), 0);
}

TEST(OdometryGuard, LeavesOutAJumpAndGoesOn) {
  OdometryGuard guard;
  guard.Add(0.0, {0.0, 0.0, 0.0});
  guard.Add(0.1, {0.1, 0.0, 0.0});
  // The driver begins anew, in another heading.
  ExpectPose(guard.Add(0.2, {5.0, 5.0, 0.5 * kPi}), {0.1, 0.0, 0.0});
  EXPECT_EQ(guard.jumps(), 1);
  ExpectPose(guard.Add(0.3, {5.0, 5.2, 0.5 * kPi}), {0.3, 0.0, 0.0});
  ExpectPose(guard.Add(0.4, {4.9, 5.2, 0.5 * kPi}), {0.3, 0.1, 0.0});
  EXPECT_EQ(guard.jumps(), 1);
}

TEST(OdometryGuard, LeavesOutATurnThatNobodyMakes) {
  OdometryGuard guard;
  guard.Add(0.0, {1.0, 1.0, 3.0});
  ExpectPose(guard.Add(0.05, {1.0, 1.0, -3.0}), {1.0, 1.0, -3.0});
  EXPECT_EQ(guard.jumps(), 0);
  ExpectPose(guard.Add(0.1, {1.0, 1.0, 0.0}), {1.0, 1.0, -3.0});
  EXPECT_EQ(guard.jumps(), 1);
}

TEST(OdometryGuard, WhatIsMuchAtOnceIsLittleAfterAGap) {
  OdometryGuard guard;
  guard.Add(0.0, {0.0, 0.0, 0.0});
  ExpectPose(guard.Add(3.0, {6.0, 0.0, 2.0}), {6.0, 0.0, 2.0});
  EXPECT_EQ(guard.jumps(), 0);
  ExpectPose(guard.Add(3.05, {12.0, 0.0, 2.0}), {6.0, 0.0, 2.0});
  EXPECT_EQ(guard.jumps(), 1);
}

}  // namespace
}  // namespace vfh_astar
