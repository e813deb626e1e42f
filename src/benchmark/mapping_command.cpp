#include "benchmark/mapping_command.h"

#include <cstdint>

#include "benchmark/mapping_benchmark.h"

namespace vfh_astar {
namespace {

namespace po = boost::program_options;

po::options_description Options() {
  po::options_description options("mapping");
  auto add = options.add_options();
  add("carmen", po::value<std::string>()->required(),
      "CARMEN log, gzip or plain");
  add("relations", po::value<std::string>(),
      "measured relations between poses: t1 t2 x y z roll pitch yaw");
  add("time-offset", po::value<double>()->default_value(0.0),
      "s to add to the log's stamps for those of the relations");
  add("particles", po::value<int>()->default_value(30), "1 matches scans only");
  add("seed", po::value<std::uint32_t>()->default_value(1), "");
  add("map-out", po::value<std::string>(), "write the map as a PNG");
  add("no-loop-closure", "leave out the pose graph");
  return options;
}

MappingBenchmarkOptions Read(const po::variables_map& given) {
  MappingBenchmarkOptions options;
  options.log = given["carmen"].as<std::string>();
  if (given.count("relations") != 0) {
    options.relations = given["relations"].as<std::string>();
  }
  options.time_offset = NumberOption(given, "time-offset", -1e12, 1e12);
  options.particles = NumberOption(given, "particles", 1, 1000);
  options.seed = given["seed"].as<std::uint32_t>();
  if (given.count("map-out") != 0) {
    options.map_picture = given["map-out"].as<std::string>();
  }
  options.loop_closure = given.count("no-loop-closure") == 0;
  return options;
}

nlohmann::json Run(const po::variables_map& given) {
  const MappingBenchmarkOptions options = Read(given);
  const MappingFigures figures = RunMappingBenchmark(options);
  return {
      {"translation_error_mean_m", figures.errors.translation_mean},
      {"translation_error_std_m", figures.errors.translation_std},
      {"rotation_error_mean_deg", figures.errors.rotation_mean * 180.0 / kPi},
      {"aligned_rmse_m", figures.aligned_error},
      {"relations", figures.relations},
      {"scans", figures.scans},
      {"cpu_ms_per_scan_particle",
       1e3 * figures.cpu_s / (figures.scans * options.particles)},
      {"log_s", figures.log_s},
      {"cpu_s", figures.cpu_s},
      {"realtime_factor", figures.log_s / figures.cpu_s}};
}

}  // namespace

Command MappingCommand() { return {"mapping", Options(), Run}; }

}  // namespace vfh_astar
