#include "vfh_astar/navigation/state_machine.h"

namespace vfh_astar {
namespace {

constexpr State kGoalStates[] = {State::kPlanning,   State::kTracking,
                                 State::kAvoiding,   State::kReplanning,
                                 State::kRecovering, State::kPaused};

std::vector<Transition> BuildTable() {
  using S = State;
  using E = Event;
  using G = Guard;
  using A = Action;
  std::vector<Transition> table = {
      // A goal from rest, and a goal that replaces another while driving.
      {S::kIdle, E::kGoal, G::kAlways, S::kPlanning, A::kRequestPlan},
      {S::kSucceeded, E::kGoal, G::kAlways, S::kPlanning, A::kRequestPlan},
      {S::kAborted, E::kGoal, G::kAlways, S::kPlanning, A::kRequestPlan},
      {S::kPlanning, E::kGoal, G::kAlways, S::kPlanning, A::kRequestPlan},
      {S::kTracking, E::kGoal, G::kAlways, S::kReplanning, A::kRequestPlan},
      {S::kAvoiding, E::kGoal, G::kAlways, S::kReplanning, A::kRequestPlan},
      {S::kReplanning, E::kGoal, G::kAlways, S::kReplanning, A::kRequestPlan},
      {S::kRecovering, E::kGoal, G::kAlways, S::kPlanning, A::kRequestPlan},
      {S::kPaused, E::kGoal, G::kAlways, S::kPaused, A::kNone},

      // Standing until the first trajectory comes.
      {S::kPlanning, E::kTrajectory, G::kAlways, S::kTracking, A::kFollow},
      {S::kPlanning, E::kPlanFailed, G::kMayRecover, S::kRecovering,
       A::kStartRecovery},
      {S::kPlanning, E::kPlanFailed, G::kMayRetry, S::kPlanning, A::kRetryPlan},
      {S::kPlanning, E::kPlanFailed, G::kAlways, S::kAborted,
       A::kReportFailure},

      // On the trajectory.
      {S::kTracking, E::kArrived, G::kAlways, S::kSucceeded, A::kReportSuccess},
      {S::kTracking, E::kObstacle, G::kAlways, S::kAvoiding, A::kNone},
      {S::kTracking, E::kBlocked, G::kAlways, S::kReplanning, A::kRequestPlan},
      {S::kTracking, E::kDeviation, G::kAlways, S::kReplanning,
       A::kRequestPlan},
      {S::kTracking, E::kExpired, G::kAlways, S::kReplanning, A::kRequestPlan},
      {S::kTracking, E::kStuck, G::kMayRecover, S::kRecovering,
       A::kStartRecovery},
      {S::kTracking, E::kStuck, G::kAlways, S::kAborted, A::kReportFailure},
      {S::kTracking, E::kOscillation, G::kMayRecover, S::kRecovering,
       A::kStartRecovery},
      {S::kTracking, E::kOscillation, G::kAlways, S::kAborted,
       A::kReportFailure},

      // VFH drives.
      {S::kAvoiding, E::kArrived, G::kAlways, S::kSucceeded, A::kReportSuccess},
      {S::kAvoiding, E::kClear, G::kAlways, S::kTracking, A::kNone},
      {S::kAvoiding, E::kBlocked, G::kAlways, S::kReplanning, A::kRequestPlan},
      {S::kAvoiding, E::kDeviation, G::kAlways, S::kReplanning,
       A::kRequestPlan},
      {S::kAvoiding, E::kExpired, G::kAlways, S::kReplanning, A::kRequestPlan},
      {S::kAvoiding, E::kStuck, G::kMayRecover, S::kRecovering,
       A::kStartRecovery},
      {S::kAvoiding, E::kStuck, G::kAlways, S::kAborted, A::kReportFailure},
      {S::kAvoiding, E::kOscillation, G::kMayRecover, S::kRecovering,
       A::kStartRecovery},
      {S::kAvoiding, E::kOscillation, G::kAlways, S::kAborted,
       A::kReportFailure},

      // The old trajectory drives while a new one is made.
      {S::kReplanning, E::kTrajectory, G::kAlways, S::kTracking, A::kFollow},
      {S::kReplanning, E::kArrived, G::kAlways, S::kSucceeded,
       A::kReportSuccess},
      {S::kReplanning, E::kPlanFailed, G::kMoving, S::kPlanning,
       A::kRequestPlan},
      {S::kReplanning, E::kPlanFailed, G::kMayRecover, S::kRecovering,
       A::kStartRecovery},
      {S::kReplanning, E::kPlanFailed, G::kMayRetry, S::kReplanning,
       A::kRetryPlan},
      {S::kReplanning, E::kPlanFailed, G::kAlways, S::kAborted,
       A::kReportFailure},
      {S::kReplanning, E::kStuck, G::kMayRecover, S::kRecovering,
       A::kStartRecovery},
      {S::kReplanning, E::kStuck, G::kAlways, S::kAborted, A::kReportFailure},
      {S::kReplanning, E::kOscillation, G::kMayRecover, S::kRecovering,
       A::kStartRecovery},
      {S::kReplanning, E::kOscillation, G::kAlways, S::kAborted,
       A::kReportFailure},

      // A recovery ends by itself or by its time limit, and a plan follows.
      {S::kRecovering, E::kRecovered, G::kAlways, S::kPlanning,
       A::kRequestPlan},

      {S::kPaused, E::kResume, G::kAlways, S::kPlanning, A::kRequestPlan},
  };
  for (const State state : kGoalStates) {
    table.push_back(
        {state, E::kCancel, G::kAlways, S::kIdle, A::kReportCancelled});
    if (state == S::kPaused) continue;
    table.push_back({state, E::kPause, G::kAlways, S::kPaused, A::kStop});
    table.push_back(
        {state, E::kFault, G::kAlways, S::kAborted, A::kReportFailure});
  }
  return table;
}

bool Holds(Guard guard, const GuardValues& values) {
  switch (guard) {
    case Guard::kAlways:
      return true;
    case Guard::kMoving:
      return values.moving;
    case Guard::kMayRetry:
      return values.may_retry;
    case Guard::kMayRecover:
      return values.may_recover;
  }
  return false;
}

}  // namespace

const std::vector<Transition>& TransitionTable() {
  static const std::vector<Transition> table = BuildTable();
  return table;
}

std::optional<Action> StateMachine::Handle(Event event,
                                           const GuardValues& guards) {
  for (const Transition& transition : TransitionTable()) {
    if (transition.state != state_ || transition.event != event) continue;
    if (!Holds(transition.guard, guards)) continue;
    state_ = transition.next;
    return transition.action;
  }
  return std::nullopt;
}

bool IsDriving(State state) {
  return state == State::kTracking || state == State::kAvoiding ||
         state == State::kReplanning || state == State::kRecovering;
}

bool HasGoal(State state) {
  return state != State::kIdle && state != State::kSucceeded &&
         state != State::kAborted;
}

const char* ToString(State state) {
  switch (state) {
    case State::kIdle:
      return "IDLE";
    case State::kPlanning:
      return "PLANNING";
    case State::kTracking:
      return "TRACKING";
    case State::kAvoiding:
      return "AVOIDING";
    case State::kReplanning:
      return "REPLANNING";
    case State::kRecovering:
      return "RECOVERING";
    case State::kPaused:
      return "PAUSED";
    case State::kSucceeded:
      return "SUCCEEDED";
    case State::kAborted:
      return "ABORTED";
  }
  return "unknown state";
}

const char* ToString(Event event) {
  switch (event) {
    case Event::kGoal:
      return "new goal";
    case Event::kCancel:
      return "cancelled";
    case Event::kPause:
      return "paused";
    case Event::kResume:
      return "resumed";
    case Event::kTrajectory:
      return "trajectory received";
    case Event::kPlanFailed:
      return "planning failed";
    case Event::kObstacle:
      return "obstacle too close";
    case Event::kClear:
      return "way clear again";
    case Event::kDeviation:
      return "tracking error too large";
    case Event::kBlocked:
      return "trajectory blocked";
    case Event::kExpired:
      return "trajectory ended away from the goal";
    case Event::kArrived:
      return "goal reached";
    case Event::kStuck:
      return "no progress";
    case Event::kOscillation:
      return "to and fro without progress";
    case Event::kRecovered:
      return "recovery done";
    case Event::kFault:
      return "input missing";
  }
  return "unknown event";
}

}  // namespace vfh_astar
