#include "vfh_astar/navigation/progress_monitor.h"

#include <cmath>

namespace vfh_astar {

bool ProgressMonitor::IsStuck(double time, const Pose2D& pose) {
  const bool progressed =
      !anchor_ ||
      (pose.position() - anchor_->position()).norm() >
          parameters_.stuck_distance ||
      std::abs(NormalizeAngle(pose.theta - anchor_->theta)) >
          parameters_.stuck_angle;
  if (progressed) {
    anchor_ = pose;
    anchor_time_ = time;
  }
  return time - anchor_time_ > parameters_.stuck_time;
}

}  // namespace vfh_astar
