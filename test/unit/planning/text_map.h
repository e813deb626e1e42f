#ifndef VFH_ASTAR_TEST_UNIT_PLANNING_TEXT_MAP_H_
#define VFH_ASTAR_TEST_UNIT_PLANNING_TEXT_MAP_H_

#include <random>
#include <string>
#include <vector>

#include "vfh_astar/grid/grid.h"

namespace vfh_astar {

/// A map drawn in text, the highest row first: '#' occupied, '?' unknown, all
/// else free. One metre per cell unless said otherwise, origin at (0, 0).
inline OccupancyGrid TextMap(const std::vector<std::string>& rows,
                             double resolution = 1.0) {
  GridGeometry geometry;
  geometry.resolution = resolution;
  geometry.width = static_cast<int>(rows.front().size());
  geometry.height = static_cast<int>(rows.size());
  OccupancyGrid map(geometry, 0);
  for (int y = 0; y < geometry.height; ++y) {
    for (int x = 0; x < geometry.width; ++x) {
      const char symbol = rows[geometry.height - 1 - y][x];
      map[{x, y}] = symbol == '#' ? 100 : symbol == '?' ? kUnknown : 0;
    }
  }
  return map;
}

/// Single occupied and unknown cells, and some walls.
inline OccupancyGrid RandomMap(int width, int height, double resolution,
                               double density, std::mt19937& random) {
  GridGeometry geometry;
  geometry.resolution = resolution;
  geometry.width = width;
  geometry.height = height;
  OccupancyGrid map(geometry, 0);
  std::bernoulli_distribution is_occupied(density);
  std::bernoulli_distribution is_unknown(0.1);
  for (std::int8_t& cell : map.cells()) {
    if (is_unknown(random)) cell = kUnknown;
    if (is_occupied(random)) cell = 100;
  }
  for (int wall = 0; wall < 3; ++wall) {
    const int x = static_cast<int>(random() % width);
    const int gap = static_cast<int>(random() % height);
    for (int y = 0; y < height; ++y) {
      if (std::abs(y - gap) > height / 6) map[{x, y}] = 100;
    }
  }
  return map;
}

}  // namespace vfh_astar

#endif  // VFH_ASTAR_TEST_UNIT_PLANNING_TEXT_MAP_H_
