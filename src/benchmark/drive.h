#ifndef VFH_ASTAR_BENCHMARK_DRIVE_H_
#define VFH_ASTAR_BENCHMARK_DRIVE_H_

#include <optional>
#include <string>
#include <vector>

#include "benchmark/navigation_stack.h"
#include "vfh_astar/geometry.h"
#include "vfh_astar/navigation/state_machine.h"
#include "vfh_astar/simulation/simulation.h"

namespace vfh_astar {

/// One drive of the whole stack in the simulator, in lock-step and as fast as
/// the processor allows.
struct DriveTask {
  World world;
  Pose2D goal;  ///< in the world's frame, which is also the map's.
  SimulationParameters simulation;
  StackParameters stack;
  double time_limit = 100.0;  ///< s of simulated time.
};

/// The state of a drive at the time of a scan.
struct DriveSample {
  double time = 0.0;  ///< s
  Pose2D pose;        ///< true, world frame.
  Pose2D estimate;    ///< what the robot believes, map frame.
  Twist2D twist;      ///< true.
  Twist2D command;
  NavigatorStatus status;
};

struct DriveResult {
  std::string
      outcome;  ///< success, collision, timeout, or the navigator's own.
  std::string message;
  double time = 0.0;           ///< s from the start to the end of the drive.
  double path = 0.0;           ///< m driven.
  double min_clearance = 0.0;  ///< m between footprint and anything solid.
  int replans = 0;
  double rms_error = 0.0;  ///< m, of the tracked position, while tracking.
  double max_error = 0.0;  ///< m, likewise.
  std::optional<Collision> collision;
  std::vector<DriveSample> samples;
};

DriveResult Drive(const DriveTask& task);

}  // namespace vfh_astar

#endif  // VFH_ASTAR_BENCHMARK_DRIVE_H_
