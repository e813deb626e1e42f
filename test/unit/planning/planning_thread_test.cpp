#include "vfh_astar/planning/planning_thread.h"

#include <gtest/gtest.h>

#include <atomic>
#include <future>
#include <thread>

namespace vfh_astar {
namespace {

OccupancyGrid FreeMap(int side) {
  GridGeometry geometry;
  geometry.resolution = 0.1;
  geometry.width = geometry.height = side;
  return OccupancyGrid(geometry, 0);
}

/// All of it has to be searched to learn that (side - 10, side - 10) cannot be
/// reached: a second or so.
OccupancyGrid MapWithLockedCorner(int side) {
  OccupancyGrid map = FreeMap(side);
  for (int i = side - 40; i < side; ++i) {
    map[{side - 40, i}] = map[{i, side - 40}] = 100;
  }
  return map;
}

PlanRequest Between(const Pose2D& start, const Pose2D& goal) {
  PlanRequest request;
  request.start = start;
  request.goal = goal;
  return request;
}

/// To read a large one takes longer than the tests below wait.
void WaitTillItHasTheMap(PlanningThread& planning) {
  ASSERT_EQ(planning.Plan(Between({1, 1, 0}, {2, 2, 0})).outcome,
            Outcome::kSuccess);
}

/// What comes in another thread.
class Answer {
 public:
  PlanningThread::TakeResult Taker() {
    return [this](const PlanResult& result) { promise_.set_value(result); };
  }
  PlanResult Wait() { return promise_.get_future().get(); }

