#ifndef VFH_ASTAR_BENCHMARK_PLANNER_BENCHMARK_H_
#define VFH_ASTAR_BENCHMARK_PLANNER_BENCHMARK_H_

#include <cstdint>
#include <string>

namespace vfh_astar {

struct PlannerBenchmarkOptions {
  std::string map;       ///< a MovingAI .map file.
  std::string scenario;  ///< its .scen file.
  int limit = 0;         ///< so many queries spread evenly; 0 takes all.
  int longest = 0;       ///< so many of the longest queries; 0 takes all.
};

struct PlannerFigures {
  int queries = 0;
  int solved = 0;
  double max_cost_error = 0.0;  ///< cells, from the scenario's optimum.
  double median_ms = 0.0;       ///< wall time of one query on one core.
  double p95_ms = 0.0;
  std::int64_t nodes_expanded_median = 0;
};

/// Runs the queries of a scenario at uniform cost. Nothing but the query is
/// timed, and nothing is worked out beforehand but the blocked cells.
/// @throws MovingAiError; also when the scenario has no query, or one that
///   starts or ends in a blocked cell.
PlannerFigures RunPlannerBenchmark(const PlannerBenchmarkOptions& options);

}  // namespace vfh_astar

#endif  // VFH_ASTAR_BENCHMARK_PLANNER_BENCHMARK_H_
