#ifndef VFH_ASTAR_TRAJECTORY_PATH_SHORTENING_H_
#define VFH_ASTAR_TRAJECTORY_PATH_SHORTENING_H_

#include "vfh_astar/grid/clearance.h"
#include "vfh_astar/trajectory/polyline.h"

namespace vfh_astar {

/// How near a shortened path may come to an obstacle; distances as in
/// ClearanceMap, from the robot's centre.
struct ShorteningLimits {
  double needed = 0.0;  ///< m; below this the path itself is kept.
  double wanted = 0.0;  ///< m; more than this is not looked for.
};

/// Takes the zigzag of the grid out of a path: points are left out where the
/// straight line between the remaining ones is free and keeps about as much
/// clearance as the path has beside it, up to `wanted`. So a path in the middle
/// of a doorway stays there, and a path through the open becomes straight.
/// @param[in] path at least one point.
/// @return a subset of the path's points, with its first and its last.
Polyline ShortenPath(const Polyline& path, const ClearanceMap& clearance,
                     const ShorteningLimits& limits);

/// rad, of the first part of what ShortenPath returns, without the rest.
/// @param[in] path at least two points.
double FirstShortenedDirection(const Polyline& path,
                               const ClearanceMap& clearance,
                               const ShorteningLimits& limits);

}  // namespace vfh_astar

#endif  // VFH_ASTAR_TRAJECTORY_PATH_SHORTENING_H_
