#include "vfh_astar/navigation/navigator.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <utility>

#include "vfh_astar/navigation/arrival.h"
#include "vfh_astar/navigation/driver.h"
#include "vfh_astar/navigation/failure_record.h"
#include "vfh_astar/navigation/goal_record.h"
#include "vfh_astar/navigation/oscillation_monitor.h"
#include "vfh_astar/navigation/recovery.h"
#include "vfh_astar/navigation/request_start.h"
#include "vfh_astar/navigation/stop_burst.h"
#include "vfh_astar/navigation/trajectory_watch.h"

namespace vfh_astar {
namespace {

constexpr double kRetryDelay = 0.5;    ///< s between two tries to plan.
constexpr double kHeldUp = 0.5;        ///< s that end a blocked recovery.
constexpr double kLongestCycle = 0.2;  ///< s counted for one cycle.

/// Something said from outside between two cycles.
struct Order {
  Event event;
  Goal goal;  ///< for kGoal.
};

}  // namespace

class Navigator::Impl {
 public:
  explicit Impl(const NavigatorParameters& parameters)
      : parameters_(parameters),
        tracker_(parameters.movers),
        driver_(parameters_),
        schedule_(parameters.replan.period, parameters.replan.timeout),
        watch_(parameters_),
        recovery_(parameters_.recovery, parameters_.footprint),
        oscillation_(parameters_.oscillation) {}

  void Tell(Order order) { orders_.push_back(std::move(order)); }
  void Answer(MotionAnswer answer) { answers_.push_back(std::move(answer)); }

  void SetParameters(const NavigatorParameters& parameters) {
    parameters_ = parameters;
    driver_.ParametersChanged();
  }

  NavigatorOutput Update(const NavigatorInput& input) {
    const double elapsed = time_ ? input.time - *time_ : 0.0;
    const double duration = std::clamp(elapsed, 0.0, kLongestCycle);
    time_ = input.time;
    TrackObstacles(input, tracker_);
    observation_ = Observe(input, parameters_, &tracker_);
    const bool was_moving = MayMove();

    TakeOrders();
    TakeAnswers();
    WatchFault();
    if (!observation_.fault) Watch();
    WatchOscillation(duration);
    WatchYielding();
    if (was_moving && !MayMove()) stop_.Begin(*time_);

    NavigatorOutput output;
    bool limited = false;
    output.command = Command(duration, &limited);
    output.request = Request();
    output.result = record_.TakeResult();
    output.status = Describe(machine_.state(), reason_, record_, observation_,
                             driver_, watch_.avoiding(), parameters_);
    output.status.limited = limited;
    return output;
  }

 private:
  void TakeOrders();
  void TakeAnswers();
  void WatchFault();
  void Watch();
  void WatchTrajectory();
  void WatchRecovery();
  void WatchOscillation(double duration);
  void WatchYielding();
  void Raise(Event event, const std::string& detail = "");
  void Perform(Action action);
  void EndGoal(Outcome outcome, const std::string& message);
  void ForgetTrajectory();
  GuardValues Guards() const;
  bool MayMove() const { return IsDriving(machine_.state()) || is_yielding_; }
  std::optional<Twist2D> Command(double duration, bool* limited);
  Twist2D Wanted(double duration);
  std::optional<MotionRequest> Request();

  NavigatorParameters parameters_;
  StateMachine machine_;
  ObstacleTracker tracker_;
  Driver driver_;
  MotionRequestSchedule schedule_;
  TrajectoryWatch watch_;
  Recovery recovery_;
  OscillationMonitor oscillation_;

  std::deque<Order> orders_;
  std::deque<MotionAnswer> answers_;
  std::optional<double> time_;
  Observation observation_;
  std::string reason_;

  // Of the present goal.
  GoalRecord record_;
  FailureRecord failure_;

