#include "vfh_astar/navigation/motion_request.h"

#include <algorithm>

namespace vfh_astar {

void MotionRequestSchedule::Want(double time, double delay) {
  waiting_ = false;
  wanted_at_ = time + delay;
  if (sent_at_) wanted_at_ = std::max(*wanted_at_, *sent_at_ + period_);
}

void MotionRequestSchedule::Clear() {
  waiting_ = false;
  wanted_at_.reset();
}

bool MotionRequestSchedule::IsDue(double time) const {
  return wanted_at_ && time >= *wanted_at_;
}

MotionRequestId MotionRequestSchedule::Send(const std::string& goal_id,
                                            double time, double start_time,
                                            std::optional<double> join) {
  wanted_at_.reset();
  sent_at_ = time;
  waiting_ = true;
  start_time_ = start_time;
  join_ = join;
  ++id_.number;
  id_.goal_id = goal_id;
  return id_;
}

bool MotionRequestSchedule::Accept(const MotionRequestId& id) {
  if (!waiting_ || id != id_) return false;
  waiting_ = false;
  return true;
}

bool MotionRequestSchedule::HasTimedOut(double time) {
  if (!waiting_ || time - *sent_at_ <= timeout_) return false;
  waiting_ = false;
  return true;
}

}  // namespace vfh_astar
