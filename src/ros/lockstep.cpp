#include "vfh_astar/ros/lockstep.h"

#include <utility>

namespace vfh_astar {

bool Lockstep::TakeScan(const ros::Time& stamp) {
  if (!is_on_) return true;
  needed_ = std::exchange(scan_, stamp);
  const bool has_waited = std::exchange(is_waiting_, false);
  if (has_waited || mapped_ >= needed_) return true;
  is_waiting_ = true;
  return false;
}

bool Lockstep::TakeMapped(const ros::Time& stamp) {
  mapped_ = stamp;
  if (!is_waiting_ || mapped_ < needed_) return false;
  is_waiting_ = false;
  return true;
}

std::optional<NavigationState> Lockstep::TakeState(
    const NavigationState& state, std::optional<int> question) {
  question_ = is_on_ ? question : std::nullopt;
  if (!question_) return state;
  held_ = state;
  return std::nullopt;
}

std::optional<NavigationState> Lockstep::TakeAnswer(int question) {
  if (question_ != question) return std::nullopt;
  question_.reset();
  return std::move(held_);
}

void Lockstep::Reset() { *this = Lockstep(is_on_); }

}  // namespace vfh_astar
