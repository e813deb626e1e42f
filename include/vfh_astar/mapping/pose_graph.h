#ifndef VFH_ASTAR_MAPPING_POSE_GRAPH_H_
#define VFH_ASTAR_MAPPING_POSE_GRAPH_H_

#include <Eigen/Core>
#include <vector>

#include "vfh_astar/geometry.h"

namespace vfh_astar {

/// A measured motion from one pose to another.
struct PoseConstraint {
  int from = 0;
  int to = 0;
  Pose2D motion;  ///< `to` in the frame of `from`.
  /// Over (x, y, theta) of the motion, in the frame of `from`; positive
  /// semidefinite.
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  /// True for what may be wrong altogether: its pull is bounded.
  bool is_doubtful = false;
};

/// The information of a constraint from what is known about `to` in the map's
/// frame.
Eigen::Matrix3d InFrameOf(const Pose2D& from,
                          const Eigen::Matrix3d& map_information);

struct PoseGraphParameters {
  /// Standard deviations from which on a doubtful constraint pulls less and
  /// less (Cauchy).
  double doubt_width = 1.0;
  int max_iterations = 20;
};

/// The poses that meet the constraints best, by Ceres's sparse Levenberg-
/// Marquardt. The first pose stays where it is.
/// @param[in] poses where to begin; each has to be held by constraints.
std::vector<Pose2D> OptimizePoses(
    const std::vector<Pose2D>& poses,
    const std::vector<PoseConstraint>& constraints,
    const PoseGraphParameters& parameters);

}  // namespace vfh_astar

#endif  // VFH_ASTAR_MAPPING_POSE_GRAPH_H_
