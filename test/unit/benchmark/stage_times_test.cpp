#include "benchmark/stage_times.h"

#include <gtest/gtest.h>

#include <set>

namespace vfh_astar {
namespace {

TEST(StageTimer, AddsOneTimeToItsStage) {
  StageTimes times;
  { const StageTimer timer(&times, Stage::kPlan); }
  StageTimer stopped(&times, Stage::kFit);
  stopped.Stop();
  stopped.Stop();
  EXPECT_EQ(times.Of(Stage::kPlan).size(), 1u);
  EXPECT_EQ(times.Of(Stage::kFit).size(), 1u);
  EXPECT_TRUE(times.Of(Stage::kControlTick).empty());
}

TEST(StageTimer, CountsNothingWhenDiscardedOrNobodyAsks) {
  StageTimes times;
  {
    StageTimer discarded(&times, Stage::kMapInsert);
    discarded.Discard();
    const StageTimer unasked(nullptr, Stage::kMapInsert);
  }
  EXPECT_TRUE(times.Of(Stage::kMapInsert).empty());
}

TEST(StageTimer, MoreWorkTakesLonger) {
  StageTimes times;
  volatile double sum = 0.0;
  for (const int count : {1000, 1000000}) {
    const StageTimer timer(&times, Stage::kPlan);
    for (int i = 0; i < count; ++i) sum = sum + i;
  }
  const std::vector<double>& taken = times.Of(Stage::kPlan);
  ASSERT_EQ(taken.size(), 2u);
  EXPECT_GT(taken[0], 0.0);
  EXPECT_GT(taken[1], 50.0 * taken[0]);
}

TEST(Stage, EveryOneHasANameOfItsOwn) {
  std::set<std::string> names;
  for (std::size_t i = 0; i < kStageCount; ++i) {
    names.insert(ToString(static_cast<Stage>(i)));
  }
  EXPECT_EQ(names.size(), kStageCount);
  EXPECT_EQ(names.count(""), 0u);
}

}  // namespace
}  // namespace vfh_astar
