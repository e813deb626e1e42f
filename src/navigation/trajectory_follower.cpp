#include "vfh_astar/navigation/trajectory_follower.h"

#include <algorithm>
#include <utility>

namespace vfh_astar {

void TrajectoryFollower::Follow(Trajectory next, std::optional<double> join,
                                double late) {
  if (!active() || !join) {
    Clear();
    trajectory_ = std::move(next);
    clock_ = std::max(0.0, late);
    return;
  }
  next_ = std::move(next);
  join_ = *join;
  if (clock_ >= join_) TakeOver();
}

void TrajectoryFollower::TakeOver() {
  clock_ -= join_;
  trajectory_ = std::move(*next_);
  next_.reset();
}

void TrajectoryFollower::Advance(double duration, double rate) {
  clock_ += duration * rate;
  if (next_ && clock_ >= join_) TakeOver();
}

void TrajectoryFollower::AdvanceToNearest(const Eigen::Vector2d& position,
                                          double horizon) {
  constexpr double kStep = 0.05;
  const double end = std::min(clock_ + horizon, trajectory_.duration());
  double nearest = clock_;
  double nearest_distance =
      (trajectory_.Sample(clock_).pose.position() - position).norm();
  for (double time = clock_ + kStep; time <= end; time += kStep) {
    const double distance =
        (trajectory_.Sample(time).pose.position() - position).norm();
    if (distance < nearest_distance) {
      nearest_distance = distance;
      nearest = time;
    }
  }
  clock_ = nearest;
  if (next_ && clock_ >= join_) TakeOver();
}

void TrajectoryFollower::Clear() { *this = TrajectoryFollower(); }

}  // namespace vfh_astar
