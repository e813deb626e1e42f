#include "vfh_astar/mapping/odometry_guard.h"

#include <cmath>

namespace vfh_astar {
namespace {

// More than a mobile robot does, and what stamps may be off.
constexpr double kFastest = 5.0;        // m/s
constexpr double kFastestTurn = 12.0;   // rad/s
constexpr double kDistanceSlack = 0.3;  // m
constexpr double kAngleSlack = 0.3;     // rad

}  // namespace

const Pose2D& OdometryGuard::Add(double stamp, const Pose2D& odometry) {
  if (!stamp_) {
    guarded_ = odometry;
  } else {
    const double duration = std::abs(stamp - *stamp_);
    const Pose2D motion = last_.Inverse() * odometry;
    const bool is_jump =
        motion.position().norm() > kFastest * duration + kDistanceSlack ||
        std::abs(motion.theta) > kFastestTurn * duration + kAngleSlack;
    if (is_jump) {
      ++jumps_;
    } else {
      guarded_ = guarded_ * motion;
    }
  }
  stamp_ = stamp;
  last_ = odometry;
  return guarded_;
}

}  // namespace vfh_astar
