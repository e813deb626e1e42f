#ifndef VFH_ASTAR_BENCHMARK_CYCLE_COMMAND_H_
#define VFH_ASTAR_BENCHMARK_CYCLE_COMMAND_H_

#include "benchmark/command.h"

namespace vfh_astar {

/// `cycle`: how long each stage of the stack takes in a drive, on one core.
/// Its run throws WorldFileError, MapFileError, ParameterError for unusable
/// files, and std::runtime_error when the drive did not get to a stage.
Command CycleCommand();

}  // namespace vfh_astar

#endif  // VFH_ASTAR_BENCHMARK_CYCLE_COMMAND_H_
