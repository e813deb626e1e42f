#include "vfh_astar/trajectory/timing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "trajectory/fine_optimum.h"
#include "trajectory/largest_load.h"
#include "trajectory/test_maps.h"
#include "vfh_astar/trajectory/curve_smoother.h"

namespace vfh_astar {
namespace {

// What the figures below are worked out for.
RobotLimits Limits() {
  RobotLimits limits;
  limits.max_v = 2.0;
  limits.max_v_reverse = 0.5;
  limits.max_w = 3.0;
  limits.max_angular_acceleration = 8.0;
  limits.max_lateral_acceleration = 2.0;
  return limits;
}

const RobotLimits kLimits = Limits();

TEST(SpeedAtCurvature, EachLimitByHand) {
  RobotLimits limits = kLimits;
  limits.max_wheel_speed = 10.0;
  EXPECT_DOUBLE_EQ(SpeedAtCurvature(0.0, 2.0, limits), 2.0);
  // sqrt(2 / 2) by lateral acceleration.
  EXPECT_DOUBLE_EQ(SpeedAtCurvature(-2.0, 2.0, limits), 1.0);
  // 3 / 10 by turning rate.
  EXPECT_DOUBLE_EQ(SpeedAtCurvature(10.0, 2.0, limits), 0.3);
  limits.max_wheel_speed = 1.5;
  limits.wheel_separation = 0.5;
  // v (1 + 0.25) = 1.5 at the outer wheels.
  EXPECT_DOUBLE_EQ(SpeedAtCurvature(1.0, 2.0, limits), 1.2);
  EXPECT_DOUBLE_EQ(SpeedAtCurvature(0.0, 2.0, limits), 1.5);
}

TEST(SpeedAtRoom, LineByHand) {
  const RoomSpeed rule = {0.1, 0.6, 0.8};
  EXPECT_DOUBLE_EQ(SpeedAtRoom(1.0, 2.0, rule), 2.0);
  EXPECT_DOUBLE_EQ(SpeedAtRoom(0.6, 2.0, rule), 2.0);
  EXPECT_NEAR(SpeedAtRoom(0.35, 2.0, rule), 1.4, 1e-12);
  EXPECT_DOUBLE_EQ(SpeedAtRoom(0.1, 2.0, rule), 0.8);
  EXPECT_NEAR(SpeedAtRoom(0.05, 2.0, rule), 0.4, 1e-12);
  EXPECT_DOUBLE_EQ(SpeedAtRoom(0.0, 2.0, rule), 0.2);
  EXPECT_DOUBLE_EQ(SpeedAtRoom(0.05, 0.5, rule), 0.25);
}

TEST(TimeTurn, TrapezoidByHand) {
  // 180 degrees at 3 rad/s and 8 rad/s^2: pi / 3 + 3 / 8 s.
  const Trajectory trajectory(TimeTurn({1, 2, 3}, -kPi, 0.0, kLimits));
  EXPECT_NEAR(trajectory.duration(), kPi / 3 + 3.0 / 8.0, 0.03);
  EXPECT_NEAR(trajectory.Sample(9).pose.theta, 3 - kPi, 1e-9);
  double top = 0.0;
  for (double t = 0; t < trajectory.duration(); t += 0.001) {
    const Reference reference = trajectory.Sample(t);
    EXPECT_EQ(reference.pose.x, 1.0);
    EXPECT_LE(reference.twist.w, 1e-9);
    top = std::max(top, -reference.twist.w);
    const double next = trajectory.Sample(t + 1e-4).twist.w;
    if (t + 1e-4 < trajectory.duration()) {
      EXPECT_LE(std::abs(next - reference.twist.w) / 1e-4, 8.08);
    }
  }
  EXPECT_NEAR(top, 3.0, 0.01);
}

TEST(TimeTurn, GoesOnFromARunningTurn) {
  const Trajectory trajectory(TimeTurn({0, 0, 0}, 1.0, 2.0, kLimits));
  EXPECT_NEAR(trajectory.Sample(0.0).twist.w, 2.0, 1e-9);
}

// 1/m; sharper ones are cusps, which no leg has.
constexpr double kSharpestLeg = 12.0;

double SharpestBend(const std::vector<CurvePoint>& points) {
  double bend = 0.0;
  for (const CurvePoint& point : points) {
    bend = std::max(bend, std::abs(point.curvature));
  }
  return bend;
}

// 1.5 to 4.5 m of a random walk from the middle of the map on, smoothed.
std::vector<CurvePoint> RandomWalk(std::mt19937& random) {
  std::uniform_real_distribution<> unit(0.0, 1.0);
  std::normal_distribution<> turn(0.0, 1.0);
  const double wildness = 0.5 * unit(random);
  const int count = 15 + static_cast<int>(30 * unit(random));
  double heading = 0.0;
  std::vector<Bubble> bubbles = {{{10, 10}, 0.0}};
  for (int i = 1; i < count; ++i) {
    heading += wildness * turn(random);
    const Eigen::Vector2d step(std::cos(heading), std::sin(heading));
    bubbles.push_back({bubbles.back().centre + 0.1 * step, 0.05});
  }
  return SmoothThroughBubbles({{10, 10}, 0.0, 0.0},
                              {bubbles.back().centre, heading, 0.0}, 0.1,
                              bubbles)
      .Sample();
}

class TimeDriveTest : public ::testing::Test {
 protected:
  TimeDriveTest()
      : clearance_(ClearanceOf(FreeMap(20, 20))),
        check_({}, clearance_, 0.02, {10, 10, 0}) {}

