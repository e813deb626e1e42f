#ifndef VFH_ASTAR_GRID_MAP_WINDOW_H_
#define VFH_ASTAR_GRID_MAP_WINDOW_H_

#include <cstddef>
#include <cstdint>
#include <opencv2/core/types.hpp>
#include <vector>

namespace vfh_astar {

/// New values of a part of a map.
struct MapWindow {
  cv::Rect cells;
  /// Percent or kUnknown, row by row, cells.area() of them.
  std::vector<std::int8_t> values;
};

/// So many windows may wait for who looks at the map now and then: scans that
/// follow one another change the same cells, and what follows from these is
/// worked out once. More would make the next look wait.
inline constexpr std::size_t kMostGatheredWindows = 8;

}  // namespace vfh_astar

#endif  // VFH_ASTAR_GRID_MAP_WINDOW_H_
