#include "vfh_astar/planning/uniform_search.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <tuple>
#include <type_traits>

#include "planning/text_map.h"
#include "vfh_astar/planning/block_search.h"
#include "vfh_astar/planning/cost_map.h"
#include "vfh_astar/planning/jump_point_search.h"

namespace vfh_astar {
namespace {

/// As on a processor without AVX2.
class BaselineBlockSearch : public BlockSearch {
 public:
  BaselineBlockSearch(int width, int height)
      : BlockSearch(width, height, BaselineBlockKernel()) {}
};

/// The searches that must agree, and the one that chooses between them.
template <typename Search>
class UniformCost : public testing::Test {
 protected:
  static Search SearchOn(const OccupancyGrid& map);
};

using Searches = testing::Types<JumpPointSearch, BlockSearch,
                                BaselineBlockSearch, UniformSearch>;
TYPED_TEST_SUITE(UniformCost, Searches);

template <typename Search>
Search UniformCost<Search>::SearchOn(const OccupancyGrid& map) {
  Search search(map.geometry().width, map.geometry().height);
  for (int y = 0; y < map.geometry().height; ++y) {
    for (int x = 0; x < map.geometry().width; ++x) {
      search.SetBlocked({x, y}, map[{x, y}] == 100);
    }
  }
  return search;
}

bool IsOpen(const OccupancyGrid& map, const Cell& from, const Cell& step) {
  for (const Cell& cell :
       {Cell{from.x + step.x, from.y + step.y}, Cell{from.x + step.x, from.y},
        Cell{from.x, from.y + step.y}}) {
    if (!map.geometry().Contains(cell) || map[cell] == 100) return false;
  }
  return true;
}

/// Dijkstra's algorithm as in the textbook; infinite when there is no path.
double Dijkstra(const OccupancyGrid& map, const Cell& start, const Cell& goal) {
  Grid<double> lengths(map.geometry(), INFINITY);
  std::set<std::tuple<double, int, int>> open = {{0.0, start.x, start.y}};
  lengths[start] = 0.0;
  while (!open.empty()) {
    const auto [length, x, y] = *open.begin();
    open.erase(open.begin());
    for (const Cell& step : kSteps) {
      if (!IsOpen(map, {x, y}, step)) continue;
      const Cell next{x + step.x, y + step.y};
      const double sum = length + std::hypot(step.x, step.y);
      if (sum >= lengths[next]) continue;
      open.erase({lengths[next], next.x, next.y});
      lengths[next] = sum;
      open.emplace(sum, next.x, next.y);
    }
  }
  return lengths[goal];
}

template <typename Search>
bool IsDecided(const Search& search) {
  if constexpr (std::is_base_of_v<BlockSearch, Search>) {
    return search.is_decided();
  }
  return true;
}

void ExpectValidPath(const OccupancyGrid& map, const JumpPointResult& result,
                     const Cell& start, const Cell& goal) {
  ASSERT_EQ(result.cells.front(), start);
  ASSERT_EQ(result.cells.back(), goal);
  double length = 0.0;
  for (std::size_t i = 1; i < result.cells.size(); ++i) {
    const Cell& from = result.cells[i - 1];
    const Cell step{result.cells[i].x - from.x, result.cells[i].y - from.y};
    ASSERT_LE(std::abs(step.x), 1);
    ASSERT_LE(std::abs(step.y), 1);
    ASSERT_TRUE(IsOpen(map, from, step));
    length += std::hypot(step.x, step.y);
  }
  EXPECT_NEAR(result.length, length, 1e-9);
}

TYPED_TEST(UniformCost, GoesDiagonallyThenStraight) {
  const OccupancyGrid map = TextMap({"....",  //
                                     "....",  //
                                     "...."});
  TypeParam search = this->SearchOn(map);
  const JumpPointResult result = search.Run({0, 0}, {3, 2});
  ASSERT_TRUE(result.is_found);
  EXPECT_NEAR(result.length, 1.0 + 2.0 * std::sqrt(2.0), 1e-12);
  ExpectValidPath(map, result, {0, 0}, {3, 2});
}

TYPED_TEST(UniformCost, CutsNoCorner) {
  const OccupancyGrid map = TextMap({"...",  //
                                     ".#.",  //
                                     "..."});
  TypeParam search = this->SearchOn(map);
  EXPECT_EQ(search.Run({0, 0}, {2, 2}).length, 4.0);
  EXPECT_EQ(search.Run({1, 0}, {1, 2}).length, 4.0);
}

TYPED_TEST(UniformCost, SaysWhenThereIsNoPath) {
  TypeParam search = this->SearchOn(TextMap({"..#.", "..#."}));
  EXPECT_FALSE(search.Run({0, 0}, {3, 0}).is_found);
  search.SetBlocked({2, 1}, false);
  EXPECT_NEAR(search.Run({0, 0}, {3, 0}).length, 3.0 + std::sqrt(2.0), 1e-12);
}

TYPED_TEST(UniformCost, StartMayBeTheGoal) {
  TypeParam search = this->SearchOn(TextMap({"..."}));
  const JumpPointResult result = search.Run({1, 0}, {1, 0});
  EXPECT_TRUE(result.is_found);
  EXPECT_EQ(result.length, 0.0);
  EXPECT_EQ(result.cells.size(), 1u);
}

TYPED_TEST(UniformCost, IsAsShortAsDijkstra) {
  std::mt19937 random(17);
  int found = 0;
  int unreachable = 0;
  int undecided = 0;
  for (int round = 0; round < 240; ++round) {
    // Some wider and higher than the words of a scan.
    const int width =
        round % 3 == 0 ? 190 : 5 + static_cast<int>(random() % 70);
    const int height =
        round % 3 == 1 ? 150 : 3 + static_cast<int>(random() % 40);
    OccupancyGrid map =
        RandomMap(width, height, 1.0, 0.04 * (round % 12), random);
    TypeParam search = this->SearchOn(map);
    for (int query = 0; query < 8; ++query) {
      const auto any_cell = [&] {
        return Cell{static_cast<int>(random() % width),
                    static_cast<int>(random() % height)};
      };
      const Cell start = any_cell();
      const Cell goal = any_cell();
      if (map[start] == 100 || map[goal] == 100) continue;
      const JumpPointResult result = search.Run(start, goal);
      if (!IsDecided(search)) {
        ++undecided;
        continue;
      }
      const double expected = Dijkstra(map, start, goal);
      ASSERT_EQ(result.is_found, std::isfinite(expected));
      if (!result.is_found) {
        ++unreachable;
      } else {
        ++found;
        ASSERT_NEAR(result.length, expected, 1e-3);
        ExpectValidPath(map, result, start, goal);
      }
      // The map changes between two searches.
      for (int edit = 0; edit < 5; ++edit) {
        const Cell cell = any_cell();
        map[cell] = map[cell] == 100 ? 0 : 100;
        search.SetBlocked(cell, map[cell] == 100);
      }
    }
  }
  EXPECT_GT(found, 400);
  EXPECT_GT(unreachable, 100);
  EXPECT_LT(undecided, 30);
}

// Far enough for the search to pass through many bands of its queue.
TEST(BlockSearch, IsAsShortAsJumpPointsAcrossAFieldOfScatteredCells) {
  constexpr int kSide = 400;
  std::mt19937 random(23);
  BlockSearch by_block(kSide, kSide);
  JumpPointSearch jumping(kSide, kSide);
  std::vector<Cell> free;
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      const bool is_blocked = random() % 4 == 0;
      by_block.SetBlocked({x, y}, is_blocked);
      jumping.SetBlocked({x, y}, is_blocked);
      if (!is_blocked) free.push_back({x, y});
    }
  }
  int found = 0;
  for (int query = 0; query < 40; ++query) {
    const Cell start = free[random() % free.size()];
    const Cell goal = free[random() % free.size()];
    const JumpPointResult expected = jumping.Run(start, goal);
    const JumpPointResult result = by_block.Run(start, goal);
    ASSERT_TRUE(by_block.is_decided());
    ASSERT_EQ(result.is_found, expected.is_found);
    if (!result.is_found) continue;
    ++found;
    ASSERT_NEAR(result.length, expected.length, 1e-3);
  }
  EXPECT_GT(found, 20);
}

