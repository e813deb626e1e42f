#ifndef VFH_ASTAR_SIMULATION_MOVER_FIELDS_H_
#define VFH_ASTAR_SIMULATION_MOVER_FIELDS_H_

#include <string>

#include "vfh_astar/simulation/world.h"
#include "vfh_astar/yaml_field.h"

namespace vfh_astar {

/// An entry of `movers`: a box or cylinder about its own origin, and its way as
/// waypoints with a speed or as keyframes; doc/worlds.md describes it.
/// @throws YamlFieldError
Mover ReadMover(const YamlField& field, const std::string& name);

}  // namespace vfh_astar

#endif  // VFH_ASTAR_SIMULATION_MOVER_FIELDS_H_
