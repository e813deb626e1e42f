#ifndef VFH_ASTAR_SIMULATION_YAML_WORLD_H_
#define VFH_ASTAR_SIMULATION_YAML_WORLD_H_

#include "vfh_astar/simulation/world.h"
#include "vfh_astar/yaml_field.h"

namespace vfh_astar {

/// A world in this package's own format, version 1; doc/worlds.md describes it.
/// Entries that the format does not know are refused.
/// @throws YamlFieldError, or MapFileError for a bitmap that it names.
World ReadYamlWorld(const YamlField& root, const WorldLoadOptions& options);

}  // namespace vfh_astar

#endif  // VFH_ASTAR_SIMULATION_YAML_WORLD_H_
