#ifndef VFH_ASTAR_BENCHMARK_MAPPING_BENCHMARK_H_
#define VFH_ASTAR_BENCHMARK_MAPPING_BENCHMARK_H_

#include <cstdint>
#include <string>

#include "benchmark/trajectory_error.h"

namespace vfh_astar {

struct MappingBenchmarkOptions {
  std::string log;           ///< a CARMEN log.
  std::string relations;     ///< a relations file; empty takes the log's poses.
  double time_offset = 0.0;  ///< s, relations' time less the log's.
  int particles = 30;
  std::uint32_t seed = 1;
  std::string map_picture;  ///< PNG to write; empty for none.
  bool loop_closure = true;
};

struct MappingFigures {
  RelationErrors errors;
  double aligned_error = 0.0;  ///< m, root mean square; see AlignedError.
  int relations = 0;           ///< that the errors are measured over.
  int scans = 0;
  double log_s = 0.0;
  /// Processor time from the first scan to the finished map; reading the log
  /// and writing the picture are left out.
  double cpu_s = 0.0;
};

/// Runs SLAM over the raw odometry and the scans of a log; its poses are looked
/// at only to compare. A scan that SLAM passes over, as the robot has hardly
/// moved, gets its place from odometry between those of its neighbours.
/// @throws CarmenLogError, RelationsError, std::runtime_error when the picture
///   cannot be written.
MappingFigures RunMappingBenchmark(const MappingBenchmarkOptions& options);

}  // namespace vfh_astar

#endif  // VFH_ASTAR_BENCHMARK_MAPPING_BENCHMARK_H_
