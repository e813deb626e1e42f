#ifndef VFH_ASTAR_BENCHMARK_DRIVE_COMMAND_H_
#define VFH_ASTAR_BENCHMARK_DRIVE_COMMAND_H_

#include "benchmark/command.h"

namespace vfh_astar {

/// `drive`: one drive of the whole stack in one world.
/// Its run throws WorldFileError, MapFileError, ParameterError for unusable
/// files.
Command DriveCommand();

}  // namespace vfh_astar

#endif  // VFH_ASTAR_BENCHMARK_DRIVE_COMMAND_H_
