#include "vfh_astar/navigation/navigator.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace vfh_astar {
namespace {

constexpr double kPeriod = 0.025;

/// A straight trajectory along x at constant speed but for its ends.
Trajectory Straight(double from, double to, double duration) {
  TrajectoryPiece piece;
  piece.duration = duration;
  // The quintic that starts and ends at rest: 10 tau^3 - 15 tau^4 + 6 tau^5.
  piece.x << from, 0.0, 0.0, 10.0, -15.0, 6.0;
  piece.x.tail<3>() *= to - from;
  return Trajectory({piece});
}

/// A robot that does at once what it is told, in a world of points.
class NavigatorTest : public testing::Test {
 protected:
  NavigatorTest() : navigator_(NavigatorParameters()) {
    scan_.angle_min = -kPi;
    scan_.angle_increment = kPi / 180;
    scan_.range_min = 0.1;
    scan_.range_max = 10.0;
  }

  void TakeScan() {
    scan_.stamp = time_;
    scan_.ranges.assign(360, std::numeric_limits<float>::infinity());
    for (const Eigen::Vector2d& point : world_) {
      const Eigen::Vector2d seen = pose_.Inverse() * point;
      const int beam = static_cast<int>(std::lround(
          (std::atan2(seen.y(), seen.x()) + kPi) / scan_.angle_increment));
      float& range = scan_.ranges[beam % 360];
      range = std::min(range, static_cast<float>(seen.norm()));
    }
  }

  /// One cycle, and the motion until the next one.
  NavigatorOutput Step() {
    if (has_scan_) TakeScan();
    NavigatorInput input;
    input.time = time_;
    if (has_transform_) input.map_from_odom = Pose2D();
    input.map_from_odom_stamp = transform_stamp_;
    input.odometry_stamp = time_;
    input.odom_from_base = pose_;
    input.twist = twist_;
    input.scan = ever_scanned_ ? &scan_ : nullptr;
    const NavigatorOutput output = navigator_.Update(input);
    if (output.command) twist_ = *output.command;
    commands_ += output.command ? 1 : 0;
    pose_ = Integrate(pose_, twist_, kPeriod);
    time_ += kPeriod;
    return output;
  }

  /// Steps until a goal has ended.
  GoalResult StepUntilResult(double seconds) {
    for (double t = 0.0; t < seconds; t += kPeriod) {
      const NavigatorOutput output = Step();
      if (output.request && answer_) {
        navigator_.SetTrajectory(output.request->id, *answer_);
      } else if (output.request && failure_ != Outcome::kSuccess) {
        navigator_.PlanFailed(output.request->id, failure_, "for the test");
      }
      if (output.result) return *output.result;
    }
    return {"", Outcome::kFailure, "nothing ended"};
  }

  void StepFor(double seconds) {
    for (double t = 0.0; t < seconds; t += kPeriod) Step();
  }

  /// Sets off along `trajectory`.
  void Drive(const Trajectory& trajectory, double seconds) {
    navigator_.SetGoal("a", {3.0, 0.0, 0.0});
    const NavigatorOutput output = Step();
    ASSERT_TRUE(output.request.has_value());
    navigator_.SetTrajectory(output.request->id, trajectory);
    StepFor(seconds);
  }

