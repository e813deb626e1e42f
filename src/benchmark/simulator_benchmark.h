#ifndef VFH_ASTAR_BENCHMARK_SIMULATOR_BENCHMARK_H_
#define VFH_ASTAR_BENCHMARK_SIMULATOR_BENCHMARK_H_

#include <optional>
#include <string>

#include "vfh_astar/geometry.h"

namespace vfh_astar {

struct SimulatorBenchmarkOptions {
  /// A world file; none: a square `field` with `cylinders` in it, fenced.
  std::optional<std::string> world;
  /// Of the first robot; none: the world's.
  std::optional<Pose2D> start;
  int robots = 1;
  int cylinders = 50;   ///< of radius 0.15 m, where no world is given.
  double field = 50.0;  ///< m, the length of its sides.
  int beams = 1080;
  double scan_rate = 40.0;  ///< Hz
  double seconds = 20.0;    ///< of simulated time.
};

struct SimulatorFigures {
  double realtime_factor = 0.0;  ///< simulated per wall time.
  /// Rays cast per second of wall time that is spent on rays alone.
  double rays_per_s = 0.0;
  double steps_per_s = 0.0;  ///< of physics, per second of wall time.
};

/// Lets all robots drive in circles and times it, in one thread; then times
/// their lasers alone.
/// @throws WorldFileError or MapFileError; std::invalid_argument when a robot
///   would not be free where it starts, or when `robots` is not the number of
///   robots in the given world.
SimulatorFigures RunSimulatorBenchmark(
    const SimulatorBenchmarkOptions& options);

}  // namespace vfh_astar

#endif  // VFH_ASTAR_BENCHMARK_SIMULATOR_BENCHMARK_H_
