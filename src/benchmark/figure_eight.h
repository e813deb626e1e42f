#ifndef VFH_ASTAR_BENCHMARK_FIGURE_EIGHT_H_
#define VFH_ASTAR_BENCHMARK_FIGURE_EIGHT_H_

#include "vfh_astar/geometry.h"
#include "vfh_astar/robot_limits.h"
#include "vfh_astar/trajectory/trajectory.h"

namespace vfh_astar {

/// Where FigureEight begins and ends: at its crossing, on the way into the lobe
/// on the right.
Pose2D FigureEightStart();

/// A lap of Bernoulli's lemniscate
///   x = a cos t / (1 + sin^2 t), y = a sin t cos t / (1 + sin^2 t),
/// whose curvature is never above 3 / a. It is large enough for `speed` to keep
/// within a lateral acceleration of 1.5 m/s^2 or the limit, and is driven at
/// constant speed but for its ends.
/// @param[in] speed m/s, above 0.
Trajectory FigureEight(double speed, RobotLimits limits);

}  // namespace vfh_astar

#endif  // VFH_ASTAR_BENCHMARK_FIGURE_EIGHT_H_
