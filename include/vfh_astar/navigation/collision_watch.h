#ifndef VFH_ASTAR_NAVIGATION_COLLISION_WATCH_H_
#define VFH_ASTAR_NAVIGATION_COLLISION_WATCH_H_

#include <limits>

#include "vfh_astar/footprint.h"
#include "vfh_astar/navigation/observation.h"
#include "vfh_astar/trajectory/trajectory.h"

namespace vfh_astar {

inline constexpr double kNever = std::numeric_limits<double>::infinity();

/// s from time `from` on a trajectory until the footprint, grown by `margin`
/// (m), reaches a hit of the scan; kNever when that lies beyond `horizon` (s).
double TimeToScanCollision(const Trajectory& trajectory, double from,
                           double horizon, const Footprint& footprint,
                           double margin, const Observation& observation);

/// The same against the occupied cells of the map; kNever without a map.
double TimeToMapCollision(const Trajectory& trajectory, double from,
                          double horizon, const Footprint& footprint,
                          double margin, const Observation& observation);

/// The same against what moves, each on its straight way, kept clear of by
/// `margin` (m) and by `growth` (m/s) more with the time ahead.
/// @param[in] rate at which the trajectory is driven, of its own time.
double TimeToMoverCollision(const Trajectory& trajectory, double from,
                            double horizon, double rate,
                            const Footprint& footprint, double margin,
                            double growth, const Observation& observation);

/// The same for a robot that stands where it is; counted from now.
double TimeToMoverContact(double horizon, const Footprint& footprint,
                          double margin, double growth,
                          const Observation& observation);

}  // namespace vfh_astar

#endif  // VFH_ASTAR_NAVIGATION_COLLISION_WATCH_H_
