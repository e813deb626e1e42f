#include "benchmark/planner_command.h"

#include <boost/program_options.hpp>
#include <iostream>
#include <nlohmann/json.hpp>
#include <stdexcept>

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
  const int count = options[name].as<int>();
  if (count < 1) {
    throw std::invalid_argument("--" + name + " is " + std::to_string(count) +
                                "; expected 1 or more");
  }
  return count;
}

PlannerBenchmarkOptions Parse(const std::vector<std::string>& arguments) {
  po::variables_map options;
  po::store(po::command_line_parser(arguments).options(Options()).run(),
            options);
  po::notify(options);
  return {options["map"].as<std::string>(), options["scen"].as<std::string>(),
          Count(options, "limit"), Count(options, "longest")};
}

}  // namespace

int RunPlannerCommand(const std::vector<std::string>& arguments) {
  PlannerBenchmarkOptions options;
  try {
    options = Parse(arguments);
  } catch (const std::logic_error& error) {
    std::cerr << "planner: " << error.what() << "\n" << Options();
    return 2;
  }
  const PlannerFigures figures = RunPlannerBenchmark(options);
  const nlohmann::json json = {
      {"queries", figures.queries},
      {"solved", figures.solved},
      {"max_cost_error", figures.max_cost_error},
      {"median_ms", figures.median_ms},
      {"p95_ms", figures.p95_ms},
      {"nodes_expanded_median", figures.nodes_expanded_median}};
  std::cout << json.dump(2) << "\n";
  return 0;
}

}  // namespace vfh_astar
