#include "vfh_astar/trajectory/trajectory_fitter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

#include "trajectory/largest_load.h"
#include "trajectory/test_maps.h"
#include "vfh_astar/planning/path_planner.h"
#include "vfh_astar/trajectory/polyline.h"

namespace vfh_astar {
namespace {

using Kind = TrajectoryPiece::Kind;

// What the figures below are worked out for.
TrajectoryFitterParameters Parameters() {
  TrajectoryFitterParameters parameters;
  parameters.limits.max_v = 2.0;
  parameters.limits.max_acceleration = 2.0;
  parameters.limits.max_deceleration = 2.5;
  return parameters;
}

const TrajectoryFitterParameters kParameters = Parameters();

// A planner and a fitter on one map.
class Chain {
 public:
  explicit Chain(const OccupancyGrid& map)
      : clearance_(65, kParameters.ClearanceReach()),
        planner_(PathPlannerParameters()) {
    clearance_.SetMap(map);
    planner_.SetMap(map);
  }

  std::optional<FitRequest> Plan(const Reference& start, const Pose2D& goal) {
    const PlanResult plan = planner_.Plan({start.pose, goal, 0.0, {}});
    if (plan.outcome != Outcome::kSuccess) return std::nullopt;
    return FitRequest{plan.path, start, goal};
  }

  FitResult Fit(const FitRequest& request) const {
    return TrajectoryFitter(kParameters).Fit(request, clearance_);
  }

  bool IsFree(const Pose2D& pose) const {
    return clearance_.IsFree(kParameters.footprint, pose, 0.07);
  }

  const ClearanceMap& clearance() const { return clearance_; }

