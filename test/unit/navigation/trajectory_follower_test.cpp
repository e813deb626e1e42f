#include "vfh_astar/navigation/trajectory_follower.h"

#include <gtest/gtest.h>

namespace vfh_astar {
namespace {

/// Along x at a constant 1 m/s.
Trajectory Steady(double from, double duration) {
  TrajectoryPiece piece;
  piece.duration = duration;
  piece.x[0] = from;
  piece.x[1] = duration;
  return Trajectory({piece});
}

TEST(TrajectoryFollowerTest, TheClockRunsAtItsRate) {
  TrajectoryFollower follower;
  follower.Follow(Steady(0.0, 4.0), std::nullopt, 0.0);
  follower.Advance(1.0, 1.0);
  EXPECT_DOUBLE_EQ(follower.At(0.0).pose.x, 1.0);
  follower.Advance(1.0, 0.25);
  EXPECT_DOUBLE_EQ(follower.At(0.0).pose.x, 1.25);
  EXPECT_DOUBLE_EQ(follower.At(0.5).pose.x, 1.75);
  EXPECT_FALSE(follower.ended());
  follower.Advance(3.0, 1.0);
  EXPECT_TRUE(follower.ended());
  EXPECT_DOUBLE_EQ(follower.End().x, 4.0);
}

TEST(TrajectoryFollowerTest, AFirstTrajectoryBeginsAsLateAsItCame) {
  TrajectoryFollower follower;
  follower.Follow(Steady(0.0, 4.0), std::nullopt, 0.3);
  EXPECT_DOUBLE_EQ(follower.At(0.0).pose.x, 0.3);
  follower.Follow(Steady(7.0, 4.0), std::nullopt, -0.1);
  EXPECT_DOUBLE_EQ(follower.At(0.0).pose.x, 7.0) << "not before its start";
}

TEST(TrajectoryFollowerTest, ANewTrajectoryTakesOverAtTheCommonPoint) {
  TrajectoryFollower follower;
  follower.Follow(Steady(0.0, 4.0), std::nullopt, 0.0);
  follower.Advance(1.0, 1.0);
  follower.Follow(Steady(1.5, 10.0), 1.5, 0.0);
  EXPECT_TRUE(follower.pending());
  follower.Advance(0.25, 1.0);
  EXPECT_DOUBLE_EQ(follower.At(0.0).pose.x, 1.25);
  EXPECT_EQ(follower.trajectory().duration(), 4.0) << "still the old one";
  follower.Advance(0.5, 1.0);
  EXPECT_FALSE(follower.pending());
  EXPECT_EQ(follower.trajectory().duration(), 10.0);
  EXPECT_DOUBLE_EQ(follower.At(0.0).pose.x, 1.75) << "no jump";
}

TEST(TrajectoryFollowerTest, ALateAnswerTakesOverAtOnceAndWhereItShould) {
  TrajectoryFollower follower;
  follower.Follow(Steady(0.0, 4.0), std::nullopt, 0.0);
  follower.Advance(2.0, 1.0);
  follower.Follow(Steady(1.5, 10.0), 1.5, 0.0);
  EXPECT_FALSE(follower.pending());
  EXPECT_DOUBLE_EQ(follower.At(0.0).pose.x, 2.0);
}

TEST(TrajectoryFollowerTest, TheNearestPointIsNeverBehind) {
  TrajectoryFollower follower;
  follower.Follow(Steady(0.0, 4.0), std::nullopt, 0.0);
  follower.Advance(1.0, 1.0);
  follower.AdvanceToNearest({2.0, 0.7}, 3.0);
  EXPECT_NEAR(follower.clock(), 2.0, 0.03);
  const double clock = follower.clock();
  follower.AdvanceToNearest({0.0, 0.0}, 3.0);
  EXPECT_EQ(follower.clock(), clock);
  follower.AdvanceToNearest({4.0, 0.0}, 0.5);
  EXPECT_LE(follower.clock(), clock + 0.5 + 1e-9) << "within the horizon";
}

TEST(TrajectoryFollowerTest, TheNearestPointCanBeTheEnd) {
  TrajectoryFollower follower;
  follower.Follow(Steady(0.0, 4.02), std::nullopt, 0.0);
  follower.AdvanceToNearest({9.0, 0.0}, 10.0);
  EXPECT_TRUE(follower.ended());
}

TEST(TrajectoryFollowerTest, ATrajectoryThatJoinsBeyondTheEndTakesOverThere) {
  TrajectoryFollower follower;
  follower.Follow(Steady(0.0, 4.0), std::nullopt, 0.0);
  follower.Follow(Steady(4.0, 2.0), 4.1, 0.0);
  follower.AdvanceToNearest({9.0, 0.0}, 10.0);
  EXPECT_FALSE(follower.pending());
  EXPECT_DOUBLE_EQ(follower.At(0.0).pose.x, 4.0);
}

}  // namespace
}  // namespace vfh_astar
