#include "vfh_astar/planning/cost_search.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <thread>

#include "planning/cost_scene.h"
#include "planning/text_map.h"
#include "vfh_astar/planning/grid_search.h"

namespace vfh_astar {
namespace {

/// The search by cells, and the one that asks it only when blocks do not tell.
template <typename Search>
class LeastCost : public testing::Test {};

using Searches = testing::Types<GridSearch, CostSearch>;
TYPED_TEST_SUITE(LeastCost, Searches);

TYPED_TEST(LeastCost, GoesStraight) {
  const Scene scene(TextMap({"......"}), Uniform(), kSmall);
  TypeParam search;
  const SearchResult result =
      search.Run(scene.costs, scene.passages, {0, 0}, {5, 0}, nullptr);
  EXPECT_EQ(result.status, SearchStatus::kFound);
  EXPECT_EQ(result.cost, 5 * kFreeStep);
  EXPECT_EQ(result.cells.size(), 6u);
  EXPECT_EQ(result.cells.front(), (Cell{0, 0}));
  EXPECT_EQ(result.cells.back(), (Cell{5, 0}));
}

TYPED_TEST(LeastCost, GoesRoundCorners) {
  const Scene scene(TextMap({"...",  //
                             ".#.",  //
                             "..."}),
                    Uniform(), kSmall);
  TypeParam search;
  const SearchResult result =
      search.Run(scene.costs, scene.passages, {0, 0}, {2, 2}, nullptr);
  EXPECT_EQ(result.cost, 4 * kFreeStep);
}

TYPED_TEST(LeastCost, StartMayBeTheGoal) {
  const Scene scene(TextMap({"..."}), Uniform(), kSmall);
  TypeParam search;
  const SearchResult result =
      search.Run(scene.costs, scene.passages, {1, 0}, {1, 0}, nullptr);
  EXPECT_EQ(result.status, SearchStatus::kFound);
  EXPECT_EQ(result.cost, 0u);
  EXPECT_EQ(result.cells, (std::vector<Cell>{{1, 0}}));
}

TYPED_TEST(LeastCost, KnowsWhatItReached) {
  const Scene scene(TextMap({"..#."}), Uniform(), kSmall);
  TypeParam search;
  const SearchResult result =
      search.Run(scene.costs, scene.passages, {0, 0}, {3, 0}, nullptr);
  EXPECT_EQ(result.status, SearchStatus::kExhausted);
  EXPECT_TRUE(result.cells.empty());
  EXPECT_TRUE(search.IsReached({1, 0}));
  EXPECT_FALSE(search.IsReached({3, 0}));
}

TYPED_TEST(LeastCost, CostsWhatDijkstraFinds) {
  std::mt19937 random(3);
  TypeParam search;
  int found = 0;
  int unreachable = 0;
  int rounds = 0;
  for (const Footprint& footprint :
       {kSmall, Footprint{1.6, 1.2, 0.5}, Footprint{0.4, 0.4, 1.3}}) {
    for (const UnknownSpace unknown :
         {UnknownSpace::kFree, UnknownSpace::kForbidden,
          UnknownSpace::kPriced}) {
      for (int round = 0; round < 60; ++round, ++rounds) {
        CostModel model;
        model.lethal_clearance = footprint.InscribedRadius() + 0.2;
        model.inflation_clearance = 2.9;
        model.weight = 1.0 + round % 4 * 2.5;
        model.unknown = unknown;
        const int width = 10 + static_cast<int>(random() % 40);
        const int height = 10 + static_cast<int>(random() % 40);
        const Scene scene(
            RandomMap(width, height, 0.5, 0.002 * (round % 12), random), model,
            footprint);
        const auto any_cell = [&] {
          return Cell{static_cast<int>(random() % width),
                      static_cast<int>(random() % height)};
        };
        const Cell start = any_cell();
        const Cell goal = any_cell();
        if (scene.costs.IsLethal(start)) continue;
        const SearchResult result =
            search.Run(scene.costs, scene.passages, start, goal, nullptr);
        const StepCost expected = Dijkstra(scene, start, goal);
        if (result.status == SearchStatus::kExhausted) {
          ASSERT_EQ(expected, std::numeric_limits<StepCost>::max());
          ++unreachable;
          continue;
        }
        ++found;
        ASSERT_EQ(result.cost, expected);
        ExpectValidPath(scene, result);
      }
    }
  }
  EXPECT_GT(found, rounds / 4);
  EXPECT_GT(unreachable, rounds / 20);
}

TYPED_TEST(LeastCost, RefusesAPassageTooNarrowForTheRectangle) {
  // The gap below is one cell: room for the inscribed circle, not for the
  // width of the robot. The one above is five cells.
  std::vector<std::string> rows(25, std::string(30, '.'));
  for (int y = 0; y < 25; ++y) {
    if (y == 20 || (y >= 2 && y <= 6)) continue;
    for (int x = 12; x < 17; ++x) rows[y][x] = '#';
  }
  CostModel model = Uniform();
  model.lethal_clearance = 0.8;
  const auto row_of_passage = [&](const Footprint& footprint) {
    const Scene scene(TextMap(rows), model, footprint);
    TypeParam search;
    const SearchResult result =
        search.Run(scene.costs, scene.passages, {5, 4}, {24, 4}, nullptr);
    for (const Cell& cell : result.cells) {
      if (cell.x == 14) return cell.y;
    }
    return -1;
  };
  EXPECT_EQ(row_of_passage({0.8, 0.8, 0.8}), 4);
  EXPECT_GE(row_of_passage({0.8, 0.8, 1.6}), 18);
}

TYPED_TEST(LeastCost, IsCancelledFromAnotherThread) {
  // Free but for a wall around the goal, so that all must be searched.
  GridGeometry geometry;
  geometry.resolution = 1.0;
  geometry.width = geometry.height = 3000;
  OccupancyGrid map(geometry, 0);
  for (int i = 2900; i < 3000; ++i) map[{2900, i}] = map[{i, 2900}] = 100;
  const Scene scene(map, Uniform(), kSmall);
  TypeParam search;
  std::atomic<bool> cancelled{false};
  std::thread canceller([&cancelled] {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    cancelled = true;
  });
  const SearchResult result =
      search.Run(scene.costs, scene.passages, {0, 0}, {2990, 2990}, &cancelled);
  canceller.join();
  EXPECT_EQ(result.status, SearchStatus::kCancelled);
  EXPECT_LT(result.nodes_expanded, 8000000);
  // The search after it is not disturbed.
  const SearchResult next =
      search.Run(scene.costs, scene.passages, {0, 0}, {9, 9}, nullptr);
  EXPECT_EQ(next.status, SearchStatus::kFound);
}

}  // namespace
}  // namespace vfh_astar
