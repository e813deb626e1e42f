#ifndef VFH_ASTAR_NAVIGATION_PROGRESS_MONITOR_H_
#define VFH_ASTAR_NAVIGATION_PROGRESS_MONITOR_H_

#include <optional>

#include "vfh_astar/geometry.h"
#include "vfh_astar/navigation/navigator_parameters.h"

namespace vfh_astar {

/// Notices that the robot, though it should be driving, neither moves nor
/// turns.
class ProgressMonitor {
 public:
  /// @param[in] parameters kept by reference: changes count at once.
  explicit ProgressMonitor(const RecoveryParameters& parameters)
      : parameters_(parameters) {}

  /// Starts to count anew at the next call of IsStuck.
  void Reset() { anchor_.reset(); }

  /// @param[in] time s.
  bool IsStuck(double time, const Pose2D& pose);

 private:
  const RecoveryParameters& parameters_;
  std::optional<Pose2D> anchor_;
  double anchor_time_ = 0.0;
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_NAVIGATION_PROGRESS_MONITOR_H_