 private:
  ClearanceMap clearance_;
  PathPlanner planner_;
};

Reference AtRest(const Pose2D& pose) {
  Reference reference;
  reference.pose = pose;
  return reference;
}

bool Has(const Trajectory& trajectory, Kind kind) {
  return std::any_of(
      trajectory.pieces().begin(), trajectory.pieces().end(),
      [kind](const TrajectoryPiece& piece) { return piece.kind == kind; });
}

void ExpectPose(const Pose2D& pose, const Pose2D& expected) {
  EXPECT_NEAR((pose.position() - expected.position()).norm(), 0.0, 1e-6);
  EXPECT_NEAR(NormalizeAngle(pose.theta - expected.theta), 0.0, 0.011);
}

// Acceleration may jump where the robot rests, and nowhere else.
void ExpectSecondDerivative(const TrajectoryPiece& piece,
                            const TrajectoryPiece& next) {
  const Jet x = Evaluate(piece.x, piece.duration, 1.0);
  const Jet y = Evaluate(piece.y, piece.duration, 1.0);
  if (std::hypot(x.first, y.first) < 1e-6) return;
  EXPECT_EQ(piece.kind, next.kind);
  EXPECT_NEAR(Evaluate(next.x, next.duration, 0.0).first, x.first, 1e-8);
  EXPECT_NEAR(Evaluate(next.y, next.duration, 0.0).first, y.first, 1e-8);
  EXPECT_NEAR(Evaluate(next.x, next.duration, 0.0).second, x.second, 1e-6);
  EXPECT_NEAR(Evaluate(next.y, next.duration, 0.0).second, y.second, 1e-6);
}

void ExpectContinuous(const Trajectory& trajectory) {
  double t = 0.0;
  for (std::size_t i = 1; i < trajectory.pieces().size(); ++i) {
    t += trajectory.pieces()[i - 1].duration;
    const Reference before = trajectory.Sample(t - 1e-7);
    const Reference after = trajectory.Sample(t + 1e-7);
    EXPECT_NEAR((before.pose.position() - after.pose.position()).norm(), 0.0,
                1e-6);
    EXPECT_NEAR(NormalizeAngle(before.pose.theta - after.pose.theta), 0.0,
                2e-3);
    EXPECT_NEAR(before.twist.v, after.twist.v, 1e-5);
    EXPECT_NEAR(before.twist.w, after.twist.w, 1e-2);
    ExpectSecondDerivative(trajectory.pieces()[i - 1], trajectory.pieces()[i]);
  }
}

TEST(TrajectoryFitter, DrivesStraightByHand) {
  Chain chain(FreeMap(20, 10));
  const auto request = chain.Plan(AtRest({2, 5, 0}), {12, 5, 0});
  ASSERT_TRUE(request);
  const FitResult result = chain.Fit(*request);
  ASSERT_EQ(result.outcome, Outcome::kSuccess) << result.message;
  EXPECT_TRUE(result.message.empty());
  // 1 s and 1 m to 2 m/s, 0.8 s and 0.8 m to stop, 8.2 m between.
  EXPECT_NEAR(result.trajectory.duration(), 5.9, 0.06);
  EXPECT_NEAR(result.trajectory.Length(99), 10.0, 0.01);
  EXPECT_FALSE(Has(result.trajectory, Kind::kTurn));
  ExpectPose(result.trajectory.Sample(99).pose, {12, 5, 0});
}

TEST(TrajectoryFitter, TurnsAtStartAndGoal) {
  Chain chain(FreeMap(20, 10));
  const auto request = chain.Plan(AtRest({2, 5, 2.5}), {12, 5, -2.0});
  ASSERT_TRUE(request);
  const Trajectory trajectory = chain.Fit(*request).trajectory;
  ASSERT_FALSE(trajectory.empty());
  EXPECT_EQ(trajectory.pieces().front().kind, Kind::kTurn);
  EXPECT_EQ(trajectory.pieces().back().kind, Kind::kTurn);
  ExpectPose(trajectory.Sample(0).pose, {2, 5, 2.5});
  ExpectPose(trajectory.Sample(99).pose, {12, 5, -2.0});
}

TEST(TrajectoryFitter, BendsWhereHeadingsDifferALittle) {
  Chain chain(FreeMap(20, 10));
  const auto request = chain.Plan(AtRest({2, 5, 0.5}), {12, 5, -0.5});
  ASSERT_TRUE(request);
  const Trajectory trajectory = chain.Fit(*request).trajectory;
  ASSERT_FALSE(trajectory.empty());
  EXPECT_FALSE(Has(trajectory, Kind::kTurn));
  ExpectPose(trajectory.Sample(0).pose, {2, 5, 0.5});
  ExpectPose(trajectory.Sample(99).pose, {12, 5, -0.5});
}

TEST(TrajectoryFitter, TurnsWhereItStandsWhenTheGoalIsThere) {
  Chain chain(FreeMap(10, 10));
  FitRequest request = {{{5, 5}}, AtRest({5, 5, 0}), {5, 5, 1.5}};
  const Trajectory trajectory = chain.Fit(request).trajectory;
  ASSERT_FALSE(trajectory.empty());
  ExpectPose(trajectory.Sample(99).pose, {5, 5, 1.5});
  EXPECT_EQ(trajectory.Length(99), 0.0);
  request.goal.theta = 0.0;
  const FitResult still = chain.Fit(request);
  EXPECT_EQ(still.outcome, Outcome::kSuccess);
  EXPECT_GT(still.trajectory.duration(), 0.0);
}

TEST(TrajectoryFitter, BacksOutOfADeadEnd) {
  OccupancyGrid map = FreeMap(10, 10);
  AddBox(map, 1.0, 4.65, 3.5, 4.7);
  AddBox(map, 1.0, 5.30, 3.5, 5.35);
  AddBox(map, 0.95, 4.65, 1.0, 5.35);
  Chain chain(map);
  const auto request = chain.Plan(AtRest({1.5, 5.0, kPi}), {7, 5, 0});
  ASSERT_TRUE(request);
  const FitResult result = chain.Fit(*request);
  ASSERT_EQ(result.outcome, Outcome::kSuccess) << result.message;
  EXPECT_EQ(result.trajectory.pieces().front().kind, Kind::kReverse);
  ExpectPose(result.trajectory.Sample(99).pose, {7, 5, 0});
  EXPECT_LE(LargestLoad(result.trajectory, kParameters.limits), 1.01);
}

TEST(TrajectoryFitter, BacksIntoADeadEnd) {
  OccupancyGrid map = FreeMap(10, 10);
  AddBox(map, 6.5, 4.65, 9.0, 4.7);
  AddBox(map, 6.5, 5.30, 9.0, 5.35);
  Chain chain(map);
  const auto request = chain.Plan(AtRest({2, 5, 0}), {8.5, 5, kPi});
  ASSERT_TRUE(request);
  const FitResult result = chain.Fit(*request);
  ASSERT_EQ(result.outcome, Outcome::kSuccess) << result.message;
  EXPECT_TRUE(result.message.empty()) << result.message;
  ExpectPose(result.trajectory.Sample(99).pose, {8.5, 5, kPi});
}

TEST(TrajectoryFitter, SaysWhenThereIsNoRoomForTheGoalsHeading) {
  OccupancyGrid map = FreeMap(10, 10);
  AddBox(map, 3.0, 4.65, 9.9, 4.7);
  AddBox(map, 3.0, 5.30, 9.9, 5.35);
  Chain chain(map);
  const auto request = chain.Plan(AtRest({2, 5, 0}), {6, 5, kPi / 2});
  ASSERT_TRUE(request);
  const FitResult result = chain.Fit(*request);
  ASSERT_EQ(result.outcome, Outcome::kSuccess) << result.message;
  EXPECT_NE(result.message.find("(6.00, 5.00)"), std::string::npos)
      << result.message;
  EXPECT_NEAR(result.trajectory.Sample(99).pose.x, 6.0, 1e-6);
}

TEST(TrajectoryFitter, SaysWhereAPathDoesNotFit) {
  OccupancyGrid map = FreeMap(10, 10);
  AddBox(map, 5.0, 0.0, 5.1, 4.9);
  AddBox(map, 5.0, 5.1, 5.1, 10.0);
  Chain chain(map);
  Polyline path;
  for (double x = 2; x <= 8; x += 0.05) path.emplace_back(x, 5.0);
  const FitResult result = chain.Fit({path, AtRest({2, 5, 0}), {8, 5, 0}});
  EXPECT_EQ(result.outcome, Outcome::kNoTrajectory);
  EXPECT_TRUE(result.trajectory.empty());
  double x = 0.0;
  double y = 0.0;
  const std::size_t at = result.message.find('(');
  ASSERT_NE(at, std::string::npos) << result.message;
  ASSERT_EQ(std::sscanf(result.message.c_str() + at, "(%lf, %lf)", &x, &y), 2);
  EXPECT_NEAR(x, 4.8, 0.3);
  EXPECT_NEAR(y, 5.0, 0.3);
}

TEST(TrajectoryFitter, LeavesAWallThatItStandsAt) {
  OccupancyGrid map = FreeMap(10, 10);
  AddBox(map, 0.0, 2.0, 10.0, 2.2);
  Chain chain(map);
  // 5 mm from the wall's cells.
  const Pose2D start(3, 2.0 - 0.213, 0.0);
  const auto request = chain.Plan(AtRest(start), {8, 1, 0});
  ASSERT_TRUE(request);
  const FitResult result = chain.Fit(*request);
  ASSERT_EQ(result.outcome, Outcome::kSuccess) << result.message;
  const double off = result.trajectory.TimeAtLength(1.5);
  EXPECT_FALSE(FirstCollision(result.trajectory, kParameters.footprint,
                              chain.clearance(), 0.04, off, 99));
  EXPECT_FALSE(FirstCollision(result.trajectory, kParameters.footprint,
                              chain.clearance(), 0.015, 0, 99));
}

TEST(TrajectoryFitter, QuinticIsThePapersFit) {
  OccupancyGrid map = FreeMap(10, 10);
  AddBox(map, 5.0, 0.0, 5.1, 8.0);
  Chain chain(map);
  const auto request = chain.Plan(AtRest({3, 2, kPi / 2}), {7, 2, -kPi / 2});
  ASSERT_TRUE(request);
  TrajectoryFitterParameters parameters;
  parameters.fit = "quintic";
  parameters.time_per_metre = 2.0;
  const FitResult result =
      TrajectoryFitter(parameters).Fit(*request, chain.clearance());
  ASSERT_EQ(result.outcome, Outcome::kSuccess);
  EXPECT_EQ(result.trajectory.pieces().size(), 1u);
  EXPECT_NEAR(result.trajectory.duration(), 2.0 * Length(request->path), 0.1);
}

// Random fields, starts and goals.
class RandomFits : public ::testing::Test {
 protected:
  Pose2D RandomPose(const Chain& chain) {
    std::uniform_real_distribution<> place(0.6, 9.4);
    std::uniform_real_distribution<> angle(-kPi, kPi);
    for (int i = 0; i < 1000; ++i) {
      const double x = place(random_);
      const double y = place(random_);
      const Pose2D pose(x, y, angle(random_));
      if (chain.IsFree(pose)) return pose;
    }
    return {};
  }