/// Lanes between walls, with a gap at the one end and the other by turns.
OccupancyGrid Comb(int width, int height) {
  GridGeometry geometry;
  geometry.resolution = 1.0;
  geometry.width = width;
  geometry.height = height;
  OccupancyGrid map(geometry, 0);
  for (int y = 1; y < height; y += 2) {
    for (int x = 0; x < width; ++x) map[{x, y}] = 100;
    map[{y % 4 == 1 ? width - 1 : 0, y}] = 0;
  }
  return map;
}

TEST(BlockSearch, SaysWhenItsNumbersDoNotReach) {
  // Going to and fro, cells two apart are 10 and 90 cells of way apart.
  for (const int width : {10, 90}) {
    const OccupancyGrid map = Comb(width, 15);
    BlockSearch search(width, 15);
    for (int y = 0; y < 15; ++y) {
      for (int x = 0; x < width; ++x) {
        search.SetBlocked({x, y}, map[{x, y}] == 100);
      }
    }
    const Cell goal{width - 1, 14};
    const JumpPointResult result = search.Run({0, 0}, goal);
    ASSERT_EQ(search.is_decided(), width == 10);
    ASSERT_EQ(result.is_found, width == 10);
    if (!result.is_found) continue;
    EXPECT_NEAR(result.length, Dijkstra(map, {0, 0}, goal), 1e-3);
  }
}

