#ifndef VFH_ASTAR_BENCHMARK_PLANNER_BENCHMARK_H_
#define VFH_ASTAR_BENCHMARK_PLANNER_BENCHMARK_H_

#include <string>

#include "benchmark/planner_figures.h"

namespace vfh_astar {

struct PlannerBenchmarkOptions {
  std::string map;       ///< a MovingAI .map file.
  std::string scenario;  ///< its .scen file.
  int limit = 0;         ///< so many queries spread evenly; 0 takes all.
  int longest = 0;       ///< so many of the longest queries; 0 takes all.
};

/// Runs the queries of a scenario at uniform cost. Nothing but the query is
/// timed, and nothing is worked out beforehand but the blocked cells.
/// Costs are in cells.
/// @throws MovingAiError; also when the scenario has no query, or one that
///   starts or ends in a blocked cell.
PlannerFigures RunPlannerBenchmark(const PlannerBenchmarkOptions& options);

}  // namespace vfh_astar

#endif  // VFH_ASTAR_BENCHMARK_PLANNER_BENCHMARK_H_
