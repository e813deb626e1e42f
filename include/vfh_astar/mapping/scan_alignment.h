#ifndef VFH_ASTAR_MAPPING_SCAN_ALIGNMENT_H_
#define VFH_ASTAR_MAPPING_SCAN_ALIGNMENT_H_

#include <Eigen/Core>
#include <vector>

#include "vfh_astar/geometry.h"
#include "vfh_astar/mapping/hit_field.h"

namespace vfh_astar {

/// What is known of a pose: a Gaussian over (x, y, theta) in the pose's own
/// frame of reference.
struct PoseBelief {
  Pose2D mean;
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();  ///< m^-2, rad^-2.
};

/// Where a scan has come to rest in a field.
struct Alignment {
  /// The pose, and the information of scan and prior about it.
  PoseBelief belief;
  /// The information of the scan alone.
  Eigen::Matrix3d scan_information = Eigen::Matrix3d::Zero();
  double fit = 0.0;      ///< the mean of the field at the points, 0 to 1.
  double utility = 0.0;  ///< what was maximised.
};

/// Moves a scan up the slope of a field, to below a cell: maximises
///
///   point_weight * sum of the field at the points
///     - 1/2 (pose - prior)^T information (pose - prior)
///
/// by Newton steps. The field falls off like a Gaussian of the distance from
/// the walls, so a point far from all of them neither pulls nor pushes.
///
/// @param[in] points m, in the scan's frame.
/// @param[in] start where to begin: within about a sigma of the field.
/// @param[in] sigma m, of the field's hits.
Alignment AlignScan(const HitField& field,
                    const std::vector<Eigen::Vector2d>& points,
                    const Pose2D& start, const PoseBelief& prior,
                    double point_weight, double sigma);

}  // namespace vfh_astar

#endif  // VFH_ASTAR_MAPPING_SCAN_ALIGNMENT_H_
