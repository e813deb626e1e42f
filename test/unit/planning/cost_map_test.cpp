#include "vfh_astar/planning/cost_map.h"

#include <gtest/gtest.h>

#include <random>

#include "planning/text_map.h"

namespace vfh_astar {
namespace {

TEST(CostMap, FactorFallsFromTheLethalZoneOutwards) {
  CostModel model;
  model.lethal_clearance = 0.2;
  model.inflation_clearance = 1.0;
  model.weight = 5.0;
  const CostMap costs(model);
  EXPECT_EQ(costs.LevelOf(0.0), CostMap::kLethal);
  EXPECT_EQ(costs.LevelOf(0.19), CostMap::kLethal);
  EXPECT_EQ(costs.LevelOf(0.2f), 5 * CostMap::kUnit);
  // Half way the square leaves a quarter of what the weight adds: 1 + 4 / 4.
  EXPECT_EQ(costs.LevelOf(0.6), 2 * CostMap::kUnit);
  EXPECT_EQ(costs.LevelOf(1.0), CostMap::kUnit);
  EXPECT_EQ(costs.LevelOf(7.0), CostMap::kUnit);
}

TEST(CostMap, UnknownSpaceIsForbiddenFreeOrPriced) {
  ClearanceMap clearance(65, 2.0);
  clearance.SetMap(TextMap({".?"}));
  CostModel model;
  const auto level = [&](UnknownSpace unknown) {
    model.unknown = unknown;
    CostMap costs(model);
    costs.SetMap(clearance);
    EXPECT_EQ((costs[{0, 0}]), CostMap::kUnit);
    return costs[{1, 0}];
  };
  model.unknown_price = 1.5;
  EXPECT_EQ(level(UnknownSpace::kFree), CostMap::kUnit);
  EXPECT_EQ(level(UnknownSpace::kForbidden), CostMap::kLethal);
  EXPECT_EQ(level(UnknownSpace::kPriced), 40);
}

TEST(CostMap, BorderIsLethal) {
  ClearanceMap clearance(65, 2.0);
  clearance.SetMap(TextMap({"...", "..."}));
  CostMap costs({});
  costs.SetMap(clearance);
  for (int x = -1; x <= 3; ++x) {
    EXPECT_TRUE(costs.IsLethal({x, -1}));
    EXPECT_TRUE(costs.IsLethal({x, 2}));
  }
  for (int y = -1; y <= 2; ++y) {
    EXPECT_TRUE(costs.IsLethal({-1, y}));
    EXPECT_TRUE(costs.IsLethal({3, y}));
  }
}

TEST(CostMap, DiagonalsCutNoCorner) {
  ClearanceMap clearance(65, 2.0);
  clearance.SetMap(TextMap({"...",  //
                            "..#",  //
                            "..."}));
  CostModel model;
  model.lethal_clearance = 0.5;
  CostMap costs(model);
  costs.SetMap(clearance);
  EXPECT_FALSE(costs.IsOpen({1, 1}, 0));  // Into the obstacle,
  EXPECT_FALSE(costs.IsOpen({1, 1}, 1));  // past its corner,
  EXPECT_TRUE(costs.IsOpen({1, 1}, 2));   // away from it,
  EXPECT_TRUE(costs.IsOpen({1, 1}, 3));
  EXPECT_FALSE(costs.IsOpen({1, 2}, 7));
  EXPECT_FALSE(costs.IsOpen({0, 0}, 4));  // and out of the map.
}

}  // namespace
}  // namespace vfh_astar
