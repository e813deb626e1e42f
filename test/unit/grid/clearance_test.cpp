#include "vfh_astar/grid/clearance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace vfh_astar {
namespace {

constexpr int kThreshold = 65;

GridGeometry Geometry(int width, int height, double resolution = 0.1) {
  GridGeometry geometry;
  geometry.resolution = resolution;
  geometry.origin = Eigen::Vector2d(-1.0, 2.0);
  geometry.width = width;
  geometry.height = height;
  return geometry;
}

OccupancyGrid RandomMap(const GridGeometry& geometry, double density,
                        std::mt19937& random) {
  OccupancyGrid map(geometry, 0);
  std::bernoulli_distribution occupied(density);
  std::bernoulli_distribution unknown(0.1);
  for (std::int8_t& cell : map.cells()) {
    cell = occupied(random) ? 100 : unknown(random) ? kUnknown : 0;
  }
  return map;
}

TEST(ClearanceMap, MeasuresBetweenCellCentres) {
  OccupancyGrid map(Geometry(10, 10), 0);
  map[{2, 3}] = 100;
  map[{9, 9}] = 64;  // Below the threshold.
  map[{9, 8}] = kUnknown;
  ClearanceMap clearance(kThreshold, 0.5);
  clearance.SetMap(map);
  EXPECT_TRUE(clearance.IsOccupied({2, 3}));
  EXPECT_FALSE(clearance.IsOccupied({9, 9}));
  EXPECT_EQ(clearance.At(Cell{2, 3}), 0.0);
  EXPECT_NEAR(clearance.At(Cell{4, 3}), 0.2, 1e-6);
  EXPECT_NEAR(clearance.At(Cell{5, 7}), 0.5, 1e-6);
  EXPECT_NEAR(clearance.At(Cell{3, 5}), 0.1 * std::sqrt(5.0), 1e-6);
  EXPECT_EQ(clearance.At(Cell{9, 9}), 0.5f);
  EXPECT_NEAR(clearance.At(Eigen::Vector2d(-1.0 + 0.41, 2.0 + 0.39)), 0.2,
              1e-6);
  EXPECT_EQ(clearance.At(Eigen::Vector2d(-5.0, 0.0)), 0.5);
}

TEST(ClearanceMap, EmptyMapIsClearEverywhere) {
  ClearanceMap clearance(kThreshold, 0.7);
  clearance.SetMap(OccupancyGrid(Geometry(300, 5), kUnknown));
  EXPECT_EQ(clearance.At(Cell{299, 4}), 0.7f);
}

TEST(ClearanceMap, AgreesWithTheNearestOccupiedCell) {
  std::mt19937 random(1);
  // Wider than one block of the distance transform.
  const OccupancyGrid map = RandomMap(Geometry(300, 40), 0.01, random);
  ClearanceMap clearance(kThreshold, 0.85);
  clearance.SetMap(map);
  for (int y = 0; y < 40; ++y) {
    for (int x = 0; x < 300; ++x) {
      double nearest = 0.85;
      for (int v = std::max(0, y - 9); v <= std::min(39, y + 9); ++v) {
        for (int u = std::max(0, x - 9); u <= std::min(299, x + 9); ++u) {
          if (map[{u, v}] < kThreshold) continue;
          nearest = std::min(nearest, 0.1 * std::hypot(u - x, v - y));
        }
      }
      ASSERT_NEAR(clearance.At(Cell{x, y}), nearest, 1e-6) << x << ", " << y;
    }
  }
}

TEST(ClearanceMap, UpdateEqualsSetMapCellForCell) {
  std::mt19937 random(2);
  const auto below = [&random](int limit) {
    return std::uniform_int_distribution<int>(0, limit - 1)(random);
  };
  for (const double max_distance : {0.15, 0.8, 2.0}) {
    const GridGeometry geometry = Geometry(330, 290);
    OccupancyGrid map = RandomMap(geometry, 0.003, random);
    ClearanceMap updated(kThreshold, max_distance);
    updated.SetMap(map);
    for (int round = 0; round < 25; ++round) {
      std::vector<MapWindow> windows(1 + below(3));
      for (auto& [cells, values] : windows) {
        cells.x = below(geometry.width);
        cells.y = below(geometry.height);
        cells.width = 1 + below(geometry.width - cells.x);
        cells.height = 1 + below(geometry.height - cells.y);
        for (int y = cells.y; y < cells.br().y; ++y) {
          for (int x = cells.x; x < cells.br().x; ++x) {
            if (below(200) == 0) map[{x, y}] = below(2) == 0 ? 100 : 0;
            values.push_back(map[{x, y}]);
          }
        }
      }
      const Grid<float> before = [&] {
        Grid<float> copy(geometry, 0.0f);
        for (int y = 0; y < geometry.height; ++y) {
          for (int x = 0; x < geometry.width; ++x) {
            copy[{x, y}] = static_cast<float>(updated.At(Cell{x, y}));
          }
        }
        return copy;
      }();
      const std::vector<cv::Rect> changed = updated.Update(windows);
      ClearanceMap whole(kThreshold, max_distance);
      whole.SetMap(map);
      ASSERT_EQ(updated.map().cells(), map.cells());
      for (int y = 0; y < geometry.height; ++y) {
        for (int x = 0; x < geometry.width; ++x) {
          const Cell cell{x, y};
          ASSERT_EQ(updated.At(cell), whole.At(cell)) << x << ", " << y;
          const auto holds = [x, y](const cv::Rect& rect) {
            return rect.contains(cv::Point(x, y));
          };
          const auto times =
              std::count_if(changed.begin(), changed.end(), holds);
          ASSERT_LE(times, 1);
          if (times == 0) {
            ASSERT_EQ(updated.At(cell), before[cell]);
          }
        }
      }
    }
  }
}

TEST(ClearanceMap, UpdateWithoutAFlipRecomputesNothing) {
  std::mt19937 random(3);
  OccupancyGrid map = RandomMap(Geometry(50, 50), 0.1, random);
  ClearanceMap clearance(kThreshold, 0.8);
  clearance.SetMap(map);
  for (std::int8_t& cell : map.cells()) {
    cell = cell >= kThreshold ? 70 : cell == 0 ? kUnknown : 10;
  }
  EXPECT_TRUE(clearance.Update(map.geometry().Bounds(), map.cells()).empty());
  EXPECT_EQ(clearance.map().cells(), map.cells());
}

TEST(ClearanceMap, FootprintIsFreeUntilACentreLiesInIt) {
  OccupancyGrid map(Geometry(40, 40, 0.05), 0);
  map[{20, 20}] = 100;
  ClearanceMap clearance(kThreshold, 0.8);
  clearance.SetMap(map);
  const Footprint footprint{0.3, 0.1, 0.15};
  const Eigen::Vector2d obstacle = map.geometry().ToWorld({20, 20});
  const auto free_at = [&](double ahead, double theta, double margin) {
    const Pose2D turned(0.0, 0.0, theta);
    return clearance.IsFree(
        footprint, {obstacle - turned.heading() * ahead, theta}, margin);
  };
  for (const double theta : {0.0, 0.4, 1.5707963267948966, 2.5, -3.0}) {
    EXPECT_FALSE(free_at(0.299, theta, 0.0));
    EXPECT_TRUE(free_at(0.301, theta, 0.0));
    EXPECT_FALSE(free_at(0.301, theta, 0.01));
    EXPECT_FALSE(free_at(-0.099, theta, 0.0));
    EXPECT_TRUE(free_at(-0.101, theta, 0.0));
  }
}

TEST(ClearanceMap, FootprintAgreesWithEveryOccupiedCentre) {
  std::mt19937 random(4);
  const Footprint footprint{0.35, 0.2, 0.17};
  std::uniform_real_distribution<double> offset(-0.3, 4.3);
  std::uniform_real_distribution<double> angle(-kPi, kPi);
  int free_poses = 0;
  // The second distance is shorter than the footprint's reach.
  for (const double max_distance : {0.8, 0.12}) {
    const OccupancyGrid map = RandomMap(Geometry(80, 80, 0.05), 0.004, random);
    ClearanceMap clearance(kThreshold, max_distance);
    clearance.SetMap(map);
    for (int i = 0; i < 4000; ++i) {
      const Pose2D pose(-1.0 + offset(random), 2.0 + offset(random),
                        angle(random));
      const double margin = 0.02;
      bool expected = true;
      for (int y = 0; y < 80; ++y) {
        for (int x = 0; x < 80; ++x) {
          if (map[{x, y}] < kThreshold) continue;
          const Eigen::Vector2d seen =
              pose.Inverse() * map.geometry().ToWorld({x, y});
          if (footprint.Grown(margin).Contains(seen)) expected = false;
        }
      }
      free_poses += expected ? 1 : 0;
      ASSERT_EQ(clearance.IsFree(footprint, pose, margin), expected)
          << pose.x << ", " << pose.y << ", " << pose.theta;
    }
  }
  EXPECT_GT(free_poses, 1000);
  EXPECT_LT(free_poses, 7000);
}

}  // namespace
}  // namespace vfh_astar
