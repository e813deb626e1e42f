#include "vfh_astar/navigation/recovery.h"

#include <gtest/gtest.h>

#include <cmath>

#include "vfh_astar/navigation/arrival.h"
#include "vfh_astar/navigation/progress_monitor.h"

namespace vfh_astar {
namespace {

constexpr double kPeriod = 0.05;

class RecoveryTest : public testing::Test {
 protected:
  RecoveryTest() : recovery_(parameters_, footprint_) {}

  /// Lets the manoeuvre run to its end.
  /// @return s that it took.
  double RunToEnd() {
    const double start = observation_.time;
    while (const auto command = recovery_.Update(observation_)) {
      observation_.pose = Integrate(observation_.pose, *command, kPeriod);
      observation_.time += kPeriod;
    }
    return observation_.time - start;
  }

  RecoveryParameters parameters_;
  Footprint footprint_;
  Recovery recovery_;
  Observation observation_;
};

TEST_F(RecoveryTest, BacksUpAlongTheWayItCame) {
  // A quarter circle of 2 m radius about (0, 2), driven counter-clockwise.
  const auto on_circle = [](double angle) {
    return Pose2D(2.0 * std::sin(angle), 2.0 - 2.0 * std::cos(angle), angle);
  };
  for (double angle = 0.0; angle <= 1.0; angle += 0.01) {
    recovery_.Record(on_circle(angle));
  }
  observation_.pose = on_circle(1.0);
  recovery_.Start(observation_);
  RunToEnd();
  const Eigen::Vector2d from_center =
      observation_.pose.position() - Eigen::Vector2d(0.0, 2.0);
  EXPECT_NEAR(from_center.norm(), 2.0, 0.02) << "stays on its circle";
  EXPECT_NEAR((observation_.pose.position() - on_circle(1.0).position()).norm(),
              parameters_.back_up_distance, 0.02);
}

TEST_F(RecoveryTest, TurnsInsteadWhenItCameFromNowhere) {
  observation_.obstacles = {{0.5, 0.0}};
  recovery_.Start(observation_);
  const auto command = recovery_.Update(observation_);
  ASSERT_TRUE(command.has_value());
  EXPECT_EQ(command->v, 0.0);
  EXPECT_NE(command->w, 0.0);
}

TEST_F(RecoveryTest, TurnsToTheMostOpenDirection) {
  // Walls ahead and to the right; open to the left and behind.
  for (double y = -1.0; y <= 1.0; y += 0.05) {
    observation_.obstacles.emplace_back(0.6, y);
    observation_.obstacles.emplace_back(y, -0.6);
  }
  recovery_.Start(observation_);
  RunToEnd();
  EXPECT_GT(observation_.pose.theta, 1.0);
  EXPECT_LT(observation_.pose.theta, 2.2);
}

TEST_F(RecoveryTest, DoesNotBackIntoWhatTheMapKnows) {
  GridGeometry geometry;
  geometry.origin = {-3.0, -3.0};
  geometry.width = geometry.height = 120;
  OccupancyGrid map(geometry, 0);
  for (double y = -1.0; y <= 1.0; y += 0.02) {
    map[geometry.ToCell({-0.35, y})] = 100;
  }
  ClearanceMap clearance(65, 1.0);
  clearance.SetMap(map);
  observation_.map = &clearance;
  for (double x = -1.0; x <= 0.0; x += 0.05) recovery_.Record({x, 0.0, 0.0});
  recovery_.Start(observation_);
  RunToEnd();
  EXPECT_GT(observation_.pose.x, -0.1);
}

TEST_F(RecoveryTest, IsBoundedInTime) {
  // A robot that cannot move, however it is told.
  for (double x = -1.0; x <= 0.0; x += 0.05) recovery_.Record({x, 0.0, 0.0});
  for (int attempt = 0; attempt < 2; ++attempt) {
    observation_.obstacles = {{0.5, 0.0}};
    recovery_.Start(observation_);
    const double start = observation_.time;
    while (recovery_.Update(observation_)) observation_.time += kPeriod;
    EXPECT_LE(observation_.time - start, parameters_.max_time + 2 * kPeriod);
  }
}

TEST_F(RecoveryTest, AttemptsAreCountedAtOnePlace) {
  parameters_.max_attempts = 2;
  EXPECT_TRUE(recovery_.HasAttemptLeft(observation_.pose));
  recovery_.Start(observation_);
  recovery_.Start(observation_);
  EXPECT_FALSE(recovery_.HasAttemptLeft(observation_.pose));
  EXPECT_TRUE(recovery_.HasAttemptLeft({1.5, 0.0, 0.0})) << "another place";
  recovery_.ResetAttempts();
  EXPECT_TRUE(recovery_.HasAttemptLeft(observation_.pose));
}

TEST(MostOpenDirectionTest, ByHand) {
  const Footprint footprint;
  EXPECT_EQ(MostOpenDirection({}, footprint), 0.0);
  const double direction =
      MostOpenDirection({{1.0, 0.0}, {-1.0, 0.0}, {0.0, -2.0}}, footprint);
  EXPECT_GT(direction, 0.2);
}

TEST(ProgressMonitorTest, MovingOrTurningIsProgress) {
  RecoveryParameters parameters;
  parameters.stuck_time = 1.0;
  parameters.stuck_distance = 0.1;
  parameters.stuck_angle = 0.3;
  ProgressMonitor monitor(parameters);
  EXPECT_FALSE(monitor.IsStuck(0.0, {0.0, 0.0, 0.0}));
  EXPECT_FALSE(monitor.IsStuck(0.9, {0.05, 0.0, 0.0}));
  EXPECT_TRUE(monitor.IsStuck(1.1, {0.05, 0.0, 0.0}));
  EXPECT_FALSE(monitor.IsStuck(1.2, {0.15, 0.0, 0.0}));
  EXPECT_FALSE(monitor.IsStuck(2.1, {0.15, 0.0, 0.4}));
  EXPECT_TRUE(monitor.IsStuck(3.2, {0.15, 0.0, 0.4}));
  monitor.Reset();
  EXPECT_FALSE(monitor.IsStuck(9.0, {0.15, 0.0, 0.4}));
}

TEST(ArrivalTest, LatchesThePositionThenAsksForHeadingAndRest) {
  GoalParameters parameters;
  Arrival arrival(parameters);
  const Pose2D end(1.0, 0.0, 0.0);
  EXPECT_FALSE(arrival.Update({0.5, 0.0, 0.0}, {}, end));
  EXPECT_FALSE(arrival.latched());
  EXPECT_FALSE(arrival.Update({0.95, 0.0, 0.3}, {}, end)) << "heading";
  EXPECT_TRUE(arrival.latched());
  EXPECT_FALSE(arrival.Update({0.88, 0.0, 0.0}, {0.1, 0.0}, end)) << "moving";
  EXPECT_TRUE(arrival.Update({0.88, 0.0, 0.0}, {0.0, 0.0}, end))
      << "the position stays latched";
  arrival.Reset();
  EXPECT_FALSE(arrival.Update({0.88, 0.0, 0.0}, {}, end));
}

}  // namespace
}  // namespace vfh_astar