  double planning_since_ = 0.0;
  std::optional<double> fault_since_;
  std::optional<double> held_up_since_;
  bool is_yielding_ = false;  ///< PLANNING, and something comes at the robot.
  StopBurst stop_;
  Trajectory answer_;
};

void Navigator::Impl::TakeOrders() {
  while (!orders_.empty()) {
    const Order order = std::move(orders_.front());
    orders_.pop_front();
    if (order.event != Event::kGoal) {
      Raise(order.event);
      continue;
    }
    if (HasGoal(machine_.state())) {
      EndGoal(Outcome::kCancelled, "replaced by a new goal");
    }
    record_.Begin(order.goal);
    failure_.Clear();
    recovery_.ResetAttempts();
    oscillation_.Reset();
    Raise(Event::kGoal);
  }
}

void Navigator::Impl::TakeAnswers() {
  while (!answers_.empty()) {
    MotionAnswer answer = std::move(answers_.front());
    answers_.pop_front();
    if (!schedule_.Accept(answer.id)) continue;
    if (answer.outcome == Outcome::kSuccess) {
      answer_ = std::move(answer.trajectory);
      failure_.Recovered();
      Raise(Event::kTrajectory);
      continue;
    }
    failure_.NotePlanning(*time_, answer.outcome, answer.message);
    Raise(Event::kPlanFailed, answer.message);
  }
  if (schedule_.HasTimedOut(*time_)) {
    failure_.NotePlanning(*time_, Outcome::kTimeout,
                          "the planner did not answer in time");
    Raise(Event::kPlanFailed, failure_.message());
  }
}

void Navigator::Impl::WatchFault() {
  if (!observation_.fault) {
    fault_since_.reset();
    return;
  }
  if (!fault_since_) fault_since_ = *time_;
  if (!HasGoal(machine_.state())) return;
  // A robot that is being held makes no progress, and that is nobody's fault.
  watch_.ResetProgress();
  if (*time_ - *fault_since_ > parameters_.watchdog.fault_patience) {
    failure_.Note(observation_.fault->outcome, observation_.fault->message);
    Raise(Event::kFault, failure_.message());
  }
}

void Navigator::Impl::Watch() {
  switch (machine_.state()) {
    case State::kTracking:
    case State::kAvoiding:
    case State::kReplanning:
      recovery_.Record(observation_.pose);
      WatchTrajectory();
      break;
    case State::kRecovering:
      WatchRecovery();
      break;
    default:
      watch_.ResetProgress();
  }
}

void Navigator::Impl::WatchTrajectory() {
  const std::optional<Notice> notice =
      watch_.Update(machine_.state(), observation_, driver_.follower());
  if (!notice) return;
  // The old goal's trajectory may end before the new goal's has come.
  if (record_.IsFollowingOld() && notice->event == Event::kArrived) return;
  if (notice->event == Event::kStuck) {
    failure_.Note(Outcome::kStuck, "the robot made no progress");
  }
  if (notice->event == Event::kObstacle) driver_.ResetAvoidance();
  Raise(notice->event, notice->detail);
}

void Navigator::Impl::WatchRecovery() {
  const bool held_up = held_up_since_ && *time_ - *held_up_since_ > kHeldUp;
  if (held_up || !recovery_.Update(observation_)) Raise(Event::kRecovered);
}

void Navigator::Impl::WatchOscillation(double duration) {
  if (!HasGoal(machine_.state()) || machine_.state() == State::kPaused) {
    oscillation_.Reset();
    return;
  }
  if (observation_.fault) return;
  const bool is_on_its_way =
      IsDriving(machine_.state()) && machine_.state() != State::kRecovering;
  // To dodge what moves is no oscillation.
  const bool is_moving = is_on_its_way && !watch_.avoiding_movers() &&
                         !IsStanding(observation_.twist, parameters_.goal);
  oscillation_.Move(observation_.pose.position(), is_moving, duration);
  if (!oscillation_.IsOscillating() || !is_on_its_way) return;
  oscillation_.Reset();
  failure_.Note(Outcome::kOscillation,
                "the robot moved to and fro without leaving its place");
  Raise(Event::kOscillation);
}

void Navigator::Impl::WatchYielding() {
  is_yielding_ = machine_.state() == State::kPlanning && !observation_.fault &&
                 driver_.IsMoverComing(observation_);
}

GuardValues Navigator::Impl::Guards() const {
  GuardValues guards;
  guards.moving =
      !observation_.fault && !IsStanding(observation_.twist, parameters_.goal);
  guards.may_retry = failure_.MayPass(*time_, parameters_.goal.patience);
  guards.may_recover = !observation_.fault && failure_.MovingMayHelp() &&
                       recovery_.HasAttemptLeft(observation_.pose);
  return guards;
}

void Navigator::Impl::Raise(Event event, const std::string& detail) {
  const std::optional<Action> action = machine_.Handle(event, Guards());
  if (!action) return;
  reason_ = ToString(event) + (detail.empty() ? "" : ": " + detail);
  if (event == Event::kPlanFailed) reason_ = detail;
  Perform(*action);
}

void Navigator::Impl::Perform(Action action) {
  switch (action) {
    case Action::kNone:
      break;
    case Action::kRequestPlan:
      record_.NotePlanning();
      schedule_.Want(*time_, 0.0);
      if (machine_.state() == State::kPlanning) {
        ForgetTrajectory();
        planning_since_ = *time_;
      }
      break;
    case Action::kRetryPlan:
      schedule_.Want(*time_, kRetryDelay);
      // Waiting for what may pass is no lack of progress.
      watch_.ResetProgress();
      break;
    case Action::kFollow:
      driver_.follower().Follow(std::move(answer_), schedule_.join(),
                                *time_ - schedule_.start_time());
      watch_.Reset();
      record_.NoteFollowing();
      break;
    case Action::kStop:
      schedule_.Clear();
      ForgetTrajectory();
      break;
    case Action::kStartRecovery:
      schedule_.Clear();
      ForgetTrajectory();
      held_up_since_.reset();
      recovery_.Start(observation_);
      reason_ += "; " + recovery_.Description();
      break;
    case Action::kReportCancelled:
      EndGoal(Outcome::kCancelled, "cancelled");
      break;
    case Action::kReportSuccess:
      EndGoal(Outcome::kSuccess,
              ArrivalMessage(driver_.follower().End(), record_.goal().pose,
                             parameters_.goal));
      break;
    case Action::kReportFailure:
      EndGoal(failure_.outcome(), failure_.message());
      break;
  }
}

void Navigator::Impl::EndGoal(Outcome outcome, const std::string& message) {
  record_.End(outcome, message);
  schedule_.Clear();
  if (!HasGoal(machine_.state())) ForgetTrajectory();
}

void Navigator::Impl::ForgetTrajectory() {
  driver_.follower().Clear();
  watch_.Reset();
}

std::optional<Twist2D> Navigator::Impl::Command(double duration,
                                                bool* limited) {
  const bool standing =
      !observation_.fault && IsStanding(observation_.twist, parameters_.goal);
  if (!MayMove()) {
    driver_.Stopped();
    return stop_.Update(*time_, standing);
  }
  stop_.Cancel();
  if (observation_.fault) {
    driver_.Stopped();
    return Twist2D();
  }
  const Twist2D wanted = Wanted(duration);
  const LimitedCommand result = driver_.Limit(wanted, observation_, duration);
  *limited = result.limited;
  const bool held_up = result.limited && result.command.v == 0.0 &&
                       std::abs(result.command.w) < 0.01;
  if (!held_up) {
    held_up_since_.reset();
  } else if (!held_up_since_) {
    held_up_since_ = *time_;
  }
  return result.command;
}

Twist2D Navigator::Impl::Wanted(double duration) {
  if (machine_.state() == State::kRecovering) {
    return recovery_.Update(observation_).value_or(Twist2D());
  }
  if (is_yielding_) return driver_.Yield(observation_, duration);
  if (watch_.avoiding_movers()) return driver_.Evade(observation_, duration);
  if (watch_.avoiding()) return driver_.Avoid(observation_, duration);
  const bool hold_position = driver_.follower().ended() && watch_.at_end();
  return driver_.Track(observation_, duration, hold_position);
}

std::optional<MotionRequest> Navigator::Impl::Request() {
  if (!schedule_.IsDue(*time_) || observation_.fault) return std::nullopt;
  const bool standing = IsStanding(observation_.twist, parameters_.goal);
  // Odometry that never comes to rest must not keep the robot from its goal.
  const bool settled =
      standing || *time_ - planning_since_ > parameters_.goal.settle_time;
  if (machine_.state() == State::kPlanning && !settled) return std::nullopt;

  const RequestStart start = ChooseStart(
      driver_, observation_, watch_.avoiding(), *time_, parameters_);
  MotionRequest request;
  request.start = start.start;
  request.start_time = start.time;
  request.id =
      schedule_.Send(record_.goal().id, *time_, start.time, start.join);
  request.goal = record_.goal().pose;
  request.tolerance = parameters_.goal.tolerance;
  return request;
}

Navigator::Navigator(const NavigatorParameters& parameters)
    : impl_(std::make_unique<Impl>(parameters)) {}

Navigator::~Navigator() = default;

void Navigator::SetGoal(const std::string& goal_id, const Pose2D& goal) {
  impl_->Tell({Event::kGoal, {goal_id, goal}});
}

void Navigator::Cancel() { impl_->Tell({Event::kCancel, {}}); }
void Navigator::Pause() { impl_->Tell({Event::kPause, {}}); }
void Navigator::Resume() { impl_->Tell({Event::kResume, {}}); }

void Navigator::SetTrajectory(const MotionRequestId& id,
                              Trajectory trajectory) {
  MotionAnswer answer;
  answer.id = id;
  answer.trajectory = std::move(trajectory);
  impl_->Answer(std::move(answer));
}

void Navigator::PlanFailed(const MotionRequestId& id, Outcome outcome,
                           const std::string& message) {
  MotionAnswer answer;
  answer.id = id;
  answer.outcome = outcome;
  answer.message = message;
  impl_->Answer(std::move(answer));
}

NavigatorOutput Navigator::Update(const NavigatorInput& input) {
  return impl_->Update(input);
}

void Navigator::SetParameters(const NavigatorParameters& parameters) {
  impl_->SetParameters(parameters);
}

}  // namespace vfh_astar
