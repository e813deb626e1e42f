#ifndef VFH_ASTAR_GRID_FOOTPRINT_ROWS_H_
#define VFH_ASTAR_GRID_FOOTPRINT_ROWS_H_

#include <algorithm>
#include <array>
#include <cmath>

#include "vfh_astar/footprint.h"
#include "vfh_astar/geometry.h"

namespace vfh_astar {

/// A run of cells in one row, both ends included; none when last < first.
struct CellRow {
  int y = 0;
  int first = 0;
  int last = -1;
};

/// The first and the last x at which a horizontal line meets a rectangle given
/// by its corners; first > last when it does not.
inline std::array<double, 2> CrossSection(
    const std::array<Eigen::Vector2d, 4>& corners, double y) {
  std::array<double, 2> section = {INFINITY, -INFINITY};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Eigen::Vector2d& a = corners[i];
    const Eigen::Vector2d& b = corners[(i + 1) % corners.size()];
    if (std::min(a.y(), b.y()) > y || std::max(a.y(), b.y()) < y) continue;
    const double rise = b.y() - a.y();
    const double x =
        rise == 0.0 ? b.x() : a.x() + (y - a.y()) / rise * (b.x() - a.x());
    section[0] = std::min(section[0], x);
    section[1] = std::max(section[1], x);
  }
  return section;
}

/// Visits the rows of cells whose centres lie in or on a footprint, the lowest
/// one first.
/// @param[in] resolution m per cell.
/// @param[in] pose relative to the centre of cell (0, 0), m.
/// @param[in] visit called as visit(CellRow); returns false to stop.
/// @return false when stopped by the visitor.
template <typename Visitor>
bool VisitFootprintRows(const Footprint& footprint, const Pose2D& pose,
                        double resolution, Visitor&& visit) {
  // A centre on the outline counts, whichever way its place is rounded.
  constexpr double kRounding = 1e-9;
  std::array<Eigen::Vector2d, 4> corners = footprint.Corners();
  double lowest = INFINITY;
  double highest = -INFINITY;
  for (Eigen::Vector2d& corner : corners) {
    corner = (pose * corner) / resolution;
    lowest = std::min(lowest, corner.y());
    highest = std::max(highest, corner.y());
  }
  for (int y = static_cast<int>(std::ceil(lowest)); y <= highest; ++y) {
    const std::array<double, 2> section = CrossSection(corners, y);
    const CellRow row = {y, static_cast<int>(std::ceil(section[0] - kRounding)),
                         static_cast<int>(std::floor(section[1] + kRounding))};
    if (row.first <= row.last && !visit(row)) return false;
  }
  return true;
}

}  // namespace vfh_astar

#endif  // VFH_ASTAR_GRID_FOOTPRINT_ROWS_H_
