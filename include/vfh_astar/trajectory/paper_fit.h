#ifndef VFH_ASTAR_TRAJECTORY_PAPER_FIT_H_
#define VFH_ASTAR_TRAJECTORY_PAPER_FIT_H_

#include "vfh_astar/trajectory/polyline.h"
#include "vfh_astar/trajectory/trajectory.h"

namespace vfh_astar {

/// The fit of Ma et al.: one quintic per axis over the whole path,
///   t_f = time_per_metre * (length of the path), t_k = k t_f / (n - 1),
/// by least squares on the n via points and on the velocities there. The paper
/// prints t_f / n, which never reaches t_f; and what is fitted is a polynomial
/// in t / t_f, because powers of t itself up to the fifth are too badly
/// conditioned for a path of a minute.
///
/// It takes the path as it is and checks nothing: on a winding path it cuts
/// corners, and through walls.
/// @param[in] path longer than 0; taken at points that are equally spaced, as
///   those of a grid nearly are.
/// @param[in] velocity m/s, at the start. At the end it is 0.
/// @param[in] time_per_metre s/m, more than 0.
Trajectory FitSingleQuintic(const Polyline& path,
                            const Eigen::Vector2d& velocity,
                            double time_per_metre);

}  // namespace vfh_astar

#endif  // VFH_ASTAR_TRAJECTORY_PAPER_FIT_H_
