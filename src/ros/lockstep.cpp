#include "vfh_astar/ros/lockstep.h"

#include <algorithm>
#include <utility>

namespace vfh_astar {

bool Lockstep::TakeScan(const ros::Time& stamp) {
  if (!is_on_) return true;
  if (stamp < scan_) Reset();
  scan_before_ = std::exchange(scan_, stamp);
  const bool has_waited = std::exchange(is_waiting_, false);
  if (has_waited || IsReady()) return true;
  is_waiting_ = true;
  return false;
}

bool Lockstep::TakeMapped(const ros::Time& stamp) {
  mapped_ = stamp;
  return EndWaiting();
}

bool Lockstep::TakeOdometry(const ros::Time& stamp) {
  if (!odometry_.isZero() && stamp > odometry_) {
    const ros::Duration period = stamp - odometry_;
    // Where one was lost on the way the gap is too wide.
    odometry_period_ =
        odometry_period_.isZero() ? period : std::min(odometry_period_, period);
  }
  odometry_ = stamp;
  return EndWaiting();
}

bool Lockstep::IsReady() const {
  const bool covers_scan = odometry_ >= scan_;
  // Stamps are rounded.
  const ros::Time next = odometry_ + odometry_period_ * (1.0 - 1e-3);
  const bool has_newest =
      covers_scan || odometry_period_.isZero() || next > scan_;
  return has_newest && mapped_ >= (covers_scan ? scan_ : scan_before_);
}

bool Lockstep::EndWaiting() {
  if (!is_waiting_ || !IsReady()) return false;
  is_waiting_ = false;
  return true;
}

std::optional<NavigationState> Lockstep::TakeState(
    const NavigationState& state, std::optional<MotionRequestId> question) {
  question_ = is_on_ ? question : std::nullopt;
  if (!question_) return state;
  held_ = state;
  return std::nullopt;
}

std::optional<NavigationState> Lockstep::TakeAnswer(
    const MotionRequestId& question) {
  if (question_ != question) return std::nullopt;
  question_.reset();
  return std::move(held_);
}

void Lockstep::Reset() {
  // Odometry of the new time may be here already; its rate stays.
  scan_ = scan_before_ = mapped_ = ros::Time();
  is_waiting_ = false;
  question_.reset();
}

}  // namespace vfh_astar
