#include "vfh_astar/navigation/goal_record.h"

#include <gtest/gtest.h>

namespace vfh_astar {
namespace {

TEST(GoalRecord, DoesNotCountTheFirstPlanAsReplan) {
  GoalRecord record;
  EXPECT_EQ(record.Replans(), 0);
  record.Begin({"a", {}});
  EXPECT_EQ(record.Replans(), 0);
  for (int i = 0; i < 3; ++i) record.NotePlanning();
  EXPECT_EQ(record.Replans(), 2);
  record.Begin({"b", {}});
  EXPECT_EQ(record.Replans(), 0);
}

TEST(GoalRecord, KnowsWhoseTrajectoryIsFollowed) {
  GoalRecord record;
  record.Begin({"a", {}});
  EXPECT_TRUE(record.IsFollowingOld());
  record.NoteFollowing();
  EXPECT_FALSE(record.IsFollowingOld());
  // The same name again is another goal.
  record.Begin({"a", {}});
  EXPECT_TRUE(record.IsFollowingOld());
}

TEST(GoalRecord, HandsOutEachResultOnceAndInOrder) {
  GoalRecord record;
  EXPECT_FALSE(record.TakeResult());
  record.Begin({"a", {}});
  record.End(Outcome::kCancelled, "replaced");
  record.Begin({"b", {}});
  record.End(Outcome::kSuccess, "reached");

  const std::optional<GoalResult> first = record.TakeResult();
  ASSERT_TRUE(first);
  EXPECT_EQ(first->goal_id, "a");
  EXPECT_EQ(first->outcome, Outcome::kCancelled);
  EXPECT_EQ(first->message, "replaced");
  const std::optional<GoalResult> second = record.TakeResult();
  ASSERT_TRUE(second);
  EXPECT_EQ(second->goal_id, "b");
  EXPECT_EQ(second->outcome, Outcome::kSuccess);
  EXPECT_FALSE(record.TakeResult());
}

}  // namespace
}  // namespace vfh_astar
