#ifndef VFH_ASTAR_GRID_CLEARANCE_H_
#define VFH_ASTAR_GRID_CLEARANCE_H_

#include <cstdint>
#include <opencv2/core/types.hpp>
#include <vector>

#include "vfh_astar/footprint.h"
#include "vfh_astar/geometry.h"
#include "vfh_astar/grid/footprint_rows.h"
#include "vfh_astar/grid/grid.h"
#include "vfh_astar/grid/map_window.h"

namespace vfh_astar {

/// Distance from every cell to the nearest occupied one, kept up to date as the
/// map changes. Occupied is a value of `occupied_threshold` percent or more;
/// unknown cells are no obstacles here (what they mean is the planner's
/// affair).
///
/// Distances run between cell centres, as cv::distanceTransform gives them (L2,
/// precise mask), are 0 in occupied cells and saturate at `max_distance`.
/// Outside of the grid nothing is known, and clearance is `max_distance`.
class ClearanceMap {
 public:
  /// @param[in] occupied_threshold percent, 1 to 100.
  /// @param[in] max_distance m; what a change can reach, so it bounds the
  ///   window that an update recomputes.
  ClearanceMap(int occupied_threshold, double max_distance);

  /// Takes a whole new map.
  void SetMap(const OccupancyGrid& map);

  /// Takes the new values of windows, one after the other. Equal to SetMap with
  /// the changed map, cell for cell.
  /// @param[in] windows within the bounds of the map last set.
  /// @return the windows in which clearance was recomputed, without overlap;
  ///   none when no cell became occupied or ceased to be.
  std::vector<cv::Rect> Update(const std::vector<MapWindow>& windows);

  /// The same with a single one.
  std::vector<cv::Rect> Update(const cv::Rect& window,
                               const std::vector<std::int8_t>& values);

  const GridGeometry& geometry() const { return map_.geometry(); }
  const OccupancyGrid& map() const { return map_; }
  double max_distance() const { return max_distance_; }

  bool IsOccupied(const Cell& cell) const {
    return map_[cell] >= occupied_threshold_;
  }

  /// m, for a cell within the map.
  double At(const Cell& cell) const { return distance_[cell]; }

  /// m, at a point of the map's frame: that of the cell the point lies in.
  double At(const Eigen::Vector2d& point) const {
    const Cell cell = geometry().ToCell(point);
    return geometry().Contains(cell) ? At(cell) : max_distance_;
  }

  /// True when no occupied cell's centre lies within the footprint at `pose`,
  /// each side grown by `margin` (m, give half a cell's diagonal to be sure of
  /// whole cells).
  bool IsFree(const Footprint& footprint, const Pose2D& pose,
              double margin) const;

 private:
  class TileSet;

  bool IsRowFree(const CellRow& row) const;
  /// Puts a window into the map.
  /// @param[in,out] dirty gets the tiles in which clearance changes.
  void Enter(const cv::Rect& window, const std::vector<std::int8_t>& values,
             TileSet& dirty);
  /// @return the windows of the tiles.
  std::vector<cv::Rect> Recompute(const TileSet& dirty);
  void Recompute(const cv::Rect& window);

  /// Cells that an obstacle reaches: max_distance, rounded up.
  int Reach() const;

  int occupied_threshold_;
  double max_distance_;
  OccupancyGrid map_;
  Grid<float> distance_;
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_GRID_CLEARANCE_H_
