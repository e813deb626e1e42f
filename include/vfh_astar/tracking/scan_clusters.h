#ifndef VFH_ASTAR_TRACKING_SCAN_CLUSTERS_H_
#define VFH_ASTAR_TRACKING_SCAN_CLUSTERS_H_

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

#include "vfh_astar/geometry.h"
#include "vfh_astar/laser_scan.h"

namespace vfh_astar {

/// Hits of neighbouring beams that lie close together.
struct ScanCluster {
  std::vector<Eigen::Vector2d> points;  ///< m, by beam.
  std::vector<std::size_t> beams;       ///< as many, rising.
  double extent = 0.0;                  ///< m, between the first and the last.
};

/// Splits the hits of a scan where two in a row lie apart by more than beams on
/// one surface would. A beam without a hit does not split.
/// @param[in] laser_pose the laser in the frame the points are wanted in.
/// @param[in] max_range m, farther hits are left out.
std::vector<ScanCluster> FindClusters(const LaserScan& scan,
                                      const Pose2D& laser_pose,
                                      double max_range);

struct Circle {
  Eigen::Vector2d centre;
  double radius;  ///< m
  double error;   ///< m, root mean square of the points' distances from it.
};

/// The circle through points by least squares (Kasa 1976); nothing for fewer
/// than five points or points in a line.
std::optional<Circle> FitCircle(const std::vector<Eigen::Vector2d>& points);

}  // namespace vfh_astar

#endif  // VFH_ASTAR_TRACKING_SCAN_CLUSTERS_H_
