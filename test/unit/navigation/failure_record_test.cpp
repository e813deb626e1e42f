#include "vfh_astar/navigation/failure_record.h"

#include <gtest/gtest.h>

#include "vfh_astar/navigation/stop_burst.h"

namespace vfh_astar {
namespace {

TEST(FailureRecordTest, PatienceCountsFromTheFirstFailure) {
  FailureRecord record;
  EXPECT_FALSE(record.MayPass(10.0, 3.0)) << "nothing has failed";
  record.NotePlanning(10.0, Outcome::kNoPath, "none");
  EXPECT_TRUE(record.MayPass(12.9, 3.0));
  record.NotePlanning(12.0, Outcome::kNoPath, "none");
  EXPECT_FALSE(record.MayPass(13.0, 3.0));
  record.Recovered();
  record.NotePlanning(20.0, Outcome::kGoalBlocked, "blocked");
  EXPECT_TRUE(record.MayPass(22.0, 3.0)) << "success begins anew";
}

TEST(FailureRecordTest, SomeFailuresDoNotPass) {
  for (const Outcome outcome : {Outcome::kGoalOutsideMap, Outcome::kInvalidGoal,
                                Outcome::kStartOutsideMap}) {
    FailureRecord record;
    record.NotePlanning(10.0, outcome, "");
    EXPECT_FALSE(record.MayPass(10.0, 3.0)) << ToString(outcome);
    EXPECT_FALSE(record.MovingMayHelp()) << ToString(outcome);
  }
}

TEST(FailureRecordTest, MovingHelpsWhereTheRobotIsTheTrouble) {
  FailureRecord record;
  EXPECT_FALSE(record.MovingMayHelp());
  record.Note(Outcome::kStuck, "stuck");
  EXPECT_TRUE(record.MovingMayHelp());
  record.NotePlanning(1.0, Outcome::kNoPath, "");
  EXPECT_FALSE(record.MovingMayHelp());
  record.NotePlanning(1.0, Outcome::kStartBlocked, "");
  EXPECT_TRUE(record.MovingMayHelp());
}

TEST(StopBurstTest, OneAtLeastAndSilenceOnceTheRobotStands) {
  StopBurst stop;
  EXPECT_FALSE(stop.Update(1.0, true).has_value()) << "it was not driving";
  stop.Begin(1.0);
  EXPECT_TRUE(stop.Update(1.0, true).has_value());
  EXPECT_TRUE(stop.Update(1.1, false).has_value());
  EXPECT_FALSE(stop.Update(1.2, true).has_value());
  EXPECT_FALSE(stop.Update(1.3, false).has_value());
}

TEST(StopBurstTest, EndsAfterHalfASecond) {
  StopBurst stop;
  stop.Begin(1.0);
  EXPECT_TRUE(stop.Update(1.5, false).has_value());
  EXPECT_FALSE(stop.Update(1.6, false).has_value());
}

}  // namespace
}  // namespace vfh_astar
