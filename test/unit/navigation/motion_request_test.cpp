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
  schedule.Send(10.0, 10.1, std::nullopt);
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
  const int first = schedule.Send(1.0, 1.0, std::nullopt);
  const int second = schedule.Send(2.0, 2.0, 0.5);
  EXPECT_NE(first, second);
  EXPECT_FALSE(schedule.Accept(first));
  EXPECT_TRUE(schedule.Accept(second));
  EXPECT_FALSE(schedule.Accept(second)) << "settled";
  EXPECT_EQ(schedule.start_time(), 2.0);
  EXPECT_EQ(schedule.join(), 0.5);
}

TEST(MotionRequestScheduleTest, WantingAnewDropsTheAnswer) {
  MotionRequestSchedule schedule(0.0, 2.0);
  const int id = schedule.Send(1.0, 1.0, std::nullopt);
  schedule.Want(1.1, 0.0);
  EXPECT_FALSE(schedule.Accept(id));
}

TEST(MotionRequestScheduleTest, TimesOutOnce) {
  MotionRequestSchedule schedule(0.0, 2.0);
  const int id = schedule.Send(1.0, 1.0, std::nullopt);
  EXPECT_FALSE(schedule.HasTimedOut(2.9));
  EXPECT_TRUE(schedule.HasTimedOut(3.1));
  EXPECT_FALSE(schedule.HasTimedOut(4.0));
  EXPECT_FALSE(schedule.Accept(id)) << "too late";
}

}  // namespace
}  // namespace vfh_astar
