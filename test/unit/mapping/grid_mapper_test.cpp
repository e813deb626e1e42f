#include "vfh_astar/mapping/grid_mapper.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace vfh_astar {
namespace {

LaserScan Scan(double stamp, float range) {
  LaserScan scan;
  scan.stamp = stamp;
  scan.angle_min = -0.1;
  scan.angle_increment = 0.01;
  scan.range_min = 0.1;
  scan.range_max = 30.0;
  scan.ranges.assign(21, range);
  return scan;
}

GridMapperParameters Small() {
  GridMapperParameters parameters;
  parameters.xmin = -5.0;
  parameters.ymin = -4.0;
  parameters.xmax = 5.0;
  parameters.ymax = 4.0;
  return parameters;
}

TEST(GridMapper, ParametersGiveTheFirstExtent) {
  const GridMapper mapper(Small());
  EXPECT_EQ(mapper.geometry().width, 200);
  EXPECT_EQ(mapper.geometry().height, 160);
  EXPECT_EQ(mapper.geometry().origin, Eigen::Vector2d(-5.0, -4.0));
  const OccupancyGrid map = mapper.Map();
  for (const std::int8_t value : map.cells()) {
    EXPECT_EQ(value, kUnknown);
  }
  EXPECT_EQ(mapper.Entropy(), 0.0);
}

TEST(GridMapper, IsThrottledByTimeDistanceAndAngle) {
  GridMapper mapper(Small());
  EXPECT_TRUE(mapper.AddScan(Scan(10.0, 2.0f), {}).inserted);
  EXPECT_FALSE(mapper.AddScan(Scan(10.05, 2.0f), {}).inserted);
  EXPECT_FALSE(mapper.AddScan(Scan(10.05, 2.0f), {0.03, 0.03, 0.03}).inserted);
  EXPECT_TRUE(mapper.AddScan(Scan(10.06, 2.0f), {0.06, 0.0, 0.0}).inserted);
  EXPECT_TRUE(mapper.AddScan(Scan(10.07, 2.0f), {0.06, 0.0, 0.06}).inserted);
  EXPECT_FALSE(mapper.AddScan(Scan(10.15, 2.0f), {0.06, 0.0, 0.06}).inserted);
  EXPECT_TRUE(mapper.AddScan(Scan(10.18, 2.0f), {0.06, 0.0, 0.06}).inserted);
}

TEST(GridMapper, TimeThatJumpsBackIsANewBeginning) {
  GridMapper mapper(Small());
  mapper.AddScan(Scan(10.0, 2.0f), {});
  EXPECT_TRUE(mapper.AddScan(Scan(3.0, 2.0f), {}).inserted);
  EXPECT_FALSE(mapper.AddScan(Scan(3.01, 2.0f), {}).inserted);
}

TEST(GridMapper, ReportsTheWindowThatChanged) {
  GridMapper mapper(Small());
  const OccupancyGrid before = mapper.Map();
  const MapChange change = mapper.AddScan(Scan(0.0, 2.02f), {});
  EXPECT_FALSE(change.resized);
  OccupancyGrid patched = before;
  const std::vector<std::int8_t> values = mapper.Values(change.window);
  ASSERT_EQ(values.size(), static_cast<std::size_t>(change.window.area()));
  auto value = values.begin();
  for (int y = change.window.y; y < change.window.br().y; ++y) {
    for (int x = change.window.x; x < change.window.br().x; ++x) {
      patched[{x, y}] = *value++;
    }
  }
  EXPECT_EQ(patched.cells(), mapper.Map().cells());
  const Cell hit = mapper.geometry().ToCell({2.02, 0.0});
  EXPECT_EQ((mapper.Map()[hit]), 80);
  EXPECT_EQ((mapper.Map()[{hit.x - 5, hit.y}]), 40);
}

TEST(GridMapper, SaysWhenTheMapHasGrown) {
  GridMapper mapper(Small());
  const MapChange change = mapper.AddScan(Scan(0.0, 7.0f), {});
  EXPECT_TRUE(change.resized);
  EXPECT_GT(mapper.geometry().width, 200);
  EXPECT_EQ(mapper.Map().geometry(), mapper.geometry());
}

TEST(GridMapper, StartsFromAGivenMap) {
  GridGeometry geometry;
  geometry.resolution = 0.1;
  geometry.origin = Eigen::Vector2d(-3.0, -3.0);
  geometry.width = 61;
  geometry.height = 70;
  OccupancyGrid map(geometry, 0);
  map[{60, 69}] = 100;
  map[{0, 5}] = kUnknown;
  GridMapper mapper(Small());
  mapper.SetMap(map);
  EXPECT_EQ(mapper.geometry(), geometry);
  EXPECT_EQ(mapper.Map().cells(), map.cells());
}

TEST(GridMapper, AMoverLeavesNoTrailAfterASecond) {
  GridMapper mapper(Small());
  double stamp = 0.0;
  for (; stamp < 3.0; stamp += 0.025) mapper.AddScan(Scan(stamp, 2.0f), {});
  const Cell where = mapper.geometry().ToCell({2.0, 0.0});
  EXPECT_GE((mapper.Map()[where]), 65);
  const double left_at = stamp;
  for (; stamp < left_at + 1.0; stamp += 0.025) {
    mapper.AddScan(Scan(stamp, 3.0f), {});
  }
  EXPECT_LT((mapper.Map()[where]), 25);
}

TEST(GridMapper, EntropyIsThatOfTheExploredCells) {
  GridMapper mapper(Small());
  GridGeometry geometry;
  geometry.width = 100;
  geometry.height = 2;
  OccupancyGrid map(geometry, kUnknown);
  map[{3, 0}] = 50;
  mapper.SetMap(map);
  EXPECT_NEAR(mapper.Entropy(), std::log(2.0), 1e-9);
  map[{4, 1}] = 100;
  mapper.SetMap(map);
  EXPECT_NEAR(mapper.Entropy(), 0.5 * std::log(2.0), 0.01);
}

}  // namespace
}  // namespace vfh_astar
