#ifndef VFH_ASTAR_MAPPING_ODOMETRY_GUARD_H_
#define VFH_ASTAR_MAPPING_ODOMETRY_GUARD_H_

#include <optional>

#include "vfh_astar/geometry.h"

namespace vfh_astar {

/// Odometry without its jumps: motion that no robot makes is left out, as it
/// comes from a driver that was restarted and not from the wheels.
class OdometryGuard {
 public:
  /// @param[in] stamp s
  /// @param[in] odometry as it comes.
  /// @return odometry that only drifts; the first is as it came.
  const Pose2D& Add(double stamp, const Pose2D& odometry);

  /// How many jumps were left out.
  int jumps() const { return jumps_; }

 private:
  std::optional<double> stamp_;
  Pose2D last_;
  Pose2D guarded_;
  int jumps_ = 0;
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_MAPPING_ODOMETRY_GUARD_H_
