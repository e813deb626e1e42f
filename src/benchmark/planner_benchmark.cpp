#include "benchmark/planner_benchmark.h"

#include <algorithm>
#include <chrono>
#include <optional>
#include <vector>

#include "vfh_astar/planning/moving_ai.h"
#include "vfh_astar/planning/uniform_search.h"

namespace vfh_astar {
namespace {

using Queries = std::vector<MovingAiQuery>;

/// The longest ones, then of these some spread evenly.
Queries Choose(Queries queries, const PlannerBenchmarkOptions& options) {
  const auto count = [&queries](int wanted) {
    return wanted == 0 ? queries.size()
                       : std::min<std::size_t>(wanted, queries.size());
  };
  if (options.longest != 0) {
    std::stable_sort(queries.begin(), queries.end(),
                     [](const MovingAiQuery& a, const MovingAiQuery& b) {
                       return a.length > b.length;
                     });
    queries.resize(count(options.longest));
  }
  Queries chosen;
  const std::size_t limit = count(options.limit);
  for (std::size_t i = 0; i < limit; ++i) {
    chosen.push_back(queries[i * queries.size() / limit]);
  }
  return chosen;
}

UniformSearch SearchOn(const Grid<std::uint8_t>& blocked) {
  const GridGeometry& geometry = blocked.geometry();
  UniformSearch search(geometry.width, geometry.height);
  for (int y = 0; y < geometry.height; ++y) {
    for (int x = 0; x < geometry.width; ++x) {
      if (blocked[{x, y}] != 0) search.SetBlocked({x, y}, true);
    }
  }
  return search;
}

}  // namespace

PlannerFigures RunPlannerBenchmark(const PlannerBenchmarkOptions& options) {
  using Clock = std::chrono::steady_clock;
  const Grid<std::uint8_t> blocked = ReadMovingAiMap(options.map);
  const Queries queries = Choose(
      ReadMovingAiScenario(options.scenario, blocked.geometry()), options);
  if (queries.empty()) {
    throw MovingAiError(options.scenario + ": no query; expected at least one");
  }
  UniformSearch search = SearchOn(blocked);

  PlannerTally tally;
  for (const MovingAiQuery& query : queries) {
    if (search.IsBlocked(query.start) || search.IsBlocked(query.goal)) {
      throw MovingAiError(
          options.scenario + ": the query from (" +
          std::to_string(query.start.x) + ", " + std::to_string(query.start.y) +
          ") starts or ends in a blocked cell of " + options.map);
    }
    const Clock::time_point begin = Clock::now();
    const JumpPointResult result = search.Run(query.start, query.goal);
    const std::chrono::duration<double, std::milli> time = Clock::now() - begin;
    tally.Add(time.count(), result.nodes_expanded,
              result.is_found
                  ? std::optional<double>(result.length - query.length)
                  : std::nullopt);
  }
  return tally.Figures();
}

}  // namespace vfh_astar
