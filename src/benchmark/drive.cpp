#include "benchmark/drive.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vfh_astar {
namespace {

Sensing SensingOf(const Simulation& simulation) {
  const OdometryReading& odometry = simulation.filtered_odometry(0);
  Sensing sensing;
  sensing.scan = simulation.scan(0);
  sensing.base_from_laser = simulation.laser(0).mount;
  sensing.odometry_stamp = odometry.stamp;
  sensing.odom_from_base = odometry.pose;
  sensing.twist = odometry.twist;
  return sensing;
}

/// Adds up what is measured along a drive.
class Measurement {
 public:
  void AddMotion(const Simulation& simulation) {
    const Eigen::Vector2d position = simulation.TruePose(0).position();
    if (last_position_) path_ += (position - *last_position_).norm();
    last_position_ = position;
    min_clearance_ = std::min(min_clearance_, simulation.Clearance(0));
  }

  void AddCycle(const NavigatorStatus& status, const Pose2D& pose) {
    pose_error_ = (status.pose.position() - pose.position()).norm();
    max_pose_error_ = std::max(max_pose_error_, pose_error_);
    if (status.state != State::kTracking) return;
    if (status.reference) {
      true_squared_error_ +=
          (status.reference->pose.position() - pose.position()).squaredNorm();
    }
    const double error = status.error.head<2>().norm();
    squared_error_ += error * error;
    max_error_ = std::max(max_error_, error);
    ++cycles_;
  }

  void WriteTo(DriveResult* result) const {
    result->path = path_;
    result->min_clearance = min_clearance_;
    result->max_error = max_error_;
    result->pose_error = pose_error_;
    result->max_pose_error = max_pose_error_;
    if (cycles_ == 0) return;
    result->rms_error = std::sqrt(squared_error_ / cycles_);
    result->true_rms_error = std::sqrt(true_squared_error_ / cycles_);
  }

 private:
  std::optional<Eigen::Vector2d> last_position_;
  double path_ = 0.0;
  double min_clearance_ = std::numeric_limits<double>::infinity();
  double squared_error_ = 0.0;
  double true_squared_error_ = 0.0;
  double max_error_ = 0.0;
  double pose_error_ = 0.0;
  double max_pose_error_ = 0.0;
  int cycles_ = 0;
};

/// Says when a drive began and when it has to end, by the true pose.
class Referee {
 public:
  explicit Referee(const DriveTask& task) : task_(task) {}

  /// s of the drive's own time.
  double Time(const Simulation& simulation) {
    const Eigen::Vector2d way = simulation.TruePose(0).position() -
                                task_.world.robots.front().pose.position();
    if (!has_begun_ && way.norm() >= task_.start_distance) {
      has_begun_ = true;
      began_ = simulation.time();
    }
    return has_begun_ ? simulation.time() - began_ : 0.0;
  }

  bool IsThere(const Simulation& simulation) const {
    return task_.finish_radius > 0.0 &&
           (simulation.TruePose(0).position() - task_.goal.position()).norm() <=
               task_.finish_radius;
  }

 private:
  const DriveTask& task_;
  bool has_begun_ = false;
  double began_ = 0.0;  ///< s
};

}  // namespace

void MakeRoomInMap(DriveTask* task) {
  constexpr double kRoom = 15.0;  // m
  GridMapperParameters& map = task->stack.mapper.grid;
  for (const Pose2D& pose : {task->world.robots.front().pose, task->goal}) {
    map.xmin = std::min(map.xmin, pose.x - kRoom);
    map.ymin = std::min(map.ymin, pose.y - kRoom);
    map.xmax = std::max(map.xmax, pose.x + kRoom);
    map.ymax = std::max(map.ymax, pose.y + kRoom);
  }
}

DriveResult Drive(const DriveTask& task) {
  Simulation simulation(task.world, task.simulation);
  NavigationStack stack(task.stack, task.world.robots.front().pose, task.times);
  if (task.course) stack.SetCourse(*task.course);
  stack.SetGoal(task.goal);

  DriveResult result;
  result.outcome = "timeout";
  Measurement measurement;
  Referee referee(task);
  // A robot that never moves has no time of its own.
  while (result.time < task.time_limit &&
         simulation.time() < 2.0 * task.time_limit) {
    const StepEvents events = simulation.Step();
    result.time = referee.Time(simulation);
    if (events.odometry) measurement.AddMotion(simulation);
    if (simulation.collision(0)) {
      result.collision = simulation.collision(0);
      result.outcome = "collision";
      result.message = "touched " + result.collision->with;
      break;
    }
    if (referee.IsThere(simulation)) {
      result.outcome = ToString(Outcome::kSuccess);
      break;
    }
    if (!simulation.HasNewScan(0)) continue;
    const NavigatorOutput output = stack.Update(SensingOf(simulation));
    if (output.command) simulation.SetCommand(0, *output.command);
    if (output.request) {
      result.motions.push_back(
          {simulation.time(), stack.path(), stack.trajectory()});
    }
    measurement.AddCycle(output.status, simulation.TruePose(0));
    result.replans = output.status.replans;
    result.samples.push_back({simulation.time(), simulation.TruePose(0),
                              output.status.pose, simulation.TrueTwist(0),
                              output.command.value_or(Twist2D()),
                              output.status});
    if (output.result) {
      result.outcome = ToString(output.result->outcome);
      result.message = output.result->message;
      break;
    }
  }
  result.goal_heading_error =
      NormalizeAngle(simulation.TruePose(0).theta - task.goal.theta);
  measurement.WriteTo(&result);
  return result;
}

}  // namespace vfh_astar