 private:
  std::promise<PlanResult> promise_;
};

TEST(PlanningThread, AnswersRequestsAndQuestions) {
  PlanningThread planning(PathPlannerParameters{});
  EXPECT_EQ(planning.Plan(Between({1, 1, 0}, {8, 8, 0})).outcome,
            Outcome::kNoMap);
  planning.SetMap(FreeMap(100));
  EXPECT_EQ(planning.Plan(Between({1, 1, 0}, {8, 8, 0})).outcome,
            Outcome::kSuccess);
  Answer answer;
  planning.Request(Between({1, 1, 0}, {8, 1, 0}), answer.Taker());
  const PlanResult result = answer.Wait();
  EXPECT_EQ(result.outcome, Outcome::kSuccess);
  EXPECT_NEAR(result.cost, 7.0, 1e-6);
}

TEST(PlanningThread, PlansOnTheMapAsItIsByThen) {
  PlanningThread planning(PathPlannerParameters{});
  planning.SetMap(FreeMap(100));
  // A wall from side to side at x = 5, and open again.
  const cv::Rect wall(50, 0, 1, 100);
  planning.UpdateMap({wall, std::vector<std::int8_t>(100, 100)});
  EXPECT_EQ(planning.Plan(Between({1, 1, 0}, {8, 8, 0})).outcome,
            Outcome::kNoPath);
  planning.UpdateMap({wall, std::vector<std::int8_t>(100, 0)});
  EXPECT_EQ(planning.Plan(Between({1, 1, 0}, {8, 8, 0})).outcome,
            Outcome::kSuccess);
  planning.UpdateMap({wall, std::vector<std::int8_t>(100, 100)});
  planning.SetMap(FreeMap(100));
  EXPECT_EQ(planning.Plan(Between({1, 1, 0}, {8, 8, 0})).outcome,
            Outcome::kSuccess);
}

TEST(PlanningThread, KnowsWhatItHasGatheredWhenAsked) {
  PlanningThread planning(PathPlannerParameters{});
  planning.SetMap(FreeMap(100));
  // A wall that grows from side to side, cell by cell.
  for (int y = 0; y < 100; ++y) {
    planning.UpdateMap({{50, y, 1, 1}, {100}});
    if (y % 40 != 1 && y != 99) continue;
    EXPECT_EQ(planning.Plan(Between({1, 1, 0}, {8, 8, 0})).outcome,
              y == 99 ? Outcome::kNoPath : Outcome::kSuccess)
        << y;
  }
}

TEST(PlanningThread, KeepsToThePathOfTheRequestBefore) {
  // Two ways round an island, the upper one a little shorter at first.
  OccupancyGrid map = FreeMap(100);
  for (int y = 30; y < 69; ++y) {
    for (int x = 30; x < 70; ++x) map[{x, y}] = 100;
  }
  PlanningThread planning(PathPlannerParameters{});
  planning.SetMap(map);
  Answer first;
  planning.Request(Between({1, 5, 0}, {9, 5, 0}), first.Taker());
  const PlanResult upper = first.Wait();
  // Now the lower one is, by less than it would have to be.
  std::vector<std::int8_t> row(40, 100);
  planning.UpdateMap({{30, 69, 40, 1}, row});
  planning.UpdateMap({{30, 70, 40, 1}, row});
  Answer second;
  planning.Request(Between({1, 5, 0}, {9, 5, 0}), second.Taker());
  const PlanResult kept = second.Wait();
  EXPECT_TRUE(kept.kept);
  EXPECT_GT(kept.cost, upper.cost);
  EXPECT_LT(planning.Plan(Between({1, 5, 0}, {9, 5, 0})).cost, kept.cost);
}

TEST(PlanningThread, ANewerRequestCutsShortTheOneBefore) {
  constexpr int kSide = 3000;
  PlanningThread planning(PathPlannerParameters{});
  planning.SetMap(MapWithLockedCorner(kSide));
  WaitTillItHasTheMap(planning);
  std::atomic<bool> is_first_answered{false};
  planning.Request(Between({1, 1, 0}, {298, 298, 0}),
                   [&](const PlanResult&) { is_first_answered = true; });
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  Answer second;
  planning.Request(Between({1, 1, 0}, {2, 2, 0}), second.Taker());
  EXPECT_EQ(second.Wait().outcome, Outcome::kSuccess);
  EXPECT_FALSE(is_first_answered);
}

TEST(PlanningThread, AQuestionMakesWayAndIsAnsweredLater) {
  PlanningThread planning(PathPlannerParameters{});
  planning.SetMap(MapWithLockedCorner(3000));
  WaitTillItHasTheMap(planning);
  std::future<PlanResult> question = std::async(std::launch::async, [&] {
    return planning.Plan(Between({1, 1, 0}, {298, 298, 0}));
  });
  for (int i = 0; i < 5; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    Answer answer;
    planning.Request(Between({1, 1, 0}, {2, 2, 0}), answer.Taker());
    EXPECT_EQ(answer.Wait().outcome, Outcome::kSuccess);
    EXPECT_NE(question.wait_for(std::chrono::seconds(0)),
              std::future_status::ready);
  }
  EXPECT_EQ(question.get().outcome, Outcome::kNoPath);
}

TEST(PlanningThread, InflatesTheMapItHas) {
  OccupancyGrid map = FreeMap(50);
  map[{20, 20}] = 100;
  PlanningThread planning(PathPlannerParameters{});
  planning.SetMap(map);
  std::promise<OccupancyGrid> inflated;
  planning.InflateMap(
      [&](const OccupancyGrid& taken) { inflated.set_value(taken); });
  const OccupancyGrid result = inflated.get_future().get();
  EXPECT_EQ((result[{20, 20}]), 100);
  EXPECT_EQ((result[{21, 20}]), 99);
  EXPECT_EQ((result[{40, 40}]), 0);
}

TEST(PlanningThread, AnswersWhoWaitsWhenItIsClosed) {
  PlanningThread planning(PathPlannerParameters{});
  planning.SetMap(MapWithLockedCorner(3000));
  WaitTillItHasTheMap(planning);
  std::future<PlanResult> question = std::async(std::launch::async, [&] {
    return planning.Plan(Between({1, 1, 0}, {298, 298, 0}));
  });
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  planning.Close();
  EXPECT_EQ(question.get().outcome, Outcome::kCancelled);
  EXPECT_EQ(planning.Plan(Between({1, 1, 0}, {2, 2, 0})).outcome,
            Outcome::kCancelled);
}

}  // namespace
}  // namespace vfh_astar