TEST(BlockSearch, IsExactUpToTheEndOfItsNumbers) {
  std::mt19937 random(23);
  int decided = 0;
  int undecided = 0;
  for (int round = 0; round < 1000; ++round) {
    // Nearly as far apart as a block's numbers allow, and a few ways through
    // the walls, so that what comes in late is shorter.
    const int width = 8 + static_cast<int>(random() % 22);
    const int height = 9 + static_cast<int>(random() % 40);
    OccupancyGrid map = Comb(width, height);
    for (int gap = 0; gap < round % 8; ++gap) {
      map[{static_cast<int>(random() % width),
           static_cast<int>(random() % height)}] = 0;
    }
    BlockSearch search(width, height);
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        search.SetBlocked({x, y}, map[{x, y}] == 100);
      }
    }
    const Cell start{static_cast<int>(random() % width), 0};
    const Cell goal{static_cast<int>(random() % width), height / 4 * 2};
    const JumpPointResult result = search.Run(start, goal);
    if (!search.is_decided()) {
      ++undecided;
      continue;
    }
    ++decided;
    ASSERT_NEAR(result.length, Dijkstra(map, start, goal), 1e-3) << round;
    ExpectValidPath(map, result, start, goal);
  }
  EXPECT_GT(decided, 100);
  EXPECT_GT(undecided, 20);
}

TEST(UniformSearch, TellsScatteredObstaclesFromWalls) {
  std::mt19937 random(5);
  UniformSearch search(200, 200);
  EXPECT_FALSE(search.IsScattered({0, 0}, {199, 199}));
  // Walls are not scattered, however close they are.
  for (int x = 0; x < 200; x += 3) {
    for (int y = 0; y < 190; ++y) search.SetBlocked({x, y}, true);
  }
  EXPECT_FALSE(search.IsScattered({0, 0}, {199, 199}));
  for (int y = 0; y < 200; ++y) {
    for (int x = 0; x < 200; ++x) {
      search.SetBlocked({x, y}, random() % 4 == 0);
    }
  }
  EXPECT_TRUE(search.IsScattered({0, 0}, {199, 199}));
}

}  // namespace
}  // namespace vfh_astar
