#ifndef VFH_ASTAR_BENCHMARK_PLANNER_FIGURES_H_
#define VFH_ASTAR_BENCHMARK_PLANNER_FIGURES_H_

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

namespace vfh_astar {

/// What a search was like in many queries.
struct PlannerFigures {
  int queries = 0;
  int solved = 0;
  double max_cost_error = 0.0;  ///< of the solved ones, from the optimum.
  double median_ms = 0.0;       ///< wall time of one query on one core.
  double p95_ms = 0.0;
  std::int64_t nodes_expanded_median = 0;

  nlohmann::json ToJson() const;
};

/// Gathers queries one by one.
class PlannerTally {
 public:
  /// @param[in] cost_error from the optimum; nothing when it was not solved.
  void Add(double time_ms, std::int64_t nodes_expanded,
           std::optional<double> cost_error);

  /// After one query or more.
  PlannerFigures Figures() const;

 private:
  int solved_ = 0;
  double max_cost_error_ = 0.0;
  std::vector<double> times_ms_;
  std::vector<std::int64_t> nodes_;
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_BENCHMARK_PLANNER_FIGURES_H_
