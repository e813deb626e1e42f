#include "benchmark/simulator_command.h"

#include <boost/program_options.hpp>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

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
  add("world", po::value<std::string>(), "world or map file");
  add("start", po::value<std::string>(), "X,Y,YAW of the first robot");
  return options;
}

template <typename T>
T Read(const po::variables_map& options, const std::string& name, T min,
       T max) {
  const T value = options[name].as<T>();
  // Written so that NaN fails.
  if (min <= value && value <= max) return value;
  std::ostringstream message;
  message << "--" << name << " is " << value << "; expected " << min << " to "
          << max;
  throw std::invalid_argument(message.str());
}

SimulatorBenchmarkOptions Parse(const std::vector<std::string>& arguments) {
  po::variables_map given;
  po::store(po::command_line_parser(arguments).options(Options()).run(), given);
  po::notify(given);
  SimulatorBenchmarkOptions options;
  options.robots = Read(given, "robots", 1, 100);
  options.beams = Read(given, "beams", 2, 100000);
  options.scan_rate = Read(given, "scan-rate", 0.1, 500.0);
  options.seconds = Read(given, "seconds", 0.1, 1e5);
  options.cylinders = Read(given, "cylinders", 0, 100000);
  if (given.count("world") != 0) {
    options.world = given["world"].as<std::string>();
  }
  if (given.count("start") != 0) {
    options.start = ParsePoseOption("start", given["start"].as<std::string>());
  }
  return options;
}

}  // namespace

int RunSimulatorCommand(const std::vector<std::string>& arguments) {
  SimulatorBenchmarkOptions options;
  try {
    options = Parse(arguments);
  } catch (const std::logic_error& error) {
    std::cerr << "simulator: " << error.what() << "\n" << Options();
    return 2;
  }
  const SimulatorFigures figures = RunSimulatorBenchmark(options);
  const nlohmann::json json = {{"realtime_factor", figures.realtime_factor},
                               {"rays_per_s", figures.rays_per_s},
                               {"steps_per_s", figures.steps_per_s}};
  std::cout << json.dump(2) << "\n";
  return 0;
}

}  // namespace vfh_astar
