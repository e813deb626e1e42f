#include "vfh_astar/control/tracking_law.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace vfh_astar {
namespace {

TrackingParameters Constant(double k1, double k2, double k3) {
  TrackingParameters parameters;
  parameters.gains = "constant";
  parameters.k1 = k1;
  parameters.k2 = k2;
  parameters.k3 = k3;
  return parameters;
}

TEST(TrackingErrorTest, IsTheReferenceSeenFromTheRobot) {
  // The robot looks along +y; the reference lies 2 m up and 1 m to the right.
  const Eigen::Vector3d error =
      TrackingError(Pose2D(1.0, 1.0, kPi / 2), Pose2D(2.0, 3.0, kPi));
  EXPECT_NEAR(error[0], 2.0, 1e-12);
  EXPECT_NEAR(error[1], -1.0, 1e-12);
  EXPECT_NEAR(error[2], kPi / 2, 1e-12);
}

TEST(TrackingErrorTest, WrapsTheHeading) {
  const Eigen::Vector3d error =
      TrackingError(Pose2D(0, 0, 3.0), Pose2D(0, 0, -3.0));
  EXPECT_NEAR(error[2], 2.0 * kPi - 6.0, 1e-12);
}

TEST(TrackingCommandTest, OnTheReferenceItIsTheFeedForward) {
  for (const char* gains : {"constant", "adaptive"}) {
    TrackingParameters parameters;
    parameters.gains = gains;
    const Twist2D command =
        TrackingCommand(Eigen::Vector3d::Zero(), {1.3, -0.4}, parameters);
    EXPECT_DOUBLE_EQ(command.v, 1.3);
    EXPECT_DOUBLE_EQ(command.w, -0.4);
  }
}

TEST(TrackingCommandTest, EachTermByHand) {
  const TrackingParameters parameters = Constant(2.0, 3.0, 5.0);
  const Twist2D reference{0.5, 0.25};
  // e1 alone: v = 0.5 + 2 * 0.1.
  Twist2D command = TrackingCommand({0.1, 0.0, 0.0}, reference, parameters);
  EXPECT_NEAR(command.v, 0.7, 1e-12);
  EXPECT_NEAR(command.w, 0.25, 1e-12);
  // e2 alone: w = 0.25 + 3 * 0.5 * 1 * 0.2.
  command = TrackingCommand({0.0, 0.2, 0.0}, reference, parameters);
  EXPECT_NEAR(command.v, 0.5, 1e-12);
  EXPECT_NEAR(command.w, 0.55, 1e-12);
  // e3 alone: w = 0.25 + 5 * 0.1.
  command = TrackingCommand({0.0, 0.0, 0.1}, reference, parameters);
  EXPECT_NEAR(command.v, 0.5 * std::cos(0.1), 1e-12);
  EXPECT_NEAR(command.w, 0.75, 1e-12);
  // In reverse e2 turns the other way: w = 0.25 + 3 * -0.5 * 0.2.
  command = TrackingCommand({0.0, 0.2, 0.0}, {-0.5, 0.25}, parameters);
  EXPECT_NEAR(command.w, -0.05, 1e-12);
  // e3 = pi / 2 with e2: v = 0, w = 0.25 + 3 * 0.5 * (2 / pi) * 0.2
  //   + 5 * pi / 2.
  command = TrackingCommand({0.0, 0.2, kPi / 2}, reference, parameters);
  EXPECT_NEAR(command.v, 0.0, 1e-12);
  EXPECT_NEAR(command.w, 0.25 + 0.6 / kPi + 2.5 * kPi, 1e-12);
}

TEST(TrackingCommandTest, TheSeriesNearZeroMeetsTheQuotient) {
  const TrackingParameters parameters = Constant(0.0, 1.0, 0.0);
  for (const double e3 : {0.99e-4, 1.01e-4}) {
    const Twist2D command =
        TrackingCommand({0.0, 1.0, e3}, {1.0, 0.0}, parameters);
    EXPECT_NEAR(command.w, std::sin(e3) / e3, 1e-14);
  }
}

TEST(TrackingCommandTest, AdaptiveGainsByHand) {
  TrackingParameters parameters;
  parameters.damping = 0.5;
  parameters.bandwidth = 4.0;
  parameters.k1 = parameters.k3 = 0.1;
  // sqrt(w^2 + 4 v^2) = 5 for w = 3, v = 2, so k1 = k3 = 5, k2 = 4.
  const Twist2D command =
      TrackingCommand({0.1, 0.0, 0.0}, {2.0, 3.0}, parameters);
  EXPECT_NEAR(command.v, 2.5, 1e-12);
  const Twist2D turned =
      TrackingCommand({0.0, 0.1, 0.0}, {2.0, 3.0}, parameters);
  EXPECT_NEAR(turned.w, 3.0 + 4.0 * 2.0 * 0.1, 1e-12);
  const Twist2D askew =
      TrackingCommand({0.0, 0.0, 0.1}, {2.0, 3.0}, parameters);
  EXPECT_NEAR(askew.v, 2.0 * std::cos(0.1), 1e-12);
  EXPECT_NEAR(askew.w, 3.0 + 5.0 * 0.1, 1e-12);
  // In reverse the gain keeps its sign: 2 * 0.5 * sqrt(4 * 1) = 2.
  const Twist2D reverse =
      TrackingCommand({0.1, 0.0, 0.0}, {-1.0, 0.0}, parameters);
  EXPECT_NEAR(reverse.v, -1.0 + 2.0 * 0.1, 1e-12);
}

TEST(TrackingCommandTest, ConvergesFromRandomErrorsOnACircle) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> offset(-0.4, 0.4);
  std::uniform_real_distribution<double> turn(-1.2, 1.2);
  const Twist2D twist{1.0, 0.5};
  const double period = 0.02;
  for (int run = 0; run < 200; ++run) {
    Pose2D reference;
    Pose2D pose(offset(random), offset(random), turn(random));
    for (int step = 0; step < 500; ++step) {
      const Twist2D command = TrackingCommand(TrackingError(pose, reference),
                                              twist, TrackingParameters());
      pose = Integrate(pose, command, period);
      reference = Integrate(reference, twist, period);
    }
    const Eigen::Vector3d error = TrackingError(pose, reference);
    EXPECT_LT(error.norm(), 0.01) << "run " << run;
  }
}

TEST(TrackingCommandTest, ConvergesInReverse) {
  const Twist2D twist{-0.5, 0.2};
  Pose2D reference;
  Pose2D pose(0.2, -0.2, 0.4);
  for (int step = 0; step < 1000; ++step) {
    const Twist2D command = TrackingCommand(TrackingError(pose, reference),
                                            twist, TrackingParameters());
    pose = Integrate(pose, command, 0.02);
    reference = Integrate(reference, twist, 0.02);
  }
  EXPECT_LT(TrackingError(pose, reference).norm(), 0.01);
}

}  // namespace
}  // namespace vfh_astar