  std::mt19937 random_{11};
};

TEST_F(RandomFits, AreFreeAndKeepTheLimits) {
  int requests = 0;
  int fitted = 0;
  for (int field = 0; field < 150; ++field) {
    Chain chain(PillarField(10, 10, 55, random_));
    for (int i = 0; i < 8; ++i) {
      const Pose2D start = RandomPose(chain);
      const Pose2D goal = RandomPose(chain);
      const auto request = chain.Plan(AtRest(start), goal);
      if (!request) continue;
      ++requests;
      const FitResult result = chain.Fit(*request);
      if (result.outcome != Outcome::kSuccess) continue;
      ++fitted;
      EXPECT_FALSE(FirstCollision(result.trajectory, kParameters.footprint,
                                  chain.clearance(), 0.04, 0, 1e9));
      EXPECT_LE(LargestLoad(result.trajectory, kParameters.limits), 1.01);
      ExpectContinuous(result.trajectory);
      ExpectPose(result.trajectory.Sample(0).pose, start);
      const Pose2D end = result.trajectory.Sample(1e9).pose;
      EXPECT_NEAR((end.position() - goal.position()).norm(), 0.0, 0.021);
      if (result.message.empty()) {
        EXPECT_NEAR(NormalizeAngle(end.theta - goal.theta), 0.0, 0.011);
      }
    }
  }
  EXPECT_GT(requests, 700);
  EXPECT_GE(fitted, 0.98 * requests);
}

TEST_F(RandomFits, AReplanJoinsTheRunningTrajectory) {
  int requests = 0;
  int fitted = 0;
  int joined = 0;
  std::uniform_real_distribution<> part(0.1, 0.6);
  for (int field = 0; field < 150; ++field) {
    Chain chain(PillarField(10, 10, 40, random_));
    const Pose2D goal = RandomPose(chain);
    const auto first = chain.Plan(AtRest(RandomPose(chain)), goal);
    if (!first) continue;
    const FitResult running = chain.Fit(*first);
    if (running.trajectory.empty()) continue;
    const double now = part(random_) * running.trajectory.duration();
    const Reference start = running.trajectory.Sample(now);
    if (start.twist.v < 0.3) continue;
    const auto request = chain.Plan(start, goal);
    if (!request) continue;
    ++requests;
    const FitResult result = chain.Fit(*request);
    if (result.outcome != Outcome::kSuccess) continue;
    ++fitted;
    const Reference join = result.trajectory.Sample(0.0);
    ExpectPose(join.pose, start.pose);
    EXPECT_NEAR(join.twist.v, start.twist.v, 1e-6);
    EXPECT_NEAR(join.twist.w, start.twist.w, 1e-4);
    ExpectContinuous(result.trajectory);
    EXPECT_LE(LargestLoad(result.trajectory, kParameters.limits), 1.01);
    const Reference soon =
        result.trajectory.Sample(result.trajectory.TimeAtLength(1.0));
    if (soon.twist.v > 0.1) ++joined;
  }
  EXPECT_GT(requests, 60);
  EXPECT_GE(fitted, 0.98 * requests);
  EXPECT_GE(joined, 0.9 * requests);
}

}  // namespace
}  // namespace vfh_astar
