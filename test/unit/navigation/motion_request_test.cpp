#include "vfh_astar/navigation/motion_request.h"

#include <gtest/gtest.h>

namespace vfh_astar {
namespace {

TEST(MotionRequestScheduleTest, NothingIsDueUnlessWanted) {
  const MotionRequestSchedule schedule(0.25, 2.0);
  EXPECT_FALSE(schedule.IsDue(100.0));
}

TEST(MotionRequestScheduleTest, TheFirstIsDueAtOnceTheNextAfterThePeriod) {
  MotionRequestSchedule schedule(0.25, 2.0);
  schedule.Want(10.0, 0.0);
  EXPECT_TRUE(schedule.IsDue(10.0));
  schedule.Send("a", 10.0, 10.1, std::nullopt);
  EXPECT_FALSE(schedule.IsDue(20.0)) << "sent is no longer wanted";
  schedule.Want(10.1, 0.0);
  EXPECT_FALSE(schedule.IsDue(10.2));
  EXPECT_TRUE(schedule.IsDue(10.25));
}

TEST(MotionRequestScheduleTest, ADelayCounts) {
  MotionRequestSchedule schedule(0.25, 2.0);
  schedule.Want(10.0, 0.5);
  EXPECT_FALSE(schedule.IsDue(10.4));
  EXPECT_TRUE(schedule.IsDue(10.5));
}

TEST(MotionRequestScheduleTest, OnlyTheAnswerToTheLatestCounts) {
  MotionRequestSchedule schedule(0.0, 2.0);
  const MotionRequestId first = schedule.Send("a", 1.0, 1.0, std::nullopt);
  const MotionRequestId second = schedule.Send("a", 2.0, 2.0, 0.5);
  EXPECT_NE(first.number, second.number);
  EXPECT_FALSE(schedule.Accept(first));
  EXPECT_TRUE(schedule.Accept(second));
  EXPECT_FALSE(schedule.Accept(second)) << "settled";
  EXPECT_EQ(schedule.start_time(), 2.0);
  EXPECT_EQ(schedule.join(), 0.5);
}

TEST(MotionRequestScheduleTest, ANumberFromBeforeARestartIsNoAnswer) {
  MotionRequestSchedule before(0.0, 2.0);
  const MotionRequestId old = before.Send("a", 1.0, 1.0, std::nullopt);
  MotionRequestSchedule schedule(0.0, 2.0);
  const MotionRequestId id = schedule.Send("b", 1.5, 1.5, std::nullopt);
  EXPECT_EQ(id.number, old.number);
  EXPECT_FALSE(schedule.Accept(old));
  EXPECT_FALSE(schedule.Accept({id.number, ""}));
  EXPECT_TRUE(schedule.Accept(id)) << "a stranger's answer settles nothing";
}

TEST(MotionRequestScheduleTest, WantingAnewDropsTheAnswer) {
  MotionRequestSchedule schedule(0.0, 2.0);
  const MotionRequestId id = schedule.Send("a", 1.0, 1.0, std::nullopt);
  schedule.Want(1.1, 0.0);
  EXPECT_FALSE(schedule.Accept(id));
}

TEST(MotionRequestScheduleTest, TimesOutOnce) {
  MotionRequestSchedule schedule(0.0, 2.0);
  const MotionRequestId id = schedule.Send("a", 1.0, 1.0, std::nullopt);
  EXPECT_FALSE(schedule.HasTimedOut(2.9));
  EXPECT_TRUE(schedule.HasTimedOut(3.1));
  EXPECT_FALSE(schedule.HasTimedOut(4.0));
  EXPECT_FALSE(schedule.Accept(id)) << "too late";
}

}  // namespace
}  // namespace vfh_astar
