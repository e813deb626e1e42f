#include "benchmark/planner_command.h"

#include <limits>

#include "benchmark/planner_benchmark.h"

namespace vfh_astar {
namespace {

namespace po = boost::program_options;

po::options_description Options() {
  po::options_description options("planner");
  auto add = options.add_options();
  add("map", po::value<std::string>()->required(), "MovingAI .map file");
  add("scen", po::value<std::string>()->required(), "its .scen file");
  add("limit", po::value<int>(), "run N queries spread evenly");
  add("longest", po::value<int>(), "run the N longest queries");
  return options;
}

/// @return 0, which takes all, when the option is not given.
int Count(const po::variables_map& options, const std::string& name) {
  if (options.count(name) == 0) return 0;
  return NumberOption(options, name, 1, std::numeric_limits<int>::max());
}

nlohmann::json Run(const po::variables_map& options) {
  const PlannerFigures figures = RunPlannerBenchmark(
      {options["map"].as<std::string>(), options["scen"].as<std::string>(),
       Count(options, "limit"), Count(options, "longest")});
  return {{"queries", figures.queries},
          {"solved", figures.solved},
          {"max_cost_error", figures.max_cost_error},
          {"median_ms", figures.median_ms},
          {"p95_ms", figures.p95_ms},
          {"nodes_expanded_median", figures.nodes_expanded_median}};
}

}  // namespace

Command PlannerCommand() { return {"planner", Options(), Run}; }

}  // namespace vfh_astar
