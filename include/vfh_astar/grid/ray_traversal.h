#ifndef VFH_ASTAR_GRID_RAY_TRAVERSAL_H_
#define VFH_ASTAR_GRID_RAY_TRAVERSAL_H_

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

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
///
/// @param[in] from, to cell units (see ToCellUnits), finite.
/// @param[in] visit called as visit(y, x_first, x_last), both columns included;
///   the line enters row y at x_first and leaves it at x_last, which is the
///   smaller one when the line runs towards lower x. Returns false to stop.
/// @return false when stopped by the visitor.
template <typename Visitor>
bool TraverseRows(const Eigen::Vector2d& from, const Eigen::Vector2d& to,
                  Visitor&& visit) {
  const int last_row = static_cast<int>(std::floor(to.y()));
  const int last_column = static_cast<int>(std::floor(to.x()));
  const Eigen::Vector2d difference = to - from;
  const double per_row = 1.0 / difference.y();
  const int step = difference.y() < 0.0 ? -1 : 1;
  const int edge = difference.y() < 0.0 ? 0 : 1;
  int column = static_cast<int>(std::floor(from.x()));
  for (int y = static_cast<int>(std::floor(from.y())); y != last_row;
       y += step) {
    // The bound keeps rounding from passing the line's end.
    const double part = std::min(1.0, (y + edge - from.y()) * per_row);
    const int crossing =
        static_cast<int>(std::floor(from.x() + part * difference.x()));
    const int next = difference.x() < 0.0 ? std::max(crossing, last_column)
                                          : std::min(crossing, last_column);
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
