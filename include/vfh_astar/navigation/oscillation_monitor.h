#ifndef VFH_ASTAR_NAVIGATION_OSCILLATION_MONITOR_H_
#define VFH_ASTAR_NAVIGATION_OSCILLATION_MONITOR_H_

#include <optional>

#include "vfh_astar/geometry.h"
#include "vfh_astar/navigation/navigator_parameters.h"

namespace vfh_astar {

/// Notices that the robot moves and moves, to and fro or around, and stays
/// where it is. ProgressMonitor takes that for progress. Time in which the
/// robot stands does not count: who waits does not oscillate.
class OscillationMonitor {
 public:
  /// @param[in] parameters kept by reference: changes count at once.
  explicit OscillationMonitor(const OscillationParameters& parameters)
      : parameters_(parameters) {}

  /// Starts to count anew, from the place of the next Move.
  void Reset() {
    anchor_.reset();
    moved_time_ = 0.0;
  }

  /// Where the robot is after a cycle of `duration` (s) in which it stood or
  /// moved.
  void Move(const Eigen::Vector2d& place, bool is_moving, double duration);

  /// True once the robot has been moving near one place for too long.
  bool IsOscillating() const {
    return parameters_.time > 0.0 && moved_time_ > parameters_.time;
  }

 private:
  const OscillationParameters& parameters_;
  std::optional<Eigen::Vector2d> anchor_;
  double moved_time_ = 0.0;  ///< s near the anchor.
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_NAVIGATION_OSCILLATION_MONITOR_H_