  Navigator navigator_;
  std::vector<Eigen::Vector2d> world_;
  LaserScan scan_;
  bool has_scan_ = true;
  bool ever_scanned_ = true;
  bool has_transform_ = true;
  std::optional<double> transform_stamp_;
  std::optional<Trajectory> answer_;
  Outcome failure_ = Outcome::kSuccess;
  double time_ = 100.0;
  Pose2D pose_;
  Twist2D twist_;
  int commands_ = 0;
};

TEST_F(NavigatorTest, SaysNothingWhenIdle) {
  StepFor(2.0);
  EXPECT_EQ(commands_, 0);
}

TEST_F(NavigatorTest, ReachesTheGoalAndFallsSilent) {
  answer_ = Straight(0.0, 3.0, 4.0);
  navigator_.SetGoal("a", {3.0, 0.0, 0.0});
  const GoalResult result = StepUntilResult(10.0);
  EXPECT_EQ(result.goal_id, "a");
  EXPECT_EQ(result.outcome, Outcome::kSuccess);
  EXPECT_NEAR(pose_.x, 3.0, 0.1);
  commands_ = 0;
  StepFor(2.0);
  EXPECT_LE(commands_, 1);
  EXPECT_EQ(twist_.v, 0.0);
}

TEST_F(NavigatorTest, RequestsCarryGoalAndStart) {
  pose_ = {1.0, 2.0, 0.5};
  navigator_.SetGoal("g", {4.0, 5.0, 1.0});
  const NavigatorOutput output = Step();
  ASSERT_TRUE(output.request.has_value());
  EXPECT_EQ(output.request->id.goal_id, "g");
  EXPECT_EQ(output.request->goal.x, 4.0);
  EXPECT_EQ(output.request->start.pose.y, 2.0);
  EXPECT_EQ(output.request->start.twist.v, 0.0);
  EXPECT_FALSE(Step().request.has_value()) << "one question at a time";
}

TEST_F(NavigatorTest, DropsTheAnswerToAnOldQuestion) {
  navigator_.SetGoal("a", {3.0, 0.0, 0.0});
  const NavigatorOutput first = Step();
  navigator_.SetGoal("b", {-3.0, 0.0, 0.0});
  StepFor(0.5);
  navigator_.SetTrajectory(first.request->id, Straight(0.0, 3.0, 4.0));
  const NavigatorOutput output = Step();
  EXPECT_EQ(output.status.state, State::kPlanning);
  EXPECT_EQ(output.status.goal_id, "b");
}

TEST_F(NavigatorTest, DropsTheAnswerToANavigatorBeforeIt) {
  navigator_.SetGoal("b", {3.0, 0.0, 0.0});
  const NavigatorOutput output = Step();
  ASSERT_TRUE(output.request.has_value());
  const MotionRequestId old{output.request->id.number, "a"};
  navigator_.SetTrajectory(old, Straight(0.0, 3.0, 4.0));
  navigator_.PlanFailed(old, Outcome::kInvalidGoal, "for the test");
  EXPECT_EQ(Step().status.state, State::kPlanning);
  navigator_.SetTrajectory(output.request->id, Straight(0.0, 3.0, 4.0));
  EXPECT_EQ(Step().status.state, State::kTracking);
}

TEST_F(NavigatorTest, ANewGoalEndsTheOldOneWithoutAStop) {
  Drive(Straight(0.0, 3.0, 4.0), 2.0);
  const double speed = twist_.v;
  ASSERT_GT(speed, 0.5);
  navigator_.SetGoal("b", {5.0, 0.0, 0.0});
  const NavigatorOutput output = Step();
  ASSERT_TRUE(output.result.has_value());
  EXPECT_EQ(output.result->goal_id, "a");
  EXPECT_EQ(output.result->outcome, Outcome::kCancelled);
  EXPECT_NEAR(output.command->v, speed, 0.1);
  ASSERT_TRUE(output.request.has_value());
  EXPECT_EQ(output.request->id.goal_id, "b");
  EXPECT_GT(output.request->start.twist.v, 0.5) << "joins at speed";
}

TEST_F(NavigatorTest, TheEndOfTheOldTrajectoryIsNoArrivalAtTheNewGoal) {
  Drive(Straight(0.0, 3.0, 4.0), 2.0);
  navigator_.SetGoal("b", {-20.0, 5.0, 0.0});
  Step();  // ends "a"
  failure_ = Outcome::kNoPath;
  const GoalResult result = StepUntilResult(20.0);
  EXPECT_EQ(result.goal_id, "b");
  EXPECT_EQ(result.outcome, Outcome::kNoPath);
}

TEST_F(NavigatorTest, PlansAlthoughOdometryNeverComesToRest) {
  navigator_.SetGoal("a", {3.0, 0.0, 0.0});
  bool asked = false;
  for (double t = 0.0; t < 3.0 && !asked; t += kPeriod) {
    twist_ = {0.0, 0.08};  // a gyro's bias
    asked = Step().request.has_value();
  }
  EXPECT_TRUE(asked);
}

TEST_F(NavigatorTest, AGapInTheScansIsNoLackOfProgress) {
  Drive(Straight(0.0, 3.0, 4.0), 2.0);
  has_scan_ = false;
  StepFor(2.5);
  has_scan_ = true;
  EXPECT_NE(Step().status.state, State::kRecovering);
}

TEST_F(NavigatorTest, NothingMovesAfterCancel) {
  Drive(Straight(0.0, 3.0, 4.0), 2.0);
  ASSERT_GT(twist_.v, 0.5);
  navigator_.Cancel();
  const NavigatorOutput output = Step();
  ASSERT_TRUE(output.result.has_value());
  EXPECT_EQ(output.result->outcome, Outcome::kCancelled);
  EXPECT_EQ(output.command->v, 0.0);
  commands_ = 0;
  for (double t = 0.0; t < 2.0; t += kPeriod) {
    const NavigatorOutput after = Step();
    EXPECT_EQ(after.command.value_or(Twist2D()).v, 0.0);
  }
  EXPECT_LE(commands_, 1) << "no flood of stops";
}

TEST_F(NavigatorTest, PausesAndResumes) {
  Drive(Straight(0.0, 3.0, 4.0), 2.0);
  navigator_.Pause();
  StepFor(0.5);
  EXPECT_EQ(twist_.v, 0.0);
  navigator_.Resume();
  const NavigatorOutput output = Step();
  EXPECT_EQ(output.status.state, State::kPlanning);
  EXPECT_TRUE(output.request.has_value());
}

TEST_F(NavigatorTest, StopsWhenTheScanIsOld) {
  Drive(Straight(0.0, 3.0, 4.0), 2.0);
  has_scan_ = false;
  EXPECT_GT(Step().status.speed, 0.5);
  StepFor(0.25);
  twist_.v = 0.4;  // it rolls on
  const NavigatorOutput output = Step();
  EXPECT_EQ(output.status.speed, 0.4) << "what is measured, not what is wanted";
  EXPECT_TRUE(std::isnan(output.status.clearance));
  EXPECT_EQ(output.command->v, 0.0);
  has_scan_ = true;
  StepFor(0.2);
  EXPECT_GT(twist_.v, 0.1) << "goes on with new scans";
}

TEST_F(NavigatorTest, GivesUpWithoutScan) {
  Drive(Straight(0.0, 3.0, 4.0), 2.0);
  has_scan_ = false;
  const GoalResult result = StepUntilResult(5.0);
  EXPECT_EQ(result.outcome, Outcome::kNoScan);
  EXPECT_NE(result.message.find("scan"), std::string::npos);
}

TEST_F(NavigatorTest, GivesUpWithoutTransform) {
  has_transform_ = false;
  navigator_.SetGoal("a", {3.0, 0.0, 0.0});
  const GoalResult result = StepUntilResult(5.0);
  EXPECT_EQ(result.outcome, Outcome::kTransformError);
}

TEST_F(NavigatorTest, AbortsAtOnceWhenTheGoalIsOutsideTheMap) {
  failure_ = Outcome::kGoalOutsideMap;
  navigator_.SetGoal("a", {300.0, 0.0, 0.0});
  const GoalResult result = StepUntilResult(0.5);
  EXPECT_EQ(result.outcome, Outcome::kGoalOutsideMap);
  EXPECT_EQ(result.message, "for the test");
}

TEST_F(NavigatorTest, AsksAgainForAWhileWhenThereIsNoPath) {
  failure_ = Outcome::kNoPath;
  navigator_.SetGoal("a", {3.0, 0.0, 0.0});
  const double start = time_;
  const GoalResult result = StepUntilResult(10.0);
  EXPECT_EQ(result.outcome, Outcome::kNoPath);
  EXPECT_GT(time_ - start, 2.5);
  EXPECT_LT(time_ - start, 5.0);
}

TEST_F(NavigatorTest, AbortsWhenThePlannerIsSilent) {
  navigator_.SetGoal("a", {3.0, 0.0, 0.0});
  const GoalResult result = StepUntilResult(20.0);
  EXPECT_EQ(result.outcome, Outcome::kTimeout);
}

TEST_F(NavigatorTest, NeverTouchesWhatStandsInTheWay) {
  for (double y = -1.0; y <= 1.0; y += 0.02) world_.emplace_back(1.8, y);
  Drive(Straight(0.0, 3.0, 4.0), 0.0);
  const Footprint footprint;
  for (double t = 0.0; t < 6.0; t += kPeriod) {
    Step();
    for (const Eigen::Vector2d& point : world_) {
      ASSERT_GT(footprint.SignedDistance(pose_.Inverse() * point), 0.0);
    }
  }
  EXPECT_GT(pose_.x, 0.8) << "it did drive up to it";
}

TEST_F(NavigatorTest, AsksForAReplanWhenTheTrajectoryIsBlocked) {
  Drive(Straight(0.0, 3.0, 6.0), 1.0);
  world_.emplace_back(2.0, 0.0);
  int requests = 0;
  State state = State::kIdle;
  for (double t = 0.0; t < 2.0 && requests == 0; t += kPeriod) {
    const NavigatorOutput output = Step();
    requests += output.request ? 1 : 0;
    state = output.status.state;
  }
  EXPECT_EQ(requests, 1);
  EXPECT_EQ(state, State::kReplanning);
}

TEST_F(NavigatorTest, AbortsWhenStuckAndRecoveriesAreUsedUp) {
  // Walled in on all sides, with a trajectory that nobody can drive.
  for (double angle = -kPi; angle < kPi; angle += 0.02) {
    world_.emplace_back(0.36 * std::cos(angle), 0.36 * std::sin(angle));
  }
  answer_ = Straight(0.0, 3.0, 4.0);
  navigator_.SetGoal("a", {3.0, 0.0, 0.0});
  const GoalResult result = StepUntilResult(120.0);
  EXPECT_EQ(result.outcome, Outcome::kStuck);
}

TEST_F(NavigatorTest, ATransformThatNobodyRenewsStopsTheRobotAndEndsTheGoal) {
  Drive(Straight(0.0, 3.0, 4.0), 2.0);
  ASSERT_GT(twist_.v, 0.5);
  transform_stamp_ = time_;
  StepFor(1.1);
  EXPECT_EQ(twist_.v, 0.0);
  EXPECT_TRUE(HasGoal(Step().status.state));
  const GoalResult result = StepUntilResult(5.0);
  EXPECT_EQ(result.outcome, Outcome::kTransformError);
  EXPECT_NE(result.message.find("old"), std::string::npos);
}

TEST_F(NavigatorTest, ToAndFroWithoutProgressEndsAsOscillation) {
  std::vector<TrajectoryPiece> swings;
  for (int i = 0; i < 30; ++i) {
    swings.push_back(Straight(0.0, 0.4, 1.0).pieces()[0]);
    swings.push_back(Straight(0.4, 0.0, 1.0).pieces()[0]);
    swings.back().kind = TrajectoryPiece::Kind::kReverse;
  }
  answer_ = Trajectory(swings);
  navigator_.SetGoal("a", {3.0, 0.0, 0.0});
  const double start = time_;
  const GoalResult result = StepUntilResult(300.0);
  EXPECT_EQ(result.outcome, Outcome::kOscillation);
  EXPECT_GT(time_ - start, 20.0) << "recoveries come first";
  EXPECT_EQ(twist_.v, 0.0);
}

TEST_F(NavigatorTest, YieldsToWhatMovesWhilePlanning) {
  failure_ = Outcome::kNoPath;
  const double radius = 0.3;
  double nearest = std::numeric_limits<double>::infinity();
  State state = State::kIdle;
  navigator_.SetGoal("a", {3.0, 0.0, 0.0});
  for (double t = 0.0; t < 2.5; t += kPeriod) {
    // From 3 m at the left at 1 m/s, it would run over the robot.
    const Eigen::Vector2d centre(0.0, 3.0 - 1.0 * t);
    world_.clear();
    for (double angle = -kPi; angle < kPi; angle += 0.02) {
      world_.push_back(
          centre + radius * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
    }
    nearest = std::min(
        nearest, Footprint().SignedDistance(pose_.Inverse() * centre) - radius);
    const NavigatorOutput output = Step();
    if (output.request) {
      navigator_.PlanFailed(output.request->id, failure_, "for the test");
    }
    state = output.status.state;
    ASSERT_EQ(state, State::kPlanning);
  }
  EXPECT_GT(nearest, 0.05);
  EXPECT_GT(pose_.position().norm(), 0.3) << "out of its way";
  navigator_.Cancel();
  EXPECT_EQ(Step().command->v, 0.0);
  StepFor(1.0);
  EXPECT_EQ(twist_.v, 0.0) << "nothing yields without a goal";
}

}  // namespace
}  // namespace vfh_astar
