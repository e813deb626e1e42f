#include "vfh_astar/ros/motion_messages.h"

#include <gtest/gtest.h>

#include <cmath>

#include "vfh_astar/ros/message_error.h"

namespace vfh_astar {
namespace {

MotionRequest MakeRequest() {
  MotionRequest request;
  request.id = {17, "goal 3"};
  request.start_time = 12.25;
  request.start.pose = {1.0, 2.0, 0.5};
  request.start.twist = {0.75, -0.25};
  request.start.acceleration = 1.5;
  request.goal = {4.0, 5.0, -2.0};
  request.tolerance = 0.5;
  return request;
}

TEST(MotionMessagesTest, AQueryCarriesTheWholeRequest) {
  const MotionQuery query =
      ToQueryMessage(MakeRequest(), ros::Time(12, 7), "map");
  EXPECT_EQ(query.header.stamp, ros::Time(12, 7));
  EXPECT_EQ(query.header.frame_id, "map");
  EXPECT_EQ(query.id, 17u);
  EXPECT_EQ(query.goal_id, "goal 3");
  EXPECT_EQ(query.start_time, ros::Time(12, 250000000));

  const PlanRequest plan = ToPlanRequest(query, "map");
  EXPECT_EQ(plan.start.x, 1.0);
  EXPECT_NEAR(plan.start.theta, 0.5, 1e-12);
  EXPECT_EQ(plan.goal.y, 5.0);
  EXPECT_NEAR(plan.goal.theta, -2.0, 1e-12);
  EXPECT_EQ(plan.tolerance, 0.5);
}

TEST(MotionMessagesTest, AFitStartsWhereTheQueryDoesAndEndsWhereThePlanDoes) {
  const MotionQuery query = ToQueryMessage(MakeRequest(), ros::Time(1), "map");
  const nav_msgs::Path path =
      ToPathMessage({{1.0, 2.0}, {2.0, 3.0}, {3.9, 5.0}}, {3.9, 5.0, -2.0},
                    "map", ros::Time(1));
  const FitRequest fit = ToFitRequest(path, &query);
  ASSERT_EQ(fit.path.size(), 3u);
  EXPECT_EQ(fit.path[1].y(), 3.0);
  EXPECT_EQ(fit.start.pose.x, 1.0);
  EXPECT_EQ(fit.start.twist.v, 0.75);
  EXPECT_EQ(fit.start.twist.w, -0.25);
  EXPECT_EQ(fit.start.acceleration, 1.5);
  EXPECT_EQ(fit.goal.x, 3.9);
  EXPECT_NEAR(fit.goal.theta, -2.0, 1e-12);
}

TEST(MotionMessagesTest, AForeignPlanIsFittedFromRestAtItsFirstPose) {
  const nav_msgs::Path path = ToPathMessage(
      {{1.0, 2.0}, {1.0, 3.0}}, {1.0, 3.0, 0.0}, "map", ros::Time(1));
  const FitRequest fit = ToFitRequest(path, nullptr);
  EXPECT_EQ(fit.start.pose.y, 2.0);
  EXPECT_NEAR(fit.start.pose.theta, 0.5 * kPi, 1e-12);
  EXPECT_EQ(fit.start.twist.v, 0.0);
}

TEST(MotionMessagesTest, RefusesPathsThatCannotBeFitted) {
  EXPECT_THROW(ToFitRequest({}, nullptr), MessageError);
  nav_msgs::Path path = ToPathMessage({{1.0, 2.0}, {2.0, 2.0}}, {2.0, 2.0, 0.0},
                                      "map", ros::Time(1));
  path.poses[1].pose.position.x = std::nan("");
  EXPECT_THROW(ToFitRequest(path, nullptr), MessageError);
}

TEST(MotionMessagesTest, PosesOfAPathLookAlongItAndTheLastOneAtItsGoal) {
  const nav_msgs::Path path =
      ToPathMessage({{0.0, 0.0}, {1.0, 1.0}, {1.0, 2.0}}, {1.0, 2.0, 3.0},
                    "map", ros::Time(5));
  ASSERT_EQ(path.poses.size(), 3u);
  EXPECT_EQ(path.header.stamp, ros::Time(5));
  EXPECT_EQ(path.poses[2].header.frame_id, "map");
  const auto heading = [&path](int i) {
    const geometry_msgs::Quaternion& q = path.poses[i].pose.orientation;
    return 2.0 * std::atan2(q.z, q.w);
  };
  EXPECT_NEAR(heading(0), 0.25 * kPi, 1e-12);
  EXPECT_NEAR(heading(1), 0.5 * kPi, 1e-12);
  EXPECT_NEAR(heading(2), 3.0, 1e-12);
}

Trajectory MakeTrajectory() {
  TrajectoryPiece drive;
  drive.duration = 2.0;
  drive.x << 0.0, 1.0, 0.5, -0.25, 0.125, -0.375;
  drive.y << 0.5, 0.0, 0.25, 0.0, 0.0, 0.0;
  TrajectoryPiece turn;
  turn.kind = TrajectoryPiece::Kind::kTurn;
  turn.duration = 1.0;
  turn.x[0] = 1.0;
  turn.y[0] = 0.75;
  turn.heading << 0.1, 0.0, 3.0, -2.0, 0.0, 0.0;
  TrajectoryPiece back;
  back.kind = TrajectoryPiece::Kind::kReverse;
  back.duration = 0.5;
  back.x << 1.0, -1.0, 0.0, 0.0, 0.0, 0.0;
  back.y[0] = 0.75;
  return Trajectory({drive, turn, back});
}

TEST(MotionMessagesTest, TrajectoriesSurviveTheWayThereAndBack) {
  const Trajectory trajectory = MakeTrajectory();
  const QuinticTrajectory message =
      ToTrajectoryMessage(trajectory, "map", ros::Time(9));
  EXPECT_EQ(message.header.stamp, ros::Time(9));
  EXPECT_EQ(message.pieces[1].kind, QuinticPiece::TURN);
  EXPECT_EQ(message.pieces[2].kind, QuinticPiece::REVERSE);
  const Trajectory back = ToTrajectory(message);
  ASSERT_EQ(back.pieces().size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(back.pieces()[i].kind, trajectory.pieces()[i].kind);
    EXPECT_EQ(back.pieces()[i].duration, trajectory.pieces()[i].duration);
    EXPECT_EQ(back.pieces()[i].x, trajectory.pieces()[i].x);
    EXPECT_EQ(back.pieces()[i].y, trajectory.pieces()[i].y);
    EXPECT_EQ(back.pieces()[i].heading, trajectory.pieces()[i].heading);
  }
}

TEST(MotionMessagesTest, RefusesBrokenTrajectories) {
  const QuinticTrajectory good =
      ToTrajectoryMessage(MakeTrajectory(), "map", ros::Time(9));
  EXPECT_THROW(ToTrajectory({}), MessageError);
  QuinticTrajectory bad = good;
  bad.pieces[1].duration = 0.0;
  EXPECT_THROW(ToTrajectory(bad), MessageError);
  bad.pieces[1].duration = std::nan("");
  EXPECT_THROW(ToTrajectory(bad), MessageError);
  bad = good;
  bad.pieces[0].kind = 3;
  EXPECT_THROW(ToTrajectory(bad), MessageError);
  bad = good;
  bad.pieces[2].y[5] = HUGE_VAL;
  try {
    ToTrajectory(bad);
    FAIL() << "expected MessageError";
  } catch (const MessageError& error) {
    EXPECT_NE(std::string(error.what()).find("pieces[2]"), std::string::npos);
  }
}

TEST(MotionMessagesTest, ADisplayedTrajectoryReachesItsEndInTime) {
  const Trajectory trajectory = MakeTrajectory();
  const nav_msgs::Path path = ToPathMessage(trajectory, "map", ros::Time(9));
  EXPECT_EQ(path.poses.size(), 71u);
  EXPECT_EQ(path.poses.back().header.stamp, ros::Time(12.5));
  const Pose2D end = trajectory.Sample(3.5).pose;
  EXPECT_NEAR(path.poses.back().pose.position.x, end.x, 1e-12);
}

TEST(MotionMessagesTest, RefusesAQuestionInAnotherFrame) {
  MotionQuery query = ToQueryMessage(MakeRequest(), ros::Time(1), "odom");
  EXPECT_THROW(ToPlanRequest(query, "map"), MessageError);
  query.header.frame_id.clear();
  EXPECT_THROW(ToPlanRequest(query, "map"), MessageError);
  query.header.frame_id = "/map";
  EXPECT_EQ(ToPlanRequest(query, "map").goal.x, 4.0);
}

TEST(MotionMessagesTest, AFailureAnswersItsQuestion) {
  const MotionQuery query = ToQueryMessage(MakeRequest(), ros::Time(1), "map");
  MotionFailure failure = ToFailureMessage(
      query, "path_planner", Outcome::kNoPath, "walls all around");
  EXPECT_EQ(failure.outcome, MotionFailure::NO_PATH);
  EXPECT_EQ(failure.stage, "path_planner");
  EXPECT_EQ(failure.header.stamp, ros::Time(1));
  const MotionAnswer answer = ToAnswer(failure);
  EXPECT_EQ(answer.id.number, 17);
  EXPECT_EQ(answer.id.goal_id, "goal 3");
  EXPECT_EQ(answer.outcome, Outcome::kNoPath);
  EXPECT_EQ(answer.message, "walls all around");
  // A failure is one, whatever number a stranger gives it.
  failure.outcome = 0;
  EXPECT_EQ(ToAnswer(failure).outcome, Outcome::kFailure);
  failure.outcome = 12345;
  EXPECT_EQ(ToAnswer(failure).outcome, Outcome::kFailure);
}

TEST(MotionMessagesTest, TheMessagesNumbersAreTheOutcomes) {
  const std::pair<int, Outcome> pairs[] = {
      {MotionFailure::FAILURE, Outcome::kFailure},
      {MotionFailure::CANCELLED, Outcome::kCancelled},
      {MotionFailure::INVALID_GOAL, Outcome::kInvalidGoal},
      {MotionFailure::NO_PATH, Outcome::kNoPath},
      {MotionFailure::GOAL_OUTSIDE_MAP, Outcome::kGoalOutsideMap},
      {MotionFailure::GOAL_BLOCKED, Outcome::kGoalBlocked},
      {MotionFailure::START_OUTSIDE_MAP, Outcome::kStartOutsideMap},
      {MotionFailure::START_BLOCKED, Outcome::kStartBlocked},
      {MotionFailure::NO_MAP, Outcome::kNoMap},
      {MotionFailure::NO_TRAJECTORY, Outcome::kNoTrajectory}};
  for (const auto& [number, outcome] : pairs) {
    EXPECT_EQ(number, static_cast<int>(outcome));
    MotionFailure failure;
    failure.outcome = number;
    EXPECT_EQ(ToAnswer(failure).outcome, outcome);
  }
}

}  // namespace
}  // namespace vfh_astar
