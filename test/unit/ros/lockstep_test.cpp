#include "vfh_astar/ros/lockstep.h"

#include <gtest/gtest.h>

namespace vfh_astar {
namespace {

NavigationState StateAt(double stamp) {
  NavigationState state;
  state.scan_stamp = ros::Time(stamp);
  return state;
}

MotionRequestId Question(int number) { return {number, "goal"}; }

TEST(LockstepTest, NothingWaitsWhenItIsOff) {
  Lockstep lockstep(false);
  EXPECT_TRUE(lockstep.TakeScan(ros::Time(1.0)));
  EXPECT_TRUE(lockstep.TakeScan(ros::Time(2.0)));
  EXPECT_FALSE(lockstep.TakeMapped(ros::Time(2.0)));
  EXPECT_TRUE(lockstep.TakeState(StateAt(2.0), Question(7)));
  EXPECT_FALSE(lockstep.TakeAnswer(Question(7)));
}

TEST(LockstepTest, ACycleWaitsForTheScanBeforeItsOwnToBeMapped) {
  Lockstep lockstep(true);
  EXPECT_TRUE(lockstep.TakeScan(ros::Time(1.0)));
  EXPECT_FALSE(lockstep.TakeScan(ros::Time(2.0)));
  EXPECT_FALSE(lockstep.TakeMapped(ros::Time(0.5)));
  EXPECT_TRUE(lockstep.TakeMapped(ros::Time(1.0)));
  // Once is enough.
  EXPECT_FALSE(lockstep.TakeMapped(ros::Time(2.0)));
  // The next one finds everything there.
  EXPECT_TRUE(lockstep.TakeScan(ros::Time(3.0)));
}

TEST(LockstepTest, ACycleWaitsForTheNewestOdometryOfItsTime) {
  Lockstep lockstep(true);
  lockstep.TakeOdometry(ros::Time(0.98));
  lockstep.TakeOdometry(ros::Time(1.0));
  EXPECT_FALSE(lockstep.TakeMapped(ros::Time(1.0)));
  EXPECT_TRUE(lockstep.TakeScan(ros::Time(1.0)));
  // At 1.02 there was odometry, and at 1.04 there will be.
  EXPECT_FALSE(lockstep.TakeScan(ros::Time(1.025)));
  EXPECT_TRUE(lockstep.TakeOdometry(ros::Time(1.02)));
  EXPECT_FALSE(lockstep.TakeMapped(ros::Time(1.025)));
  // There is odometry at 1.06 itself.
  EXPECT_FALSE(lockstep.TakeOdometry(ros::Time(1.04)));
  EXPECT_FALSE(lockstep.TakeScan(ros::Time(1.06)));
  EXPECT_FALSE(lockstep.TakeOdometry(ros::Time(1.06)));
  EXPECT_TRUE(lockstep.TakeMapped(ros::Time(1.06)));
}

TEST(LockstepTest, AScanOfOdometrysTimeIsInTheMapForItsOwnCycle) {
  Lockstep lockstep(true);
  lockstep.TakeOdometry(ros::Time(1.98));
  lockstep.TakeOdometry(ros::Time(2.0));
  EXPECT_FALSE(lockstep.TakeScan(ros::Time(2.0)));
  EXPECT_TRUE(lockstep.TakeMapped(ros::Time(2.0)));
}

TEST(LockstepTest, AScanThatComesMeanwhileEndsTheWaiting) {
  Lockstep lockstep(true);
  lockstep.TakeScan(ros::Time(1.0));
  EXPECT_FALSE(lockstep.TakeScan(ros::Time(2.0)));
  EXPECT_TRUE(lockstep.TakeScan(ros::Time(3.0)));
  EXPECT_FALSE(lockstep.TakeMapped(ros::Time(1.0)));
  EXPECT_FALSE(lockstep.TakeScan(ros::Time(4.0)));
  EXPECT_TRUE(lockstep.TakeMapped(ros::Time(3.0)));
}

TEST(LockstepTest, AStateWaitsForTheAnswerToItsQuestion) {
  Lockstep lockstep(true);
  EXPECT_EQ(lockstep.TakeState(StateAt(1.0), std::nullopt)->scan_stamp,
            ros::Time(1.0));
  EXPECT_FALSE(lockstep.TakeState(StateAt(2.0), Question(7)));
  EXPECT_FALSE(lockstep.TakeAnswer(Question(6)));
  EXPECT_FALSE(lockstep.TakeAnswer({7, "another goal"}));
  EXPECT_EQ(lockstep.TakeAnswer(Question(7))->scan_stamp, ros::Time(2.0));
  EXPECT_FALSE(lockstep.TakeAnswer(Question(7)));
}

TEST(LockstepTest, ANewerStateTakesTheOldOnesPlace) {
  Lockstep lockstep(true);
  EXPECT_FALSE(lockstep.TakeState(StateAt(1.0), Question(7)));
  EXPECT_TRUE(lockstep.TakeState(StateAt(2.0), std::nullopt));
  EXPECT_FALSE(lockstep.TakeAnswer(Question(7)));
}

TEST(LockstepTest, AfterAResetTheFirstScanIsFirstAgain) {
  Lockstep lockstep(true);
  lockstep.TakeScan(ros::Time(100.0));
  lockstep.TakeState(StateAt(100.0), Question(7));
  lockstep.Reset();
  EXPECT_FALSE(lockstep.TakeAnswer(Question(7)));
  EXPECT_TRUE(lockstep.TakeScan(ros::Time(1.0)));
  EXPECT_FALSE(lockstep.TakeScan(ros::Time(2.0)));
}

}  // namespace
}  // namespace vfh_astar
