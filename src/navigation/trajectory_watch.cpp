#include "vfh_astar/navigation/trajectory_watch.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "vfh_astar/control/tracking_law.h"
#include "vfh_astar/navigation/collision_watch.h"

namespace vfh_astar {
namespace {

/// s that the way must be free of what moves, which may turn around.
constexpr double kMoverGone = 1.0;

std::string Metres(double distance) {
  char text[48];
  std::snprintf(text, sizeof(text), "%.2f m away", distance);
  return text;
}

std::string Seconds(double time_to_collision) {
  char text[48];
  std::snprintf(text, sizeof(text), "%.2f s ahead", time_to_collision);
  return text;
}

std::string ErrorText(const Eigen::Vector3d& error) {
  char text[80];
  std::snprintf(text, sizeof(text), "%.2f m along, %.2f m across, %.2f rad",
                error[0], error[1], error[2]);
  return text;
}

}  // namespace

TrajectoryWatch::TrajectoryWatch(const NavigatorParameters& parameters)
    : parameters_(parameters),
      arrival_(parameters.goal),
      progress_(parameters.recovery) {}

void TrajectoryWatch::Reset() {
  arrival_.Reset();
  blocked_since_.reset();
  ended_since_.reset();
  avoiding_since_.reset();
}

std::optional<Notice> TrajectoryWatch::Update(
    State state, const Observation& observation,
    const TrajectoryFollower& follower) {
  const bool at_goal =
      arrival_.Update(observation.pose, observation.twist, follower.End());
  if (at_goal && follower.ended()) return Notice{Event::kArrived, ""};
  if (progress_.IsStuck(observation.time, observation.pose) &&
      !follower.ended()) {
    progress_.Reset();
    return Notice{Event::kStuck, ""};
  }

  if (IsMoverAhead(observation, follower)) {
    has_mover_ahead_ = true;
    mover_seen_ahead_ = observation.time;
    // To wait for it is no lack of progress.
    progress_.Reset();
  } else if (observation.time - mover_seen_ahead_ > kMoverGone) {
    has_mover_ahead_ = false;
  }
  const ReplanParameters& replan = parameters_.replan;
  const double to_scan = TimeToScanCollision(
      follower.trajectory(), follower.clock(), parameters_.avoidance.leave_time,
      parameters_.footprint, replan.margin, observation);
  std::optional<Notice> notice = WatchObstacles(observation, to_scan);
  // A new trajectory is on its way: what is wrong with this one has been said.
  if (notice || state == State::kReplanning || follower.pending()) {
    return notice;
  }
  const double to_map = TimeToMapCollision(
      follower.trajectory(), follower.clock(), replan.horizon,
      parameters_.footprint, replan.margin, observation);
  notice = WatchBlockage(state == State::kAvoiding, observation.time,
                         std::min(to_scan, to_map));
  if (notice) return notice;
  if (follower.ended()) return WatchEnd(observation.time, follower);
  return WatchError(state == State::kAvoiding, observation, follower);
}

std::optional<Notice> TrajectoryWatch::WatchObstacles(
    const Observation& observation, double time_to_collision) {
  const AvoidanceParameters& avoidance = parameters_.avoidance;
  bool too_close = time_to_collision < avoidance.enter_time;
  bool clear = time_to_collision >= avoidance.leave_time;
  std::string detail = Seconds(time_to_collision);
  if (avoidance.rule == "distance") {
    const double clearance =
        FootprintClearance(parameters_.footprint, observation.obstacles);
    too_close = clearance < avoidance.enter_distance;
    clear = clearance > avoidance.leave_distance;
    detail = Metres(clearance);
  }
  if (has_mover_ahead_) {
    detail = "something that moves";
    too_close = true;
    clear = false;
  }
  if (!avoiding_since_ && too_close) {
    avoiding_since_ = observation.time;
    return Notice{Event::kObstacle, detail};
  }
  if (avoiding_since_ && clear &&
      observation.time - *avoiding_since_ >= avoidance.min_time) {
    avoiding_since_.reset();
    return Notice{Event::kClear, ""};
  }
  return std::nullopt;
}

bool TrajectoryWatch::IsMoverAhead(const Observation& observation,
                                   const TrajectoryFollower& follower) const {
  // A robot that has been held up may not catch up with its reference at once.
  constexpr double kRates[] = {1.0, 0.6};
  const EvasionParameters& evasion = parameters_.evasion;
  return std::any_of(std::begin(kRates), std::end(kRates), [&](double rate) {
    return TimeToMoverCollision(follower.trajectory(), follower.clock(),
                                evasion.horizon, rate, parameters_.footprint,
                                evasion.margin, evasion.growth,
                                observation) < kNever;
  });
}

std::optional<Notice> TrajectoryWatch::WatchBlockage(bool avoiding, double time,
                                                     double time_to_collision) {
  if (time_to_collision == kNever) {
    blocked_since_.reset();
    return std::nullopt;
  }
  if (!blocked_since_) blocked_since_ = time;
  const double blocked_time = avoiding ? parameters_.avoidance.blocked_time
                                       : parameters_.replan.blocked_time;
  if (time - *blocked_since_ < blocked_time) return std::nullopt;
  return Notice{Event::kBlocked, Seconds(time_to_collision)};
}

std::optional<Notice> TrajectoryWatch::WatchEnd(
    double time, const TrajectoryFollower& follower) {
  if (!ended_since_) ended_since_ = time;
  if (time - *ended_since_ <= parameters_.goal.settle_time) return std::nullopt;
  return Notice{Event::kExpired,
                Seconds(follower.clock() - follower.trajectory().duration())};
}

std::optional<Notice> TrajectoryWatch::WatchError(
    bool avoiding, const Observation& observation,
    const TrajectoryFollower& follower) const {
  const Eigen::Vector3d error =
      TrackingError(observation.pose, follower.At(0.0).pose);
  const ReplanParameters& replan = parameters_.replan;
  const bool off = error.head<2>().norm() > replan.max_error;
  // VFH turns the robot as it must; only tracking answers for the heading.
  const bool turned =
      !avoiding && std::abs(error[2]) > replan.max_heading_error;
  if (!off && !turned) return std::nullopt;
  return Notice{Event::kDeviation, ErrorText(error)};
}

}  // namespace vfh_astar
