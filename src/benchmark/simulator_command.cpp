#include "benchmark/simulator_command.h"

#include "benchmark/pose_option.h"
#include "benchmark/simulator_benchmark.h"

namespace vfh_astar {
namespace {

namespace po = boost::program_options;

po::options_description Options() {
  const SimulatorBenchmarkOptions defaults;
  po::options_description options("simulator");
  auto add = options.add_options();
  add("robots", po::value<int>()->default_value(defaults.robots), "");
  add("beams", po::value<int>()->default_value(defaults.beams), "per scan");
  add("scan-rate", po::value<double>()->default_value(defaults.scan_rate),
      "Hz");
  add("seconds", po::value<double>()->default_value(defaults.seconds),
      "of simulated time");
  add("cylinders", po::value<int>()->default_value(defaults.cylinders),
      "in the field where no world is given");
  add("field", po::value<double>()->default_value(defaults.field),
      "m, the length of that field's sides");
  add("world", po::value<std::string>(), "world or map file");
  add("start", po::value<std::string>(), "X,Y,YAW of the first robot");
  return options;
}

SimulatorBenchmarkOptions Read(const po::variables_map& given) {
  SimulatorBenchmarkOptions options;
  options.robots = NumberOption(given, "robots", 1, 1000);
  options.beams = NumberOption(given, "beams", 2, 100000);
  options.scan_rate = NumberOption(given, "scan-rate", 0.1, 500.0);
  options.seconds = NumberOption(given, "seconds", 0.1, 1e5);
  options.cylinders = NumberOption(given, "cylinders", 0, 100000);
  options.field = NumberOption(given, "field", 10.0, 10000.0);
  if (given.count("world") != 0) {
    options.world = given["world"].as<std::string>();
  }
  if (given.count("start") != 0) {
    options.start = ParsePoseOption("start", given["start"].as<std::string>());
  }
  return options;
}

nlohmann::json Run(const po::variables_map& given) {
  const SimulatorFigures figures = RunSimulatorBenchmark(Read(given));
  return {{"realtime_factor", figures.realtime_factor},
          {"rays_per_s", figures.rays_per_s},
          {"steps_per_s", figures.steps_per_s}};
}

}  // namespace

Command SimulatorCommand() { return {"simulator", Options(), Run}; }

}  // namespace vfh_astar
