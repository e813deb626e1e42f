#ifndef VFH_ASTAR_TRAJECTORY_FIRST_COLLISION_H_
#define VFH_ASTAR_TRAJECTORY_FIRST_COLLISION_H_

#include <optional>

#include "vfh_astar/footprint.h"
#include "vfh_astar/grid/clearance.h"
#include "vfh_astar/trajectory/trajectory.h"

namespace vfh_astar {

/// The first time in [from, to] (s) at which the footprint, grown by `margin`
/// (m), is not free of occupied cells' centres; nothing when it is free all
/// along.
///
/// Where the nearest obstacle is c metres beyond the circumscribed circle the
/// next c metres need no look; elsewhere no point of the footprint moves by
/// more than 15 mm between two looks.
std::optional<double> FirstCollision(const Trajectory& trajectory,
                                     const Footprint& footprint,
                                     const ClearanceMap& clearance,
                                     double margin, double from, double to);

}  // namespace vfh_astar

#endif  // VFH_ASTAR_TRAJECTORY_FIRST_COLLISION_H_
