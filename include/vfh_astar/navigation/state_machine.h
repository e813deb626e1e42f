#ifndef VFH_ASTAR_NAVIGATION_STATE_MACHINE_H_
#define VFH_ASTAR_NAVIGATION_STATE_MACHINE_H_

#include <optional>
#include <vector>

namespace vfh_astar {

enum class State {
  kIdle,
  kPlanning,
  kTracking,
  kAvoiding,
  kReplanning,
  kRecovering,
  kPaused,
  kSucceeded,
  kAborted,
};

enum class Event {
  kGoal,    ///< a new goal came in.
  kCancel,  ///< the goal is withdrawn.
  kPause,
  kResume,
  kTrajectory,   ///< the answer to the latest request: a trajectory.
  kPlanFailed,   ///< the answer to the latest request: none, and why.
  kObstacle,     ///< something unplanned is too close ahead.
  kClear,        ///< the trajectory ahead is free and can be joined.
  kDeviation,    ///< the tracking error outgrew its threshold.
  kBlocked,      ///< the trajectory has been blocked for more than a moment.
  kExpired,      ///< the trajectory has ended, but not at the goal.
  kArrived,      ///< at the goal, and standing.
  kStuck,        ///< no progress for too long.
  kOscillation,  ///< moving for too long without leaving the place.
  kRecovered,    ///< the recovery manoeuvre is done.
  kFault,        ///< scan, odometry or transform missing for too long.
};

/// What has to hold for a transition besides its event.
enum class Guard {
  kAlways,
  kMoving,      ///< the robot moves, and a plan from rest might succeed.
  kMayRetry,    ///< the planner's failure may pass, and patience is left.
  kMayRecover,  ///< a recovery manoeuvre is left and could help.
};

/// What the navigator does on a transition.
enum class Action {
  kNone,
  kRequestPlan,  ///< ask for a path and trajectory to the goal.
  kRetryPlan,    ///< ask again after a pause.
  kFollow,       ///< follow the trajectory that has come.
  kStop,         ///< stop, keep the goal.
  kStartRecovery,
  kReportCancelled,  ///< stop, end the goal.
  kReportSuccess,    ///< stop, end the goal.
  kReportFailure,    ///< stop, end the goal with the last failure's outcome.
};

struct Transition {
  State state;
  Event event;
  Guard guard;
  State next;
  Action action;
};

/// All transitions; of those with the same state and event the first whose
/// guard holds is taken. What is not in the table changes nothing.
const std::vector<Transition>& TransitionTable();

/// Which guards hold at this moment.
struct GuardValues {
  bool moving = false;
  bool may_retry = false;
  bool may_recover = false;
};

class StateMachine {
 public:
  explicit StateMachine(State initial = State::kIdle) : state_(initial) {}

  State state() const { return state_; }

  /// Takes the transition for an event.
  /// @return its action, or nothing when the event means nothing in this state.
  std::optional<Action> Handle(Event event, const GuardValues& guards = {});

 private:
  State state_;
};

/// True while a goal is being pursued and the robot may move.
bool IsDriving(State state);

/// True while there is a goal, paused or not.
bool HasGoal(State state);

const char* ToString(State state);  ///< e.g. "TRACKING".
const char* ToString(Event event);

}  // namespace vfh_astar

#endif  // VFH_ASTAR_NAVIGATION_STATE_MACHINE_H_
