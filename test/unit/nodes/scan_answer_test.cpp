#include "scan_answer.h"

#include <gtest/gtest.h>

namespace vfh_astar {
namespace {

ScanAnswer AskedAt(double stamp) {
  ScanAnswer answer;
  answer.TakeScan(stamp);
  return answer;
}

TEST(ScanAnswer, NobodyIsWaitedForWhereNobodyAnswers) {
  EXPECT_TRUE(ScanAnswer().IsComplete(true, true));
  EXPECT_TRUE(AskedAt(1.0).IsComplete(false, false));
}

TEST(ScanAnswer, TheNavigationAnswersByTheScansStamp) {
  ScanAnswer answer = AskedAt(1.0);
  EXPECT_FALSE(answer.IsComplete(true, true));
  answer.TakeState(0.975, false);
  EXPECT_FALSE(answer.IsComplete(true, true));
  answer.TakeState(1.0, false);
  EXPECT_TRUE(answer.IsComplete(true, true));
}

TEST(ScanAnswer, TheCommandThatGoesWithAStateIsWaitedFor) {
  ScanAnswer answer = AskedAt(1.0);
  answer.TakeState(1.0, true);
  EXPECT_FALSE(answer.IsComplete(true, true));
  answer.TakeCommand();
  EXPECT_TRUE(answer.IsComplete(true, true));

  answer.TakeScan(1.025);
  answer.TakeCommand();
  EXPECT_FALSE(answer.IsComplete(true, true));
  answer.TakeState(1.025, true);
  EXPECT_TRUE(answer.IsComplete(true, true));
}

TEST(ScanAnswer, AnybodyElseAnswersByACommand) {
  ScanAnswer answer;
  answer.TakeCommand();
  answer.TakeScan(1.0);
  EXPECT_FALSE(answer.IsComplete(false, true)) << "it came before the scan";
  answer.TakeCommand();
  EXPECT_TRUE(answer.IsComplete(false, true));
}

TEST(ScanAnswer, WhoIsIdleIsNotWaitedForBeforeTheNextCommand) {
  ScanAnswer answer = AskedAt(1.0);
  answer.GiveUp();
  EXPECT_TRUE(answer.IsComplete(false, true));
  answer.TakeScan(1.025);
  EXPECT_TRUE(answer.IsComplete(false, true));
  answer.TakeCommand();
  answer.TakeScan(1.05);
  EXPECT_FALSE(answer.IsComplete(false, true));
  // A navigation is waited for at every scan.
  answer.GiveUp();
  answer.TakeScan(1.075);
  EXPECT_FALSE(answer.IsComplete(true, true));
}

TEST(ScanAnswer, WhoCommandsAtAPaceOfHisOwnIsNotWaitedForInTheEnd) {
  ScanAnswer answer;
  int misses = 0;
  for (int scan = 0; scan < 100; ++scan) {
    answer.TakeScan(0.025 * scan);
    if (scan % 2 == 0) answer.TakeCommand();
    if (answer.IsComplete(false, true)) continue;
    answer.GiveUp();
    ++misses;
  }
  EXPECT_EQ(misses, ScanAnswer::kMostMisses);
  // Nor when his commands happen to be many.
  for (int scan = 100; scan < 200; ++scan) {
    answer.TakeScan(0.025 * scan);
    EXPECT_TRUE(answer.IsComplete(false, true));
    answer.TakeCommand();
  }
}

TEST(ScanAnswer, WhoMissesAScanNowAndThenIsWaitedForAgain) {
  ScanAnswer answer;
  int misses = 0;
  for (int scan = 0; scan < 1000; ++scan) {
    answer.TakeScan(0.025 * scan);
    if (scan % 100 != 99) answer.TakeCommand();
    if (answer.IsComplete(false, true)) continue;
    answer.GiveUp();
    answer.TakeCommand();
    ++misses;
  }
  EXPECT_EQ(misses, 10);
}

}  // namespace
}  // namespace vfh_astar
