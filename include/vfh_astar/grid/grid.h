#ifndef VFH_ASTAR_GRID_GRID_H_
#define VFH_ASTAR_GRID_GRID_H_

#include <Eigen/Core>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <opencv2/core/types.hpp>
#include <vector>

namespace vfh_astar {

/// A cell of a grid: column and row.
struct Cell {
  int x = 0;
  int y = 0;

  friend bool operator==(const Cell& a, const Cell& b) {
    return a.x == b.x && a.y == b.y;
  }
  friend bool operator!=(const Cell& a, const Cell& b) { return !(a == b); }
};

/// Where a grid lies in its frame: axis-aligned square cells, row 0 lowest, as
/// nav_msgs/MapMetaData has it.
struct GridGeometry {
  double resolution = 0.05;                          ///< m per cell.
  Eigen::Vector2d origin = Eigen::Vector2d::Zero();  ///< m, lower left
                                                     ///< corner of (0, 0).
  int width = 0;                                     ///< cells along x.
  int height = 0;                                    ///< cells along y.

  /// The cell that a point of the frame lies in; may lie outside the grid.
  Cell ToCell(const Eigen::Vector2d& point) const {
    return {
        static_cast<int>(std::floor((point.x() - origin.x()) / resolution)),
        static_cast<int>(std::floor((point.y() - origin.y()) / resolution))};
  }

  /// The centre of a cell in the frame, m.
  Eigen::Vector2d ToWorld(const Cell& cell) const {
    return {origin.x() + (cell.x + 0.5) * resolution,
            origin.y() + (cell.y + 0.5) * resolution};
  }

  bool Contains(const Cell& cell) const {
    return 0 <= cell.x && cell.x < width && 0 <= cell.y && cell.y < height;
  }

  std::size_t Index(const Cell& cell) const {
    assert(Contains(cell));
    return static_cast<std::size_t>(cell.y) * width + cell.x;
  }

  std::size_t size() const { return static_cast<std::size_t>(width) * height; }

  cv::Rect Bounds() const { return {0, 0, width, height}; }

  friend bool operator==(const GridGeometry& a, const GridGeometry& b) {
    return a.resolution == b.resolution && a.origin == b.origin &&
           a.width == b.width && a.height == b.height;
  }
  friend bool operator!=(const GridGeometry& a, const GridGeometry& b) {
    return !(a == b);
  }
};

/// A value per cell, row by row from the lower left.
template <typename T>
class Grid {
 public:
  Grid() = default;
  Grid(const GridGeometry& geometry, const T& value)
      : geometry_(geometry), cells_(geometry.size(), value) {}

  const GridGeometry& geometry() const { return geometry_; }
  const std::vector<T>& cells() const { return cells_; }
  std::vector<T>& cells() { return cells_; }

  const T& operator[](const Cell& cell) const {
    return cells_[geometry_.Index(cell)];
  }
  T& operator[](const Cell& cell) { return cells_[geometry_.Index(cell)]; }

 private:
  GridGeometry geometry_;
  std::vector<T> cells_;
};

/// Occupancy as it is published: 0 (free) to 100 (occupied) percent, or
/// kUnknown.
using OccupancyGrid = Grid<std::int8_t>;
inline constexpr std::int8_t kUnknown = -1;

}  // namespace vfh_astar

#endif  // VFH_ASTAR_GRID_GRID_H_
