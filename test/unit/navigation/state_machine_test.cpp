#include "vfh_astar/navigation/state_machine.h"

#include <gtest/gtest.h>

#include <set>
#include <tuple>

namespace vfh_astar {
namespace {

constexpr GuardValues kNothing{};
constexpr GuardValues kMoving{true, false, false};
constexpr GuardValues kRetry{false, true, false};
constexpr GuardValues kRecover{false, false, true};

struct Row {
  State state;
  Event event;
  GuardValues guards;
  State next;
  Action action;
};

// What each state makes of each event; written down anew, so that a change of
// the table has to be meant.
const Row kRows[] = {
    {State::kIdle, Event::kGoal, kNothing, State::kPlanning,
     Action::kRequestPlan},
    {State::kSucceeded, Event::kGoal, kNothing, State::kPlanning,
     Action::kRequestPlan},
    {State::kAborted, Event::kGoal, kNothing, State::kPlanning,
     Action::kRequestPlan},

    {State::kPlanning, Event::kGoal, kNothing, State::kPlanning,
     Action::kRequestPlan},
    {State::kPlanning, Event::kCancel, kNothing, State::kIdle,
     Action::kReportCancelled},
    {State::kPlanning, Event::kPause, kNothing, State::kPaused, Action::kStop},
    {State::kPlanning, Event::kFault, kNothing, State::kAborted,
     Action::kReportFailure},
    {State::kPlanning, Event::kTrajectory, kNothing, State::kTracking,
     Action::kFollow},
    {State::kPlanning, Event::kPlanFailed, kRecover, State::kRecovering,
     Action::kStartRecovery},
    {State::kPlanning, Event::kPlanFailed, kRetry, State::kPlanning,
     Action::kRetryPlan},
    {State::kPlanning, Event::kPlanFailed, kNothing, State::kAborted,
     Action::kReportFailure},
    {State::kPlanning, Event::kPlanFailed, kMoving, State::kAborted,
     Action::kReportFailure},

    {State::kTracking, Event::kGoal, kNothing, State::kReplanning,
     Action::kRequestPlan},
    {State::kTracking, Event::kCancel, kNothing, State::kIdle,
     Action::kReportCancelled},
    {State::kTracking, Event::kPause, kNothing, State::kPaused, Action::kStop},
    {State::kTracking, Event::kFault, kNothing, State::kAborted,
     Action::kReportFailure},
    {State::kTracking, Event::kArrived, kNothing, State::kSucceeded,
     Action::kReportSuccess},
    {State::kTracking, Event::kObstacle, kNothing, State::kAvoiding,
     Action::kNone},
    {State::kTracking, Event::kBlocked, kNothing, State::kReplanning,
     Action::kRequestPlan},
    {State::kTracking, Event::kDeviation, kNothing, State::kReplanning,
     Action::kRequestPlan},
    {State::kTracking, Event::kExpired, kNothing, State::kReplanning,
     Action::kRequestPlan},
    {State::kTracking, Event::kStuck, kRecover, State::kRecovering,
     Action::kStartRecovery},
    {State::kTracking, Event::kStuck, kNothing, State::kAborted,
     Action::kReportFailure},
    {State::kTracking, Event::kOscillation, kRecover, State::kRecovering,
     Action::kStartRecovery},
    {State::kTracking, Event::kOscillation, kNothing, State::kAborted,
     Action::kReportFailure},

    {State::kAvoiding, Event::kGoal, kNothing, State::kReplanning,
     Action::kRequestPlan},
    {State::kAvoiding, Event::kCancel, kNothing, State::kIdle,
     Action::kReportCancelled},
    {State::kAvoiding, Event::kPause, kNothing, State::kPaused, Action::kStop},
    {State::kAvoiding, Event::kFault, kNothing, State::kAborted,
     Action::kReportFailure},
    {State::kAvoiding, Event::kArrived, kNothing, State::kSucceeded,
     Action::kReportSuccess},
    {State::kAvoiding, Event::kClear, kNothing, State::kTracking,
     Action::kNone},
    {State::kAvoiding, Event::kBlocked, kNothing, State::kReplanning,
     Action::kRequestPlan},
    {State::kAvoiding, Event::kDeviation, kNothing, State::kReplanning,
     Action::kRequestPlan},
    {State::kAvoiding, Event::kExpired, kNothing, State::kReplanning,
     Action::kRequestPlan},
    {State::kAvoiding, Event::kStuck, kRecover, State::kRecovering,
     Action::kStartRecovery},
    {State::kAvoiding, Event::kStuck, kNothing, State::kAborted,
     Action::kReportFailure},
    {State::kAvoiding, Event::kOscillation, kRecover, State::kRecovering,
     Action::kStartRecovery},
    {State::kAvoiding, Event::kOscillation, kNothing, State::kAborted,
     Action::kReportFailure},

    {State::kReplanning, Event::kGoal, kNothing, State::kReplanning,
     Action::kRequestPlan},
    {State::kReplanning, Event::kCancel, kNothing, State::kIdle,
     Action::kReportCancelled},
    {State::kReplanning, Event::kPause, kNothing, State::kPaused,
     Action::kStop},
    {State::kReplanning, Event::kFault, kNothing, State::kAborted,
     Action::kReportFailure},
    {State::kReplanning, Event::kTrajectory, kNothing, State::kTracking,
     Action::kFollow},
    {State::kReplanning, Event::kArrived, kNothing, State::kSucceeded,
     Action::kReportSuccess},
    {State::kReplanning, Event::kPlanFailed, kMoving, State::kPlanning,
     Action::kRequestPlan},
    {State::kReplanning, Event::kPlanFailed, kRecover, State::kRecovering,
     Action::kStartRecovery},
    {State::kReplanning, Event::kPlanFailed, kRetry, State::kReplanning,
     Action::kRetryPlan},
    {State::kReplanning, Event::kPlanFailed, kNothing, State::kAborted,
     Action::kReportFailure},
    {State::kReplanning, Event::kStuck, kRecover, State::kRecovering,
     Action::kStartRecovery},
    {State::kReplanning, Event::kStuck, kNothing, State::kAborted,
     Action::kReportFailure},
    {State::kReplanning, Event::kOscillation, kRecover, State::kRecovering,
     Action::kStartRecovery},
    {State::kReplanning, Event::kOscillation, kNothing, State::kAborted,
     Action::kReportFailure},

    {State::kRecovering, Event::kGoal, kNothing, State::kPlanning,
     Action::kRequestPlan},
    {State::kRecovering, Event::kCancel, kNothing, State::kIdle,
     Action::kReportCancelled},
    {State::kRecovering, Event::kPause, kNothing, State::kPaused,
     Action::kStop},
    {State::kRecovering, Event::kFault, kNothing, State::kAborted,
     Action::kReportFailure},
    {State::kRecovering, Event::kRecovered, kNothing, State::kPlanning,
     Action::kRequestPlan},

    {State::kPaused, Event::kGoal, kNothing, State::kPaused, Action::kNone},
    {State::kPaused, Event::kCancel, kNothing, State::kIdle,
     Action::kReportCancelled},
    {State::kPaused, Event::kResume, kNothing, State::kPlanning,
     Action::kRequestPlan},
};

TEST(StateMachineTest, RowByRow) {
  for (const Row& row : kRows) {
    SCOPED_TRACE(std::string(ToString(row.state)) + " + " +
                 ToString(row.event));
    StateMachine machine(row.state);
    const std::optional<Action> action = machine.Handle(row.event, row.guards);
    ASSERT_TRUE(action.has_value());
    EXPECT_EQ(*action, row.action);
    EXPECT_EQ(machine.state(), row.next);
  }
}

TEST(StateMachineTest, EverythingElseChangesNothing) {
  std::set<std::pair<State, Event>> meant;
  for (const Row& row : kRows) meant.insert({row.state, row.event});
  for (int s = 0; s <= static_cast<int>(State::kAborted); ++s) {
    for (int e = 0; e <= static_cast<int>(Event::kFault); ++e) {
      const State state = static_cast<State>(s);
      const Event event = static_cast<Event>(e);
      if (meant.count({state, event}) != 0) continue;
      SCOPED_TRACE(std::string(ToString(state)) + " + " + ToString(event));
      StateMachine machine(state);
      EXPECT_FALSE(machine.Handle(event, {true, true, true}).has_value());
      EXPECT_EQ(machine.state(), state);
    }
  }
}

TEST(StateMachineTest, TheTableHasNoRowBeyondTheseOnes) {
  EXPECT_EQ(TransitionTable().size(), std::size(kRows) - 1)
      << "one row above repeats a transition with a guard that does not count";
}

TEST(StateMachineTest, EveryStateWithAGoalCanBeCancelled) {
  for (int s = 0; s <= static_cast<int>(State::kAborted); ++s) {
    const State state = static_cast<State>(s);
    StateMachine machine(state);
    EXPECT_EQ(machine.Handle(Event::kCancel).has_value(), HasGoal(state))
        << ToString(state);
  }
}

}  // namespace
}  // namespace vfh_astar
