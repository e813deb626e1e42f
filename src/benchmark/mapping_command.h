#ifndef VFH_ASTAR_BENCHMARK_MAPPING_COMMAND_H_
#define VFH_ASTAR_BENCHMARK_MAPPING_COMMAND_H_

#include <string>
#include <vector>

namespace vfh_astar {

/// `mapping --carmen LOG.gz [--relations FILE --time-offset S] [--particles N]
/// [--seed S] [--map-out PNG] [--no-loop-closure]`: SLAM over a CARMEN log, how
/// far its poses are off and what it costs, as JSON on standard output.
/// @return the exit status: 0 when it ran, 2 for unusable arguments.
/// @throws CarmenLogError, RelationsError for unusable files,
///   std::runtime_error when the picture cannot be written.
int RunMappingCommand(const std::vector<std::string>& arguments);

}  // namespace vfh_astar

#endif  // VFH_ASTAR_BENCHMARK_MAPPING_COMMAND_H_
