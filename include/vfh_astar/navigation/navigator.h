#ifndef VFH_ASTAR_NAVIGATION_NAVIGATOR_H_
#define VFH_ASTAR_NAVIGATION_NAVIGATOR_H_

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "vfh_astar/geometry.h"
#include "vfh_astar/navigation/motion_request.h"
#include "vfh_astar/navigation/navigator_parameters.h"
#include "vfh_astar/navigation/observation.h"
#include "vfh_astar/navigation/state_machine.h"
#include "vfh_astar/outcome.h"
#include "vfh_astar/tracking/moving_obstacle.h"
#include "vfh_astar/trajectory/trajectory.h"

namespace vfh_astar {

/// What RViz and `navigation_state` show of a cycle.
struct NavigatorStatus {
  State state = State::kIdle;
  std::string reason;  ///< why the robot is in this state, or what holds it up.
  std::string goal_id;
  Eigen::Vector3d error = Eigen::Vector3d::Zero();  ///< e1, e2 (m), e3 (rad).
  double clearance = 0.0;  ///< m from the footprint to the nearest hit of the
                           ///< scan; +inf when there is none, NaN without a
                           ///< scan to go by.
  double speed = 0.0;      ///< m/s, measured.
  double distance_to_goal = 0.0;  ///< m, straight; 0 without goal.
  int replans = 0;                ///< since the goal came in.
  bool limited = false;           ///< the safety limiter changed the command.
  Pose2D pose;                    ///< map frame, at the cycle's time.
  std::optional<Reference> reference;  ///< what is being tracked.
  std::vector<double> vfh_histogram;   ///< polar density by sector, 0 to 1,
                                       ///< counter-clockwise from straight
                                       ///< behind (-pi); empty unless AVOIDING.
  std::vector<bool> vfh_blocked;       ///< as many.
  double vfh_direction = 0.0;          ///< rad, robot frame, chosen.
  std::vector<MovingObstacle> movers;  ///< map frame.
};

struct GoalResult {
  std::string goal_id;
  Outcome outcome = Outcome::kSuccess;
  std::string message;
};

struct NavigatorOutput {
  std::optional<Twist2D> command;        ///< nothing: say nothing on cmd_vel.
  std::optional<MotionRequest> request;  ///< a question to ask now.
  std::optional<GoalResult> result;      ///< a goal ended.
  NavigatorStatus status;
};

/// Drives the robot to its goals: tracking and VFH under the state machine,
/// with replanning and recovery, and the safety limiter last.
///
/// Called by one thread. Asks for trajectories through its output and takes the
/// answers through SetTrajectory and PlanFailed; never waits for one.
class Navigator {
 public:
  explicit Navigator(const NavigatorParameters& parameters);
  ~Navigator();

  /// Takes a new goal in the map's frame; a goal that is being pursued ends as
  /// cancelled at the next Update, without the robot stopping for it.
  void SetGoal(const std::string& goal_id, const Pose2D& goal);

  /// Ends the goal at the next Update. Nothing moves after that.
  void Cancel();

  void Pause();
  void Resume();

  /// The answer to request `id`; dropped when a newer request is out.
  void SetTrajectory(int id, Trajectory trajectory);

  /// The other answer to request `id`.
  void PlanFailed(int id, Outcome outcome, const std::string& message);

  /// One control cycle.
  NavigatorOutput Update(const NavigatorInput& input);

  /// Takes parameters that may change while driving.
  void SetParameters(const NavigatorParameters& parameters);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_NAVIGATION_NAVIGATOR_H_
