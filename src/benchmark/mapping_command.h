#ifndef VFH_ASTAR_BENCHMARK_MAPPING_COMMAND_H_
#define VFH_ASTAR_BENCHMARK_MAPPING_COMMAND_H_

#include "benchmark/command.h"

namespace vfh_astar {

/// `mapping`: SLAM over a CARMEN log, how far its poses are off and what it
/// costs.
/// Its run throws CarmenLogError, RelationsError for unusable files,
/// std::runtime_error when the picture cannot be written.
Command MappingCommand();

}  // namespace vfh_astar

#endif  // VFH_ASTAR_BENCHMARK_MAPPING_COMMAND_H_
