#ifndef VFH_ASTAR_SIMULATION_DYNABARN_WORLD_H_
#define VFH_ASTAR_SIMULATION_DYNABARN_WORLD_H_

#include "vfh_astar/simulation/world.h"
#include "vfh_astar/yaml_field.h"

namespace vfh_astar {

/// A world of the DynaBARN benchmark: cylinders that run through keyframes and
/// jump back at the end of their period, in an arena of 20 x 20 m with walls at
/// x = -10 and y = +-10 m, 0.5 m thick. The walls are the benchmark's and not
/// in the file. The cylinders pass through them.
/// @param[in] root the JSON document: `start` [x, y, yaw], `goal` [x, y],
///   `obstacles` [{name, shape: cylinder, radius, period_s,
///   keyframes_t_x_y: [[t, x, y], ...]}].
/// @throws YamlFieldError
World ReadDynabarnWorld(const YamlField& root);

}  // namespace vfh_astar

#endif  // VFH_ASTAR_SIMULATION_DYNABARN_WORLD_H_
