#include "benchmark/planner_command.h"

#include <limits>

#include "benchmark/planner_benchmark.h"
#include "benchmark/world_planner_benchmark.h"

namespace vfh_astar {
namespace {

namespace po = boost::program_options;

po::options_description Options() {
  po::options_description options(
      "planner --map FILE --scen FILE [OPTION ...]\n"
      "planner --world-map FILE [OPTION ...]");
  auto add = options.add_options();
  add("map", po::value<std::string>(), "MovingAI .map file; uniform cost");
  add("scen", po::value<std::string>(), "its .scen file");
  add("limit", po::value<int>(), "run N queries spread evenly");
  add("longest", po::value<int>(), "run the N longest queries");
  add("world-map", po::value<std::string>(),
      "map_server yaml; random pairs of poses, with the inflation's cost");
  const WorldPlannerOptions defaults;
  add("queries", po::value<int>()->default_value(defaults.queries),
      "pairs of poses on the world map");
  add("padding", po::value<int>()->default_value(defaults.padding),
      "free cells added at each side of the world map");
  add("seed", po::value<int>()->default_value(defaults.seed),
      "of the pairs of poses");
  add("solid-below", po::value<int>()->default_value(defaults.solid_below),
      "darker pixels of the world map are solid, others free");
  return options;
}

/// @return 0, which takes all, when the option is not given.
int Count(const po::variables_map& options, const std::string& name) {
  if (options.count(name) == 0) return 0;
  return NumberOption(options, name, 1, std::numeric_limits<int>::max());
}

PlannerFigures RunOnWorldMap(const po::variables_map& given) {
  for (const char* other : {"map", "scen", "limit", "longest"}) {
    if (given.count(other) != 0) {
      throw OptionError(std::string("--") + other +
                        " does not go with --world-map");
    }
  }
  WorldPlannerOptions options;
  options.map = given["world-map"].as<std::string>();
  options.queries = NumberOption(given, "queries", 1, 1000000);
  options.padding = NumberOption(given, "padding", 0, 10000);
  options.seed =
      NumberOption(given, "seed", 0, std::numeric_limits<int>::max());
  options.solid_below = NumberOption(given, "solid-below", 0, 256);
  return RunWorldPlannerBenchmark(options);
}

nlohmann::json Run(const po::variables_map& options) {
  if (options.count("world-map") != 0) return RunOnWorldMap(options).ToJson();
  for (const char* required : {"map", "scen"}) {
    if (options.count(required) == 0) {
      throw OptionError(std::string("--") + required +
                        " is missing; expected --map and --scen, or "
                        "--world-map");
    }
  }
  return RunPlannerBenchmark({options["map"].as<std::string>(),
                              options["scen"].as<std::string>(),
                              Count(options, "limit"),
                              Count(options, "longest")})
      .ToJson();
}

}  // namespace

Command PlannerCommand() { return {"planner", Options(), Run}; }

}  // namespace vfh_astar
