#ifndef VFH_ASTAR_BENCHMARK_SIMULATOR_COMMAND_H_
#define VFH_ASTAR_BENCHMARK_SIMULATOR_COMMAND_H_

#include "benchmark/command.h"

namespace vfh_astar {

/// `simulator`: how fast the simulation runs on one core.
/// Its run throws WorldFileError, MapFileError for unusable files.
Command SimulatorCommand();

}  // namespace vfh_astar

#endif  // VFH_ASTAR_BENCHMARK_SIMULATOR_COMMAND_H_
