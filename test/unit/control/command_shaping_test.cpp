#include "vfh_astar/control/command_shaping.h"

#include <gtest/gtest.h>

namespace vfh_astar {
namespace {

RobotLimits Limits() {
  RobotLimits limits;
  limits.max_v = 2.0;
  limits.max_v_reverse = 0.5;
  limits.max_w = 3.0;
  limits.max_lateral_acceleration = 2.0;
  limits.max_acceleration = 1.0;
  limits.max_deceleration = 4.0;
  limits.max_angular_acceleration = 5.0;
  return limits;
}

TEST(LimitSpeedTest, LeavesAloneWhatIsWithin) {
  const Twist2D command = LimitSpeed({1.0, 1.0}, Limits());
  EXPECT_DOUBLE_EQ(command.v, 1.0);
  EXPECT_DOUBLE_EQ(command.w, 1.0);
}

TEST(LimitSpeedTest, KeepsTheCurvature) {
  const Twist2D fast = LimitSpeed({4.0, 0.5}, Limits());
  EXPECT_DOUBLE_EQ(fast.v, 2.0);
  EXPECT_DOUBLE_EQ(fast.w, 0.25);
  const Twist2D turning = LimitSpeed({0.1, 6.0}, Limits());
  EXPECT_DOUBLE_EQ(turning.v, 0.05);
  EXPECT_DOUBLE_EQ(turning.w, 3.0);
  const Twist2D reverse = LimitSpeed({-1.0, 0.4}, Limits());
  EXPECT_DOUBLE_EQ(reverse.v, -0.5);
  EXPECT_DOUBLE_EQ(reverse.w, 0.2);
}

TEST(LimitSpeedTest, LateralAcceleration) {
  // v * w = 4 is twice what is allowed: both shrink by sqrt(2).
  const Twist2D command = LimitSpeed({2.0, 2.0}, Limits());
  EXPECT_NEAR(command.v * command.w, 2.0, 1e-12);
  EXPECT_NEAR(command.v, command.w, 1e-12);
}

TEST(LimitSpeedTest, TheFasterSidesWheels) {
  RobotLimits limits = Limits();
  limits.max_wheel_speed = 1.5;
  limits.wheel_separation = 0.5;
  limits.max_w = 10.0;
  limits.max_lateral_acceleration = 10.0;
  // 1 + 0.25 * 4 = 2 m/s on the outer side, where 1.5 is allowed.
  for (const double side : {-1.0, 1.0}) {
    const Twist2D command = LimitSpeed({1.0, 4.0 * side}, limits);
    EXPECT_DOUBLE_EQ(command.v, 0.75);
    EXPECT_DOUBLE_EQ(command.w, 3.0 * side);
  }
}

TEST(LimitAccelerationTest, SpeedsUpSlowlyAndBrakesFast) {
  EXPECT_DOUBLE_EQ(LimitAcceleration({2, 0}, {0, 0}, Limits(), 0.1).v, 0.1);
  EXPECT_DOUBLE_EQ(LimitAcceleration({0, 0}, {2, 0}, Limits(), 0.1).v, 1.6);
  EXPECT_DOUBLE_EQ(LimitAcceleration({-2, 0}, {0, 0}, Limits(), 0.1).v, -0.1);
  EXPECT_DOUBLE_EQ(LimitAcceleration({0, 0}, {-2, 0}, Limits(), 0.1).v, -1.6);
  EXPECT_DOUBLE_EQ(LimitAcceleration({0, 3}, {0, 0}, Limits(), 0.1).w, 0.5);
}

}  // namespace
}  // namespace vfh_astar
