#ifndef TEST_UNIT_TRAJECTORY_TEST_MAPS_H_
#define TEST_UNIT_TRAJECTORY_TEST_MAPS_H_

#include <algorithm>
#include <cmath>
#include <random>

#include "vfh_astar/grid/clearance.h"
#include "vfh_astar/grid/grid.h"

namespace vfh_astar {

/// A free map of `width` x `height` metres from (0, 0) on, 0.05 m cells.
inline OccupancyGrid FreeMap(double width, double height) {
  GridGeometry geometry;
  geometry.resolution = 0.05;
  geometry.width = static_cast<int>(std::lround(width / 0.05));
  geometry.height = static_cast<int>(std::lround(height / 0.05));
  return OccupancyGrid(geometry, 0);
}

/// Occupies the cells whose centres lie in a rectangle (m).
inline void AddBox(OccupancyGrid& map, double x0, double y0, double x1,
                   double y1) {
  const GridGeometry& geometry = map.geometry();
  for (int y = 0; y < geometry.height; ++y) {
    for (int x = 0; x < geometry.width; ++x) {
      const Eigen::Vector2d p = geometry.ToWorld({x, y});
      if (x0 <= p.x() && p.x() <= x1 && y0 <= p.y() && p.y() <= y1) {
        map[{x, y}] = 100;
      }
    }
  }
}

/// Occupies the cells whose centres lie in a disc (m).
inline void AddDisc(OccupancyGrid& map, const Eigen::Vector2d& centre,
                    double radius) {
  const GridGeometry& geometry = map.geometry();
  for (int y = 0; y < geometry.height; ++y) {
    for (int x = 0; x < geometry.width; ++x) {
      if ((geometry.ToWorld({x, y}) - centre).norm() <= radius) {
        map[{x, y}] = 100;
      }
    }
  }
}

/// A field of pillars 0.15 m thick.
template <typename Random>
OccupancyGrid PillarField(double width, double height, int pillars,
                          Random& random) {
  OccupancyGrid map = FreeMap(width, height);
  std::uniform_real_distribution<> x(0.0, width);
  std::uniform_real_distribution<> y(0.0, height);
  for (int i = 0; i < pillars; ++i) {
    const double px = x(random);
    const double py = y(random);
    AddDisc(map, {px, py}, 0.075);
  }
  return map;
}

inline ClearanceMap ClearanceOf(const OccupancyGrid& map) {
  ClearanceMap clearance(65, 1.0);
  clearance.SetMap(map);
  return clearance;
}

}  // namespace vfh_astar

#endif  // TEST_UNIT_TRAJECTORY_TEST_MAPS_H_
