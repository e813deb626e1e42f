#ifndef VFH_ASTAR_GRID_RAY_TRAVERSAL_H_
#define VFH_ASTAR_GRID_RAY_TRAVERSAL_H_

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "vfh_astar/grid/grid.h"

namespace vfh_astar {

/// A frame's point in a grid's own units: cell (x, y) is [x, x+1) x [y, y+1).
inline Eigen::Vector2d ToCellUnits(const GridGeometry& geometry,
                                   const Eigen::Vector2d& point) {
  return (point - geometry.origin) / geometry.resolution;
}

/// Where a straight line crosses from row to row of cells, in fixed point: a
/// shift takes the place of a floor in every row, and crossings are right to a
/// millionth of a cell.
struct RowCrossings {
  static constexpr int kFraction = 32;  ///< binary places.

  int y;              ///< the row that the line begins in.
  int column;         ///< likewise.
  int last_column;    ///< that it ends in.
  int step;           ///< from row to row, 1 or -1.
  int count;          ///< crossings; 0: the line stays in its row.
  bool is_leftward;   ///< towards lower x.
  std::int64_t x;     ///< columns, of the first crossing.
  std::int64_t next;  ///< columns from one crossing to the next.

  /// @param[in] from, to cell units (see ToCellUnits), within +-2^28.
  RowCrossings(const Eigen::Vector2d& from, const Eigen::Vector2d& to)
      : y(static_cast<int>(std::floor(from.y()))),
        column(static_cast<int>(std::floor(from.x()))),
        last_column(static_cast<int>(std::floor(to.x()))),
        step(to.y() < from.y() ? -1 : 1),
        count(std::abs(static_cast<int>(std::floor(to.y())) - y)),
        is_leftward(to.x() < from.x()),
        x(0),
        next(0) {
    if (count == 0) return;
    const auto fixed = [](double value) {
      return static_cast<std::int64_t>(std::floor(
          value * static_cast<double>(std::int64_t{1} << kFraction)));
    };
    const Eigen::Vector2d difference = to - from;
    const double first_edge = step < 0 ? y : y + 1;
    const double part = std::min(1.0, (first_edge - from.y()) / difference.y());
    x = fixed(from.x() + part * difference.x());
    // A line that crosses one edge only may be as good as flat.
    if (count > 1) next = fixed(difference.x() / std::abs(difference.y()));
  }

  /// The column of a crossing at `at`. The bound keeps rounding from passing
  /// the line's end.
  int ColumnAt(std::int64_t at) const {
    const int reached = static_cast<int>(at >> kFraction);
    return is_leftward ? std::max(reached, last_column)
                       : std::min(reached, last_column);
  }
};

/// Visits the cells that a straight line passes through as one run of columns
/// per row, in the order of the line. Successive cells share an edge: the cells
/// are those of Amanatides and Woo, "A Fast Voxel Traversal Algorithm for Ray
/// Tracing" (1987), taken row-wise, so that a flat line costs one step per row.
///
/// @param[in] from, to see RowCrossings.
/// @param[in] visit called as visit(y, x_first, x_last), both columns included;
///   the line enters row y at x_first and leaves it at x_last, which is the
///   smaller one when the line runs towards lower x. Returns false to stop.
/// @return false when stopped by the visitor.
template <typename Visitor>
bool TraverseRows(const Eigen::Vector2d& from, const Eigen::Vector2d& to,
                  Visitor&& visit) {
  const RowCrossings line(from, to);
  int y = line.y;
  int column = line.column;
  std::int64_t x = line.x;
  for (int left = line.count; left != 0;
       --left, y += line.step, x += line.next) {
    const int next = line.ColumnAt(x);
    if (!visit(y, column, next)) return false;
    column = next;
  }
  return visit(y, column, line.last_column);
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
