#include "vfh_astar/simulation/odometry_filter.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vfh_astar {
namespace {

constexpr double kPeriod = 0.02;

/// Feeds what perfect sensors would say of a motion.
template <typename Motion>
void Feed(OdometryFilter* filter, double seconds, const Motion& motion) {
  for (int i = 1; i * kPeriod <= seconds + 1e-9; ++i) {
    const Twist2D twist = motion(i * kPeriod);
    filter->Predict(kPeriod);
    filter->CorrectWithWheels(twist);
    filter->CorrectWithGyro(twist.w);
  }
}

TEST(OdometryFilterTest, StandsWhereItStarted) {
  OdometryFilter filter;
  Feed(&filter, 10.0, [](double) { return Twist2D(); });
  EXPECT_NEAR(filter.pose().position().norm(), 0.0, 1e-12);
}

TEST(OdometryFilterTest, FollowsACircle) {
  OdometryFilter filter;
  Feed(&filter, kPi, [](double) { return Twist2D{1.0, 1.0}; });
  EXPECT_NEAR(filter.twist().v, 1.0, 1e-3);
  EXPECT_NEAR(filter.twist().w, 1.0, 1e-3);
  // Half of a circle of radius 1, but for the start, where it was thought to
  // stand.
  EXPECT_NEAR(filter.pose().x, 0.0, 0.03);
  EXPECT_NEAR(filter.pose().y, 2.0, 0.03);
}

TEST(OdometryFilterTest, DoesNotLagBehindAChangeOfSpeed) {
  OdometryFilter filter;
  Feed(&filter, 1.0, [](double t) { return Twist2D{2.0 * t, 3.0 * t}; });
  EXPECT_NEAR(filter.pose().theta, 1.5, 0.003) << "half a step would be 0.03";
  OdometryFilter straight;
  Feed(&straight, 1.0, [](double t) { return Twist2D{2.0 * t, 0.0}; });
  EXPECT_NEAR(straight.pose().x, 1.0, 0.003) << "half a step would be 0.02";
}

TEST(OdometryFilterTest, BelievesTheGyroRatherThanTheWheels) {
  OdometryFilter filter;
  for (int i = 0; i < 100; ++i) {
    filter.Predict(kPeriod);
    filter.CorrectWithWheels({1.0, 1.5});
    filter.CorrectWithGyro(1.0);
  }
  EXPECT_NEAR(filter.twist().w, 1.0, 0.01);
}

}  // namespace
}  // namespace vfh_astar
