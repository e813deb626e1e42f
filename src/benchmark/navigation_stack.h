#ifndef VFH_ASTAR_BENCHMARK_NAVIGATION_STACK_H_
#define VFH_ASTAR_BENCHMARK_NAVIGATION_STACK_H_

#include <optional>
#include <string>

#include "benchmark/stage_times.h"
#include "vfh_astar/geometry.h"
#include "vfh_astar/grid/clearance.h"
#include "vfh_astar/laser_scan.h"
#include "vfh_astar/mapping/slam_mapper.h"
#include "vfh_astar/navigation/navigator.h"
#include "vfh_astar/planning/path_planner.h"
#include "vfh_astar/trajectory/trajectory_fitter.h"

namespace vfh_astar {

/// The parameters of all stages, as a configuration file has them.
struct StackParameters {
  SlamMapperParameters mapper;
  PathPlannerParameters planner;
  TrajectoryFitterParameters fitter;
  NavigatorParameters navigator;
};

/// @throws ParameterError, see LoadParameters.
StackParameters LoadStackParameters(const std::string& file);

/// What the robot senses when a scan has been taken.
struct Sensing {
  LaserScan scan;
  Pose2D base_from_laser;
  double odometry_stamp = 0.0;  ///< s
  Pose2D odom_from_base;
  Twist2D twist;
};

/// Mapper, planner, fitter and navigator in one process, in the order in which
/// the nodelets hand on their messages. An answer of planner and fitter reaches
/// the navigator with the next scan.
class NavigationStack {
 public:
  /// @param[in] start of the robot in the map.
  /// @param[in,out] times takes how long the stages took; null: nobody asks.
  NavigationStack(const StackParameters& parameters, const Pose2D& start,
                  StageTimes* times = nullptr);

  void SetGoal(const Pose2D& goal) { navigator_.SetGoal("goal", goal); }

  /// Drives this trajectory instead of what planner and fitter would find.
  /// There is no other: a robot that leaves it fails.
  void SetCourse(const Trajectory& course) { course_ = course; }

  /// One cycle at the time of a scan.
  NavigatorOutput Update(const Sensing& sensing);

  const SlamMapper& mapper() const { return mapper_; }
  /// The path and the trajectory last made; empty before.
  const std::vector<Eigen::Vector2d>& path() const { return path_; }
  const Trajectory& trajectory() const { return trajectory_; }

 private:
  void InsertScan(const Sensing& sensing);
  void TakeIn(const MapChange& change);
  void Answer(const MotionRequest& request);
  void AnswerWithCourse(const MotionRequest& request);

  StageTimes* times_;
  SlamMapper mapper_;
  PathPlanner planner_;
  TrajectoryFitter fitter_;
  Navigator navigator_;
  ClearanceMap clearance_;
  std::vector<Eigen::Vector2d> path_;
  Trajectory trajectory_;
  std::optional<Trajectory> course_;
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_BENCHMARK_NAVIGATION_STACK_H_
