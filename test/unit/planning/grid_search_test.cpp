#include "vfh_astar/planning/grid_search.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <set>
#include <thread>
#include <tuple>

#include "planning/text_map.h"

namespace vfh_astar {
namespace {

ClearanceMap ClearanceOf(const OccupancyGrid& map) {
  ClearanceMap clearance(65, 3.0);
  clearance.SetMap(map);
  return clearance;
}

/// What a search needs to know.
struct Scene {
  Scene(const OccupancyGrid& map, const CostModel& model,
        const Footprint& footprint)
      : clearance(ClearanceOf(map)),
        costs(model),
        passages(footprint, {-100.0, -100.0, 0.0}, clearance) {
    costs.SetMap(clearance);
  }

  ClearanceMap clearance;
  CostMap costs;
  PassageCheck passages;
};

const Footprint kSmall{0.1, 0.1, 0.1};

CostModel Uniform() {
  CostModel model;
  model.lethal_clearance = 0.5;
  model.weight = 1.0;
  return model;
}

/// Dijkstra's algorithm as in the textbook.
StepCost Dijkstra(const Scene& scene, const Cell& start, const Cell& goal) {
  constexpr StepCost kNone = std::numeric_limits<StepCost>::max();
  Grid<StepCost> costs(scene.costs.geometry(), kNone);
  std::set<std::tuple<StepCost, int, int>> open = {{0, start.x, start.y}};
  costs[start] = 0;
  while (!open.empty()) {
    const auto [cost, x, y] = *open.begin();
    open.erase(open.begin());
    for (int direction = 0; direction < kDirections; ++direction) {
      const Cell next{x + kSteps[direction].x, y + kSteps[direction].y};
      if (!scene.costs.IsOpen({x, y}, direction)) continue;
      if (!scene.passages.Fits(next, direction)) continue;
      const StepCost sum =
          cost + CostOfStep(scene.costs[{x, y}], scene.costs[next], direction);
      if (sum >= costs[next]) continue;
      open.erase({costs[next], next.x, next.y});
      costs[next] = sum;
      open.emplace(sum, next.x, next.y);
    }
  }
  return costs[goal];
}

TEST(GridSearch, GoesStraight) {
  const Scene scene(TextMap({"......"}), Uniform(), kSmall);
  GridSearch search;
  const SearchResult result =
      search.Run(scene.costs, scene.passages, {0, 0}, {5, 0}, nullptr);
  EXPECT_EQ(result.status, SearchStatus::kFound);
  EXPECT_EQ(result.cost, 5 * kFreeStep);
  EXPECT_EQ(result.cells.size(), 6u);
  EXPECT_EQ(result.cells.front(), (Cell{0, 0}));
  EXPECT_EQ(result.cells.back(), (Cell{5, 0}));
}

TEST(GridSearch, GoesRoundCorners) {
  const Scene scene(TextMap({"...",  //
                             ".#.",  //
                             "..."}),
                    Uniform(), kSmall);
  GridSearch search;
  const SearchResult result =
      search.Run(scene.costs, scene.passages, {0, 0}, {2, 2}, nullptr);
  EXPECT_EQ(result.cost, 4 * kFreeStep);
}

TEST(GridSearch, StartMayBeTheGoal) {
  const Scene scene(TextMap({"..."}), Uniform(), kSmall);
  GridSearch search;
  const SearchResult result =
      search.Run(scene.costs, scene.passages, {1, 0}, {1, 0}, nullptr);
  EXPECT_EQ(result.status, SearchStatus::kFound);
  EXPECT_EQ(result.cost, 0u);
  EXPECT_EQ(result.cells, (std::vector<Cell>{{1, 0}}));
}

TEST(GridSearch, KnowsWhatItReached) {
  const Scene scene(TextMap({"..#."}), Uniform(), kSmall);
  GridSearch search;
  const SearchResult result =
      search.Run(scene.costs, scene.passages, {0, 0}, {3, 0}, nullptr);
  EXPECT_EQ(result.status, SearchStatus::kExhausted);
  EXPECT_TRUE(result.cells.empty());
  EXPECT_TRUE(search.IsReached({1, 0}));
  EXPECT_FALSE(search.IsReached({3, 0}));
}

/// A cost that is really that of the path, along open steps.
void ExpectValidPath(const Scene& scene, const SearchResult& result) {
  StepCost sum = 0;
  for (std::size_t i = 1; i < result.cells.size(); ++i) {
    const Cell& from = result.cells[i - 1];
    const Cell& to = result.cells[i];
    int direction = 0;
    while (direction < kDirections &&
           kSteps[direction] != Cell{to.x - from.x, to.y - from.y}) {
      ++direction;
    }
    ASSERT_LT(direction, kDirections);
    EXPECT_TRUE(scene.costs.IsOpen(from, direction));
    EXPECT_TRUE(scene.passages.Fits(to, direction));
    sum += CostOfStep(scene.costs[from], scene.costs[to], direction);
  }
  EXPECT_EQ(sum, result.cost);
}

TEST(GridSearch, CostsWhatDijkstraFinds) {
  std::mt19937 random(3);
  GridSearch search;
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

TEST(GridSearch, RefusesAPassageTooNarrowForTheRectangle) {
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
    GridSearch search;
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

TEST(GridSearch, IsCancelledFromAnotherThread) {
  // Free but for a wall around the goal, so that all must be searched.
  GridGeometry geometry;
  geometry.resolution = 1.0;
  geometry.width = geometry.height = 3000;
  OccupancyGrid map(geometry, 0);
  for (int i = 2900; i < 3000; ++i) map[{2900, i}] = map[{i, 2900}] = 100;
  const Scene scene(map, Uniform(), kSmall);
  GridSearch search;
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
