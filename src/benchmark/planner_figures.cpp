#include "benchmark/planner_figures.h"

#include <algorithm>
#include <cmath>

#include "benchmark/quantile.h"

namespace vfh_astar {

nlohmann::json PlannerFigures::ToJson() const {
  return {{"queries", queries},
          {"solved", solved},
          {"max_cost_error", max_cost_error},
          {"median_ms", median_ms},
          {"p95_ms", p95_ms},
          {"nodes_expanded_median", nodes_expanded_median}};
}

void PlannerTally::Add(double time_ms, std::int64_t nodes_expanded,
                       std::optional<double> cost_error) {
  times_ms_.push_back(time_ms);
  nodes_.push_back(nodes_expanded);
  if (!cost_error) return;
  ++solved_;
  max_cost_error_ = std::max(max_cost_error_, std::abs(*cost_error));
}

PlannerFigures PlannerTally::Figures() const {
  PlannerFigures figures;
  figures.queries = static_cast<int>(times_ms_.size());
  figures.solved = solved_;
  figures.max_cost_error = max_cost_error_;
  figures.median_ms = Quantile(times_ms_, 0.5);
  figures.p95_ms = Quantile(times_ms_, 0.95);
  figures.nodes_expanded_median = Quantile(nodes_, 0.5);
  return figures;
}

}  // namespace vfh_astar
