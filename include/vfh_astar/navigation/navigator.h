#ifndef VFH_ASTAR_NAVIGATION_NAVIGATOR_H_
#define VFH_ASTAR_NAVIGATION_NAVIGATOR_H_

#include <memory>
#include <optional>
#include <string>

#include "vfh_astar/geometry.h"
#include "vfh_astar/navigation/goal_record.h"
#include "vfh_astar/navigation/motion_request.h"
#include "vfh_astar/navigation/navigator_parameters.h"
#include "vfh_astar/navigation/navigator_status.h"
#include "vfh_astar/navigation/observation.h"
#include "vfh_astar/outcome.h"
#include "vfh_astar/trajectory/trajectory.h"

namespace vfh_astar {

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

  /// The answer to request `id`; dropped when another request is out.
  void SetTrajectory(const MotionRequestId& id, Trajectory trajectory);

  /// The other answer to request `id`.
  void PlanFailed(const MotionRequestId& id, Outcome outcome,
                  const std::string& message);

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
