#ifndef VFH_ASTAR_BENCHMARK_WORLD_PLANNER_BENCHMARK_H_
#define VFH_ASTAR_BENCHMARK_WORLD_PLANNER_BENCHMARK_H_

#include <cstdint>
#include <stdexcept>
#include <string>

#include "benchmark/planner_figures.h"

namespace vfh_astar {

struct WorldPlannerOptions {
  std::string map;        ///< a map_server yaml.
  int solid_below = 205;  ///< grey value; see MapLoadOptions.
  int queries = 200;
  int padding = 0;  ///< free cells added at each side of the map.
  std::uint32_t seed = 1;
};

/// A map that has no two places to plan between.
class WorldPlannerError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Plans between random poses with the cost of inflation, through a
/// PathPlanner with its default parameters. Both poses have room for the
/// footprint, lie 10 m or more apart, in cells that the map itself calls free,
/// and a way leads from one to the other for the inscribed circle. The same
/// seed gives the same pairs whatever the padding. Nothing but the query is
/// timed.
///
/// The optimum is that of Dijkstra's algorithm on the same costs; costs are in
/// m, weighted.
/// @throws MapFileError, WorldPlannerError
PlannerFigures RunWorldPlannerBenchmark(const WorldPlannerOptions& options);

}  // namespace vfh_astar

#endif  // VFH_ASTAR_BENCHMARK_WORLD_PLANNER_BENCHMARK_H_
