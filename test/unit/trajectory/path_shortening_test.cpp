#include "vfh_astar/trajectory/path_shortening.h"

#include <gtest/gtest.h>

#include "trajectory/test_maps.h"

namespace vfh_astar {
namespace {

constexpr ShorteningLimits kLimits = {0.25, 0.9};

TEST(ShortenPath, AStaircaseInTheOpenBecomesALine) {
  const ClearanceMap clearance = ClearanceOf(FreeMap(10, 10));
  Polyline path;
  for (int i = 0; i < 60; ++i)
    path.emplace_back(2 + 0.05 * i, 2 + 0.1 * (i / 2));
  const Polyline shortened = ShortenPath(path, clearance, kLimits);
  ASSERT_EQ(shortened.size(), 2u);
  EXPECT_EQ(shortened.front(), path.front());
  EXPECT_EQ(shortened.back(), path.back());
}

TEST(ShortenPath, NeverThroughAWall) {
  OccupancyGrid map = FreeMap(10, 10);
  AddBox(map, 5.0, 0.0, 5.1, 7.0);
  const ClearanceMap clearance = ClearanceOf(map);
  Polyline path;
  for (double y = 2; y < 8; y += 0.05) path.emplace_back(4, y);
  for (double x = 4; x < 6; x += 0.05) path.emplace_back(x, 8);
  for (double y = 8; y > 2; y -= 0.05) path.emplace_back(6, y);
  const Polyline shortened = ShortenPath(path, clearance, kLimits);
  EXPECT_LT(shortened.size(), 30u);
  for (const Eigen::Vector2d& point : Resample(shortened, 1000)) {
    EXPECT_GE(clearance.At(point), kLimits.needed);
  }
}

TEST(ShortenPath, KeepsToTheMiddleOfADoor) {
  OccupancyGrid map = FreeMap(10, 10);
  AddBox(map, 5.0, 0.0, 5.1, 4.5);
  AddBox(map, 5.0, 5.5, 5.1, 10.0);
  const ClearanceMap clearance = ClearanceOf(map);
  Polyline path;
  for (double x = 2; x < 4; x += 0.05) path.emplace_back(x, x + 1);
  for (double x = 4; x < 8; x += 0.05) path.emplace_back(x, 5);
  for (const Eigen::Vector2d& point :
       Resample(ShortenPath(path, clearance, kLimits), 1000)) {
    if (std::abs(point.x() - 5.05) < 0.05) {
      EXPECT_NEAR(point.y(), 5.0, 0.15);
    }
  }
}

TEST(ShortenPath, RandomFieldsKeepWhatThePathKeeps) {
  std::mt19937 random(5);
  for (int trial = 0; trial < 100; ++trial) {
    const ClearanceMap clearance = ClearanceOf(PillarField(10, 10, 30, random));
    // A random walk that turns where it would come too near.
    Polyline path = {{5, 5}};
    double heading = 0.0;
    std::uniform_real_distribution<> turn(-1.0, 1.0);
    if (clearance.At(path[0]) < 0.3) continue;
    for (int i = 0; i < 150; ++i) {
      heading += 0.3 * turn(random);
      const Eigen::Vector2d next =
          path.back() +
          0.05 * Eigen::Vector2d(std::cos(heading), std::sin(heading));
      if (clearance.At(next) < 0.3) {
        heading += 1.0;
      } else {
        path.push_back(next);
      }
    }
    const Polyline shortened = ShortenPath(path, clearance, kLimits);
    EXPECT_EQ(shortened.front(), path.front());
    EXPECT_EQ(shortened.back(), path.back());
    if (shortened.size() < 2) continue;
    for (const Eigen::Vector2d& point : Resample(shortened, 1000)) {
      // Looks lie half a cell apart.
      EXPECT_GE(clearance.At(point), kLimits.needed - 0.05);
    }
  }
}

}  // namespace
}  // namespace vfh_astar
