#ifndef VFH_ASTAR_MAPPING_GRID_MAPPER_H_
#define VFH_ASTAR_MAPPING_GRID_MAPPER_H_

#include <opencv2/core/types.hpp>
#include <optional>

#include "vfh_astar/geometry.h"
#include "vfh_astar/grid/grid.h"
#include "vfh_astar/laser_scan.h"
#include "vfh_astar/mapping/log_odds_grid.h"
#include "vfh_astar/mapping/scan_inserter.h"
#include "vfh_astar/parameters.h"

namespace vfh_astar {

/// Names are gmapping's where the meaning is.
struct GridMapperParameters {
  double delta = 0.05;           ///< m per cell.
  double xmin = -25.0;           ///< m, the map's first extent; it grows.
  double ymin = -25.0;           ///< m
  double xmax = 25.0;            ///< m
  double ymax = 25.0;            ///< m
  double linear_update = 0.05;   ///< m driven until the next scan is used.
  double angular_update = 0.05;  ///< rad turned until the next scan is used.
  double temporal_update = 0.1;  ///< s until the next scan is used anyway.
  ScanInserterParameters insertion;

  void Read(ParameterReader& reader);
};

/// What one scan changed.
struct MapChange {
  bool inserted = false;  ///< false: throttled, nothing changed.
  bool resized = false;   ///< the map's geometry is new: publish it whole.
  cv::Rect window;        ///< the cells whose published value may differ.
};

/// Turns scans at known poses into an occupancy map.
class GridMapper {
 public:
  explicit GridMapper(const GridMapperParameters& parameters);

  /// Starts from a given map (cells 0 to 100 or kUnknown) instead of an empty
  /// one; its geometry replaces the parameters' extent.
  void SetMap(const OccupancyGrid& map);

  /// @param[in] scan without defect (see DescribeDefect); scan.stamp s.
  /// @param[in] laser_pose the laser in the map's frame when the scan was
  /// taken.
  MapChange AddScan(const LaserScan& scan, const Pose2D& laser_pose);

  const GridGeometry& geometry() const { return grid_.geometry(); }
  const LogOddsGrid& grid() const { return grid_; }

  /// The map as published.
  OccupancyGrid Map() const;

  /// The published values of a window of the map, row by row.
  std::vector<std::int8_t> Values(const cv::Rect& window) const;

  /// Mean entropy of the explored cells, nats per cell.
  double Entropy() const;

 private:
  bool IsDue(double stamp, const Pose2D& laser_pose) const;

  GridMapperParameters parameters_;
  LogOddsGrid grid_;
  ScanInserter inserter_;
  std::optional<double> last_stamp_;
  Pose2D last_pose_;
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_MAPPING_GRID_MAPPER_H_
