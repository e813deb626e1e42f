#include "vfh_astar/mapping/log_odds_grid.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <random>

namespace vfh_astar {
namespace {

GridGeometry Geometry(int width, int height) {
  GridGeometry geometry;
  geometry.resolution = 0.1;
  geometry.origin = Eigen::Vector2d(-2.0, 1.0);
  geometry.width = width;
  geometry.height = height;
  return geometry;
}

TEST(LogOdds, ConvertsToProbabilityAndBack) {
  EXPECT_EQ(ToLogOdds(0.5), kEvenOdds);
  // ln(0.8 / 0.2) = 1.386 is 28 steps of 0.05.
  EXPECT_EQ(ToLogOdds(0.8), kEvenOdds + 28);
  EXPECT_EQ(ToLogOdds(0.2), kEvenOdds - 28);
  EXPECT_NEAR(ToProbability(kEvenOdds + 28), 0.8, 0.005);
  EXPECT_EQ(ToProbability(kUnexplored), -1.0);
  EXPECT_EQ(ToLogOdds(1e-9), 1);
  EXPECT_EQ(ToLogOdds(1.0 - 1e-9), 255);
}

TEST(LogOdds, PublishedPercentageComesBack) {
  EXPECT_EQ(ToOccupancy(kUnexplored), kUnknown);
  EXPECT_EQ(ToOccupancy(kEvenOdds), 50);
  for (const std::int8_t exact : {-1, 0, 100}) {
    EXPECT_EQ(ToOccupancy(FromOccupancy(exact)), exact);
  }
  for (int percent = 0; percent <= 100; ++percent) {
    EXPECT_LE(
        std::abs(ToOccupancy(FromOccupancy(static_cast<std::int8_t>(percent))) -
                 percent),
        1);
  }
}

TEST(LogOddsGrid, StartsUnexplored) {
  const LogOddsGrid grid(Geometry(70, 3));
  EXPECT_EQ((grid[{69, 2}]), kUnexplored);
  EXPECT_EQ(grid.Probability({0, 0}), -1.0);
  EXPECT_EQ(grid.Probability({70, 0}), -1.0);
  EXPECT_EQ(grid.Probability({0, -1}), -1.0);
  EXPECT_EQ(grid.FindTile(1, 0), nullptr);
}

TEST(LogOddsGrid, CopiesShareTilesUntilOneWrites) {
  LogOddsGrid grid(Geometry(200, 200));
  grid.Set({10, 10}, 200);
  grid.Set({150, 150}, 50);
  LogOddsGrid copy = grid;
  copy.Set({11, 10}, 210);
  EXPECT_EQ((grid[{11, 10}]), kUnexplored);
  EXPECT_EQ((copy[{10, 10}]), 200);
  EXPECT_NE(copy.FindTile(0, 0), grid.FindTile(0, 0));
  EXPECT_EQ(copy.FindTile(2, 2), grid.FindTile(2, 2));
}

TEST(LogOddsGrid, GrowsOnEverySideWithoutMovingTiles) {
  std::mt19937 random(5);
  LogOddsGrid grid(Geometry(100, 90));
  Grid<LogOdds> reference(grid.geometry(), kUnexplored);
  for (int i = 0; i < 500; ++i) {
    const Cell cell{static_cast<int>(random() % 100),
                    static_cast<int>(random() % 90)};
    reference[cell] = static_cast<LogOdds>(1 + random() % 255);
    grid.Set(cell, reference[cell]);
  }
  const Eigen::Vector2d point = grid.geometry().ToWorld({42, 17});
  const LogOddsGrid::Tile* tile = grid.FindTile(0, 1);

  EXPECT_EQ(grid.GrowToHold({0, 0, 100, 90}), (Cell{0, 0}));
  EXPECT_EQ(grid.geometry(), Geometry(100, 90));

  const Cell moved = grid.GrowToHold({-1, -300, 103, 400});
  EXPECT_EQ(moved, (Cell{256, 512}));
  EXPECT_EQ(grid.geometry().width, 100 + 256 + 256);
  EXPECT_EQ(grid.geometry().height, 90 + 512 + 256);
  EXPECT_EQ(grid.geometry().ToCell(point), (Cell{42 + 256, 17 + 512}));
  EXPECT_EQ(grid.FindTile(256 / 64, 512 / 64 + 1), tile);
  for (int y = 0; y < grid.geometry().height; ++y) {
    for (int x = 0; x < grid.geometry().width; ++x) {
      const Cell old{x - moved.x, y - moved.y};
      const LogOdds expected =
          reference.geometry().Contains(old) ? reference[old] : kUnexplored;
      ASSERT_EQ((grid[{x, y}]), expected);
    }
  }
}

TEST(LogOddsGrid, GrowthIsBounded) {
  LogOddsGrid grid(Geometry(100, 100));
  grid.GrowToHold({-1000000, 0, 1000010, 2000000});
  EXPECT_LE(grid.geometry().width, LogOddsGrid::kMaxSide);
  EXPECT_LE(grid.geometry().height, LogOddsGrid::kMaxSide);
  grid.Set({grid.geometry().width - 1, grid.geometry().height - 1}, 9);
}

}  // namespace
}  // namespace vfh_astar