  // An S of two bends.
  static std::vector<CurvePoint> Bends() {
    std::vector<Bubble> bubbles;
    for (int i = 0; i <= 60; ++i) {
      bubbles.push_back({{3 + 0.1 * i, 10 + std::sin(0.1 * i)}, 0.05});
    }
    return SmoothThroughBubbles({{3, 10}, kPi / 4, 0.0},
                                {bubbles.back().centre, kPi / 4, 0.0}, 0.11,
                                bubbles)
        .Sample();
  }

  Trajectory Time(const std::vector<CurvePoint>& points, bool reverse,
                  const DriveStart& start) const {
    return Trajectory(
        TimeDrive(points, reverse, start, kLimits, {}, check_).pieces);
  }

  ClearanceMap clearance_;
  PoseCheck check_;
};

TEST_F(TimeDriveTest, FollowsTheCurveFromRestToRest) {
  const std::vector<CurvePoint> points = Bends();
  const Trajectory trajectory = Time(points, false, {});
  double length = 0.0;
  double t = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    length += points[i].length;
    const Reference at = trajectory.Sample(t);
    EXPECT_NEAR((at.pose.position() - points[i].position).norm(), 0.0, 1e-9);
    EXPECT_NEAR(NormalizeAngle(at.pose.theta - points[i].heading), 0.0, 1e-6);
    if (i < trajectory.pieces().size()) t += trajectory.pieces()[i].duration;
  }
  EXPECT_NEAR(trajectory.Length(1e9), length, 1e-4);
  EXPECT_NEAR(trajectory.Sample(trajectory.duration()).twist.v, 0.0, 1e-6);
}

TEST_F(TimeDriveTest, IsContinuousToTheSecondDerivative) {
  const Trajectory trajectory = Time(Bends(), false, {1.0, 0.5});
  const std::vector<TrajectoryPiece>& pieces = trajectory.pieces();
  for (std::size_t i = 1; i < pieces.size(); ++i) {
    for (const auto axis : {&TrajectoryPiece::x, &TrajectoryPiece::y}) {
      const Jet end = Evaluate(pieces[i - 1].*axis, pieces[i - 1].duration, 1);
      const Jet start = Evaluate(pieces[i].*axis, pieces[i].duration, 0);
      EXPECT_NEAR(end.value, start.value, 1e-9);
      EXPECT_NEAR(end.first, start.first, 1e-8);
      EXPECT_NEAR(end.second, start.second, 1e-6);
    }
  }
}

TEST_F(TimeDriveTest, StartsWithTheSpeedItHas) {
  const Trajectory trajectory = Time(Bends(), false, {1.1, -0.3});
  EXPECT_NEAR(trajectory.Sample(0.0).twist.v, 1.1, 1e-9);
  EXPECT_NEAR(trajectory.Sample(0.0).acceleration, -0.3, 1e-6);
}

TEST_F(TimeDriveTest, ReverseTurnsTheHeadingAround) {
  const Trajectory trajectory = Time(Bends(), true, {});
  const double middle = trajectory.duration() / 2;
  const Reference at = trajectory.Sample(middle);
  const Reference after = trajectory.Sample(middle + 1e-3);
  EXPECT_NEAR(at.twist.v, -kLimits.max_v_reverse, 0.05);
  EXPECT_LT((after.pose.position() - at.pose.position()).dot(at.pose.heading()),
            0.0);
}

TEST_F(TimeDriveTest, WithinTwoPercentOfTheFineOptimum) {
  std::mt19937 random(5);
  for (int trial = 0; trial < 100; ++trial) {
    const std::vector<CurvePoint> points = RandomWalk(random);
    if (SharpestBend(points) > kSharpestLeg) continue;
    const double optimum = FineOptimum(BentCurve(points), kLimits).Duration();
    const double duration = Time(points, false, {}).duration();
    EXPECT_LT(duration, 1.02 * optimum) << trial;
    EXPECT_GT(duration, 0.99 * optimum) << trial;
  }
}

TEST_F(TimeDriveTest, KeepsLimitsOnTenThousandCurves) {
  std::mt19937 random(8);
  double sharpest = 0.0;
  for (int trial = 0; trial < 10000; ++trial) {
    const std::vector<CurvePoint> points = RandomWalk(random);
    const double bend = SharpestBend(points);
    if (bend > kSharpestLeg) continue;
    sharpest = std::max(sharpest, bend);
    const Trajectory trajectory = Time(points, trial % 5 == 0, {});
    ASSERT_LE(LargestLoad(trajectory, kLimits), 1.01) << trial;
  }
  EXPECT_GT(sharpest, 10.0);
}

TEST_F(TimeDriveTest, SlowsDownNearAWall) {
  OccupancyGrid map = FreeMap(20, 20);
  AddBox(map, 8.0, 10.35, 12.0, 10.5);
  const ClearanceMap clearance = ClearanceOf(map);
  const PoseCheck check({}, clearance, 0.02, {10, 10, 0});
  std::vector<CurvePoint> points(301);
  for (int i = 0; i <= 300; ++i) {
    points[i].position = {2.0 + 0.05 * i, 10.0};
    points[i].length = i > 0 ? 0.05 : 0.0;
  }
  const RoomSpeed rule;
  const Trajectory trajectory(
      TimeDrive(points, false, {}, kLimits, rule, check).pieces);
  const Reference beside = trajectory.Sample(trajectory.TimeAtLength(8.0));
  EXPECT_NEAR(beside.twist.v, SpeedAtRoom(0.142, 2.0, rule), 0.02);
  const Reference before = trajectory.Sample(trajectory.TimeAtLength(4.0));
  EXPECT_NEAR(before.twist.v, 2.0, 0.02);
}

}  // namespace
}  // namespace vfh_astar
