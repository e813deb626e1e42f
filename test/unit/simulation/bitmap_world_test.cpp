#include "vfh_astar/simulation/bitmap_world.h"

#include <gtest/gtest.h>

#include <random>

#include "temporary_folder.h"

namespace vfh_astar {
namespace {

OccupancyGrid MakeMap(const std::vector<std::string>& rows_from_top) {
  GridGeometry geometry;
  geometry.resolution = 0.5;
  geometry.origin = Eigen::Vector2d(-1.0, 2.0);
  geometry.width = static_cast<int>(rows_from_top[0].size());
  geometry.height = static_cast<int>(rows_from_top.size());
  OccupancyGrid map(geometry, 0);
  for (int y = 0; y < geometry.height; ++y) {
    const std::string& row = rows_from_top[geometry.height - 1 - y];
    for (int x = 0; x < geometry.width; ++x) {
      if (row[x] == '#') map[Cell{x, y}] = 100;
    }
  }
  return map;
}

TEST(MergeSolidCells, CoversBlocksWithOneRectangle) {
  const std::vector<Shape> shapes = MergeSolidCells(MakeMap({"....",  //
                                                             ".##.",  //
                                                             ".##."}));
  ASSERT_EQ(shapes.size(), 1u);
  EXPECT_EQ(shapes[0].vertices,
            (std::vector<Eigen::Vector2d>{
                {-0.5, 2.0}, {0.5, 2.0}, {0.5, 3.0}, {-0.5, 3.0}}));
}

TEST(MergeSolidCells, NeedsFewRectangles) {
  EXPECT_TRUE(MergeSolidCells(MakeMap({"...", "..."})).empty());
  EXPECT_EQ(MergeSolidCells(MakeMap({"#####",  //
                                     "#...#",  //
                                     "#...#",  //
                                     "#####"}))
                .size(),
            4u);
  EXPECT_EQ(MergeSolidCells(MakeMap({"#.", ".#"})).size(), 2u);
}

TEST(MergeSolidCells, CoversEachSolidCellOnceAndNoOther) {
  std::mt19937 random(5);
  for (int round = 0; round < 20; ++round) {
    OccupancyGrid map({0.1, {3.0, -7.0}, 30, 20}, 0);
    for (std::int8_t& value : map.cells()) {
      value = std::vector<int>{100, 100, 0, kUnknown, 99}[random() % 5];
    }
    const std::vector<Shape> shapes = MergeSolidCells(map);
    for (int y = 0; y < 20; ++y) {
      for (int x = 0; x < 30; ++x) {
        const Cell cell = {x, y};
        int covered = 0;
        for (const Shape& shape : shapes) {
          covered += Contains(shape, map.geometry().ToWorld(cell)) ? 1 : 0;
        }
        ASSERT_EQ(covered, map[cell] == 100 ? 1 : 0) << x << " " << y;
      }
    }
  }
}

TEST(LoadBitmapWorld, TakesWhatIsDarkerAsSolid) {
  const TemporaryFolder folder;
  folder.Write("map.pgm", std::string("P5\n3 1\n255\n\x00\xcc\xcd", 14));
  const std::string yaml =
      folder.Write("map.yaml",
                   "{image: map.pgm, resolution: 1.0, origin: [0, 0, 0], "
                   "negate: 0, occupied_thresh: 0.65, free_thresh: 0.196}");
  const World world = LoadBitmapWorld(yaml, 205);
  ASSERT_EQ(world.obstacles.size(), 1u);
  EXPECT_EQ(world.obstacles[0].name, "map");
  ASSERT_EQ(world.obstacles[0].shapes.size(), 1u);
  EXPECT_TRUE(Contains(world.obstacles[0].shapes[0], {1.9, 0.5}));
  EXPECT_FALSE(Contains(world.obstacles[0].shapes[0], {2.1, 0.5}));
}

}  // namespace
}  // namespace vfh_astar
