#ifndef VFH_ASTAR_BENCHMARK_SIMULATOR_COMMAND_H_
#define VFH_ASTAR_BENCHMARK_SIMULATOR_COMMAND_H_

#include <string>
#include <vector>

namespace vfh_astar {

/// `simulator [--robots N] [--beams B] [--scan-rate HZ] [--seconds S]
/// [--cylinders N | --world FILE [--start X,Y,YAW]]`: how fast the simulation
/// runs on one core, as JSON on standard output.
/// @return the exit status: 0 when it ran, 2 for unusable arguments.
/// @throws WorldFileError, MapFileError for unusable files.
int RunSimulatorCommand(const std::vector<std::string>& arguments);

}  // namespace vfh_astar

#endif  // VFH_ASTAR_BENCHMARK_SIMULATOR_COMMAND_H_
