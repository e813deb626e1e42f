#include "benchmark/cycle_command.h"

#include <opencv2/core/utility.hpp>
#include <stdexcept>

#include "benchmark/drive.h"
#include "benchmark/quantile.h"

namespace vfh_astar {
namespace {

namespace po = boost::program_options;

po::options_description Options() {
  po::options_description options("cycle");
  auto add = options.add_options();
  add("world", po::value<std::string>()->required(),
      "world file that suggests a goal");
  add("config", po::value<std::string>()->required(),
      "parameters of the stack");
  add("seed", po::value<std::uint32_t>()->default_value(1), "of all chance");
  return options;
}

DriveTask TaskFrom(const po::variables_map& options) {
  DriveTask task;
  const auto world = options["world"].as<std::string>();
  task.world = LoadWorld(world);
  if (!task.world.goal) throw OptionError("--world " + world + " has no goal");
  task.goal = *task.world.goal;
  task.stack = LoadStackParameters(options["config"].as<std::string>());
  MakeRoomInMap(&task);
  task.simulation.laser = LaserPreset("paper");
  task.simulation.seed = options["seed"].as<std::uint32_t>();
  return task;
}

nlohmann::json ToJson(Stage stage, const std::vector<double>& times,
                      const std::string& outcome) {
  if (times.empty()) {
    throw std::runtime_error("the drive ended with '" + outcome +
                             "' before any " + ToString(stage));
  }
  return {{"count", times.size()},
          {"median_us", Quantile(times, 0.5)},
          {"p99_us", Quantile(times, 0.99)}};
}

nlohmann::json Run(const po::variables_map& options) {
  // The stack has no threads of its own.
  cv::setNumThreads(1);
  StageTimes times;
  DriveTask task = TaskFrom(options);
  task.times = &times;
  const DriveResult result = Drive(task);
  nlohmann::json stages;
  for (std::size_t i = 0; i < kStageCount; ++i) {
    const auto stage = static_cast<Stage>(i);
    stages[ToString(stage)] = ToJson(stage, times.Of(stage), result.outcome);
  }
  return {{"outcome", result.outcome},
          {"time_s", result.time},
          {"beams", task.simulation.laser.beams},
          {"stages", stages}};
}

}  // namespace

Command CycleCommand() { return {"cycle", Options(), Run}; }

}  // namespace vfh_astar
