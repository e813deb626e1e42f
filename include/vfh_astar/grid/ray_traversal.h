#ifndef VFH_ASTAR_GRID_RAY_TRAVERSAL_H_
#define VFH_ASTAR_GRID_RAY_TRAVERSAL_H_

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdint>

#include "vfh_astar/grid/grid.h"

namespace vfh_astar {

/// A frame's point in a grid's own units: cell (x, y) is [x, x+1) x [y, y+1).
inline Eigen::Vector2d ToCellUnits(const GridGeometry& geometry,
                                   const Eigen::Vector2d& point) {
  return (point - geometry.origin) / geometry.resolution;
}

/// Visits the cells that a straight line passes through as one run of columns
/// per row, in the order of the line. Successive cells share an edge: the cells
/// are those of Amanatides and Woo, "A Fast Voxel Traversal Algorithm for Ray
/// Tracing" (1987), taken row-wise, so that a flat line costs one step per row.
/// Where the line crosses from row to row is right to a millionth of a cell.
///
/// @param[in] from, to cell units (see ToCellUnits), within +-2^28.
/// @param[in] visit called as visit(y, x_first, x_last), both columns included;
///   the line enters row y at x_first and leaves it at x_last, which is the
///   smaller one when the line runs towards lower x. Returns false to stop.
/// @return false when stopped by the visitor.
template <typename Visitor>
bool TraverseRows(const Eigen::Vector2d& from, const Eigen::Vector2d& to,
                  Visitor&& visit) {
  const int last_row = static_cast<int>(std::floor(to.y()));
  const int last_column = static_cast<int>(std::floor(to.x()));
  int y = static_cast<int>(std::floor(from.y()));
  int column = static_cast<int>(std::floor(from.x()));
  if (y == last_row) return visit(y, column, last_column);

  // Crossings in fixed point: a shift in place of a floor in every row.
  constexpr int kFraction = 32;
  const auto fixed = [](double value) {
    return static_cast<std::int64_t>(
        std::floor(value * static_cast<double>(std::int64_t{1} << kFraction)));
  };
  const Eigen::Vector2d difference = to - from;
  const int step = difference.y() < 0.0 ? -1 : 1;
  const double first_edge = difference.y() < 0.0 ? y : y + 1;
  const double part = std::min(1.0, (first_edge - from.y()) / difference.y());
  std::int64_t crossing = fixed(from.x() + part * difference.x());
  // A line that crosses one edge only may be as good as flat.
  const std::int64_t per_row =
      y + step == last_row ? 0
                           : fixed(difference.x() / std::abs(difference.y()));
  for (; y != last_row; y += step, crossing += per_row) {
    // The bound keeps rounding from passing the line's end.
    const int reached = static_cast<int>(crossing >> kFraction);
    const int next = difference.x() < 0.0 ? std::max(reached, last_column)
                                          : std::min(reached, last_column);
    if (!visit(y, column, next)) return false;
    column = next;
  }
  return visit(last_row, column, last_column);
}

/// As TraverseRows, cell by cell.
/// @param[in] visit called as visit(Cell); returns false to stop.
template <typename Visitor>
bool TraverseCells(const Eigen::Vector2d& from, const Eigen::Vector2d& to,
                   Visitor&& visit) {
  return TraverseRows(from, to, [&visit](int y, int first, int last) {
    const int step = last < first ? -1 : 1;
    for (int x = first; x != last + step; x += step) {
      if (!visit(Cell{x, y})) return false;
    }
    return true;
  });
}

}  // namespace vfh_astar

#endif  // VFH_ASTAR_GRID_RAY_TRAVERSAL_H_
