#include "vfh_astar/navigation/oscillation_monitor.h"

namespace vfh_astar {

void OscillationMonitor::Move(const Eigen::Vector2d& place, bool is_moving,
                              double duration) {
  if (!anchor_ || (place - *anchor_).norm() > parameters_.distance) {
    anchor_ = place;
    moved_time_ = 0.0;
  } else if (is_moving) {
    moved_time_ += duration;
  }
}

}  // namespace vfh_astar
