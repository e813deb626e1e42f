#ifndef VFH_ASTAR_NAVIGATION_REQUEST_START_H_
#define VFH_ASTAR_NAVIGATION_REQUEST_START_H_

#include <optional>

#include "vfh_astar/navigation/driver.h"
#include "vfh_astar/navigation/navigator_parameters.h"
#include "vfh_astar/navigation/observation.h"

namespace vfh_astar {

/// Where a new trajectory shall begin.
struct RequestStart {
  Reference start;             ///< map frame.
  double time = 0.0;           ///< s, when the robot will be at `start`.
  std::optional<double> join;  ///< the clock of the trajectory that it
                               ///< continues, see TrajectoryFollower::Follow.
};

/// Lets the new trajectory continue the old one if the robot is on it, else
/// begin where the robot stands, or where its last command takes it while the
/// answer is awaited.
/// @param[in] observation without a fault.
/// @param[in] avoiding the robot is off its trajectory on purpose.
/// @param[in] time s, of the cycle.
RequestStart ChooseStart(const Driver& driver, const Observation& observation,
                         bool avoiding, double time,
                         const NavigatorParameters& parameters);

}  // namespace vfh_astar

#endif  // VFH_ASTAR_NAVIGATION_REQUEST_START_H_
