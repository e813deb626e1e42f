#include "vfh_astar/navigation/trajectory_follower.h"

#include <algorithm>
#include <cmath>
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
  clock_ = std::max(0.0, clock_ - join_);
  trajectory_ = std::move(*next_);
  next_.reset();
}

void TrajectoryFollower::Advance(double duration, double rate) {
  clock_ += duration * rate;
  if (next_ && (clock_ >= join_ || ended())) TakeOver();
}

void TrajectoryFollower::AdvanceToNearest(const Eigen::Vector2d& position,
                                          double horizon) {
  constexpr double kStep = 0.05;
  const double end = std::min(clock_ + horizon, trajectory_.duration());
  if (end > clock_) {
    const auto distance_at = [&](double time) {
      return (trajectory_.Sample(time).pose.position() - position).norm();
    };
    double nearest_distance = distance_at(clock_);
    const int steps = static_cast<int>(std::ceil((end - clock_) / kStep));
    const double start = clock_;
    for (int step = 1; step <= steps; ++step) {
      // The last step is the end itself, so that a trajectory can be completed.
      const double time = std::min(start + step * kStep, end);
      const double distance = distance_at(time);
      if (distance >= nearest_distance) continue;
      nearest_distance = distance;
      clock_ = time;
    }
  }
  if (next_ && (clock_ >= join_ || ended())) TakeOver();
}

void TrajectoryFollower::Clear() { *this = TrajectoryFollower(); }

}  // namespace vfh_astar
