#include "vfh_astar/planning/cost_block_search.h"

#include <gtest/gtest.h>

#include <limits>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "planning/cost_scene.h"
#include "planning/text_map.h"

namespace vfh_astar {
namespace {

class CostBlockSearchTest : public testing::Test {
 protected:
  void SetUp() override {
    if (!search_.is_supported()) {
      GTEST_SKIP() << "this processor has no AVX2, which the search needs";
    }
  }

  std::optional<SearchResult> Run(const Scene& scene, const Cell& start,
                                  const Cell& goal) {
    return search_.Run(scene.costs, scene.passages, start, goal, nullptr);
  }

  CostBlockSearch search_;
};

Cell AnyFreeCell(const Scene& scene, std::mt19937& random) {
  const GridGeometry& geometry = scene.costs.geometry();
  for (;;) {
    const Cell cell{static_cast<int>(random() % geometry.width),
                    static_cast<int>(random() % geometry.height)};
    if (!scene.costs.IsLethal(cell)) return cell;
  }
}

TEST_F(CostBlockSearchTest, AlwaysTellsWhereTheRobotIsRound) {
  std::mt19937 random(8);
  int found = 0;
  int unreachable = 0;
  for (int round = 0; round < 300; ++round) {
    CostModel model;
    model.lethal_clearance = 0.5;
    model.inflation_clearance = 2.9;
    model.weight = 1.0 + round % 4 * 3.0;
    const int width = 1 + static_cast<int>(random() % 120);
    const int height = 1 + static_cast<int>(random() % 120);
    Scene scene(RandomMap(width, height, 0.5, 0.02 * (round % 18), random),
                model, kSmall);
    // Cells beside each other need not have like costs.
    for (int i = round % 3 * width * height / 8; i > 0; --i) {
      scene.costs.Set(AnyFreeCell(scene, random),
                      static_cast<CostMap::Level>(16 + random() % 240));
    }
    const Cell start = AnyFreeCell(scene, random);
    const Cell goal = AnyFreeCell(scene, random);
    const StepCost expected = Dijkstra(scene, start, goal);
    const std::optional<SearchResult> result = Run(scene, start, goal);
    if (!result) {
      ASSERT_EQ(expected, std::numeric_limits<StepCost>::max());
      ++unreachable;
      continue;
    }
    ASSERT_EQ(result->status, SearchStatus::kFound);
    ASSERT_EQ(result->cost, expected);
    ExpectValidPath(scene, *result);
    ++found;
  }
  EXPECT_GT(found, 150);
  EXPECT_GT(unreachable, 20);
}

TEST_F(CostBlockSearchTest, IsRightOrDoesNotTell) {
  std::mt19937 random(9);
  const Footprint footprint{1.6, 1.2, 0.5};
  int found = 0;
  int left_open = 0;
  for (int round = 0; round < 200; ++round) {
    CostModel model;
    model.lethal_clearance = footprint.InscribedRadius() + 0.2;
    model.inflation_clearance = 2.9;
    const Scene scene(RandomMap(60, 50, 0.5, 0.002 * (round % 12), random),
                      model, footprint);
    const Cell start = AnyFreeCell(scene, random);
    const Cell goal = AnyFreeCell(scene, random);
    const StepCost expected = Dijkstra(scene, start, goal);
    const std::optional<SearchResult> result = Run(scene, start, goal);
    if (result) {
      ASSERT_EQ(result->cost, expected);
      ExpectValidPath(scene, *result);
      ++found;
    } else if (expected != std::numeric_limits<StepCost>::max()) {
      ++left_open;
    }
  }
  EXPECT_GT(found, 50);
  EXPECT_GT(left_open, 5);
}

// Two corridors through the same blocks, of which the lower one costs sixteen
// times as much: its estimates run away from those of the upper one, which has
// no exit.
TEST_F(CostBlockSearchTest, CarriesTheDearBesideTheCheap) {
  constexpr int kWidth = 700;
  std::vector<std::string> rows(3, std::string(kWidth, '.'));
  rows[1] = '.' + std::string(kWidth - 1, '#');
  rows[0].back() = '#';
  Scene scene(TextMap(rows), Uniform(), kSmall);
  for (int x = 1; x < kWidth; ++x) {
    scene.costs.Set({x, 0}, CostMap::kMaxLevel);
  }
  const Cell goal{kWidth - 1, 0};
  const std::optional<SearchResult> result = Run(scene, {0, 2}, goal);
  ASSERT_TRUE(result);
  EXPECT_EQ(result->cost, Dijkstra(scene, {0, 2}, goal));
  ExpectValidPath(scene, *result);
}

TEST_F(CostBlockSearchTest, ForgetsTheMapBefore) {
  std::mt19937 random(10);
  for (const int side : {9, 40, 17, 40}) {
    const Scene scene(RandomMap(side, side, 0.5, 0.05, random), Uniform(),
                      kSmall);
    const Cell start = AnyFreeCell(scene, random);
    for (int i = 0; i < 5; ++i) {
      const Cell goal = AnyFreeCell(scene, random);
      const std::optional<SearchResult> result = Run(scene, start, goal);
      const StepCost expected = Dijkstra(scene, start, goal);
      EXPECT_EQ(result ? result->cost : std::numeric_limits<StepCost>::max(),
                expected);
    }
  }
}

}  // namespace
}  // namespace vfh_astar
