#ifndef VFH_ASTAR_BENCHMARK_DRIVE_H_
#define VFH_ASTAR_BENCHMARK_DRIVE_H_

#include <optional>
#include <string>
#include <vector>

#include "benchmark/navigation_stack.h"
#include "benchmark/stage_times.h"
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
  double time_limit = 100.0;         ///< s, counted as the drive's time is.
  std::optional<Trajectory> course;  ///< see NavigationStack::SetCourse.
  /// m from the goal at which a robot counts as there, whatever it thinks; 0:
  /// it ends the drive itself.
  double finish_radius = 0.0;
  /// m that the robot has to be from its start for its time to begin.
  double start_distance = 0.0;
  StageTimes* times = nullptr;  ///< takes the stack's, where not null.
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

/// What planner and fitter answered to a request.
struct DriveMotion {
  double time = 0.0;  ///< s
  std::vector<Eigen::Vector2d> path;
  Trajectory trajectory;
};

struct DriveResult {
  std::string
      outcome;  ///< success, collision, timeout, or the navigator's own.
  std::string message;
  double time = 0.0;           ///< s; see DriveTask::start_distance.
  double path = 0.0;           ///< m driven.
  double min_clearance = 0.0;  ///< m between footprint and anything solid.
  int replans = 0;
  double rms_error = 0.0;       ///< m, of the tracked position, while tracking.
  double max_error = 0.0;       ///< m, likewise.
  double true_rms_error = 0.0;  ///< m, likewise, of the true position: what
                                ///< localisation errs counts too.
  double goal_heading_error = 0.0;  ///< rad, of the true heading at the end.
  double pose_error = 0.0;          ///< m between the true position and the one
                                    ///< believed, at the last scan,
  double max_pose_error = 0.0;      ///< m, and the largest of all scans.
  std::optional<Collision> collision;
  std::vector<DriveSample> samples;
  std::vector<DriveMotion> motions;
};

/// Makes the map's first extent so large that it holds start and goal, with
/// room for ways around: a goal beyond it is refused.
void MakeRoomInMap(DriveTask* task);

DriveResult Drive(const DriveTask& task);

}  // namespace vfh_astar

#endif  // VFH_ASTAR_BENCHMARK_DRIVE_H_
