#ifndef VFH_ASTAR_BENCHMARK_TRAJECTORY_ERROR_H_
#define VFH_ASTAR_BENCHMARK_TRAJECTORY_ERROR_H_

#include <vector>

#include "vfh_astar/geometry.h"

namespace vfh_astar {

/// A pose as seen from another one.
struct PoseRelation {
  std::size_t from = 0;  ///< index of a pose of the trajectory.
  std::size_t to = 0;    ///< the same.
  Pose2D motion;         ///< `to` in the frame of `from`.
};

/// How far a trajectory's relations are from given ones, as Kuemmerle et al.
/// ("On measuring the accuracy of SLAM algorithms", Autonomous Robots 2009)
/// measure it.
struct RelationErrors {
  double translation_mean = 0.0;  ///< m, absolute.
  double translation_std = 0.0;   ///< m
  double rotation_mean = 0.0;     ///< rad, absolute.
};

/// The relations between neighbours.
std::vector<PoseRelation> ConsecutiveRelations(
    const std::vector<Pose2D>& trajectory);

/// @param[in] relations at least one.
RelationErrors CompareRelations(const std::vector<Pose2D>& trajectory,
                                const std::vector<PoseRelation>& relations);

/// m, the root mean square distance between positions of the same index, after
/// the rigid motion of the trajectory that makes it least.
/// @param[in] reference as many poses as the trajectory, at least one.
double AlignedError(const std::vector<Pose2D>& trajectory,
                    const std::vector<Pose2D>& reference);

}  // namespace vfh_astar

#endif  // VFH_ASTAR_BENCHMARK_TRAJECTORY_ERROR_H_
