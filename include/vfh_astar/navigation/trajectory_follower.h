#ifndef VFH_ASTAR_NAVIGATION_TRAJECTORY_FOLLOWER_H_
#define VFH_ASTAR_NAVIGATION_TRAJECTORY_FOLLOWER_H_

#include <optional>

#include "vfh_astar/geometry.h"
#include "vfh_astar/trajectory/trajectory.h"

namespace vfh_astar {

/// Holds the trajectory that is being followed and a clock that says where on
/// it the reference is. The clock may run slower than time, so that the
/// reference waits for a robot that was held up, and a new trajectory takes
/// over where the old one's clock reaches their common point.
class TrajectoryFollower {
 public:
  bool active() const { return !trajectory_.empty(); }
  const Trajectory& trajectory() const { return trajectory_; }

  /// s on the trajectory; beyond its duration once it has ended.
  double clock() const { return clock_; }

  /// True when a trajectory waits for the clock to reach its start.
  bool pending() const { return next_.has_value(); }

  bool ended() const { return active() && clock_ >= trajectory_.duration(); }

  /// The reference `ahead` seconds from the clock.
  Reference At(double ahead) const {
    return trajectory_.Sample(clock_ + ahead);
  }

  /// Where the trajectory ends.
  Pose2D End() const { return trajectory_.Sample(trajectory_.duration()).pose; }

  /// Goes over to `next`.
  /// @param[in] join the clock on the present trajectory at which `next`
  /// begins;
  ///   nothing when `next` does not begin on it, or nothing is followed.
  /// @param[in] late s that have passed since the start of `next`, for a start
  ///   that lies on no trajectory.
  void Follow(Trajectory next, std::optional<double> join, double late);

  /// Moves the clock on.
  /// @param[in] rate 0 (the reference waits) to 1 (it runs in time).
  void Advance(double duration, double rate);

  /// Moves the clock on to the point nearest to `position`, never back, looking
  /// no farther than `horizon` seconds.
  void AdvanceToNearest(const Eigen::Vector2d& position, double horizon);

  void Clear();

 private:
  void TakeOver();

  Trajectory trajectory_;
  double clock_ = 0.0;
  std::optional<Trajectory> next_;
  double join_ = 0.0;
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_NAVIGATION_TRAJECTORY_FOLLOWER_H_
