#ifndef VFH_ASTAR_NAVIGATION_STOP_BURST_H_
#define VFH_ASTAR_NAVIGATION_STOP_BURST_H_

#include <optional>

#include "vfh_astar/geometry.h"

namespace vfh_astar {

/// The stop commands on leaving a driving state: one at least, then until the
/// robot stands, half a second at the most; and nothing after that.
class StopBurst {
 public:
  /// The robot has been driving until now.
  void Begin(double time) { since_ = time; }

  /// The robot drives again.
  void Cancel() { since_.reset(); }

  /// @param[in] standing what odometry says.
  /// @return a stop, or nothing when all has been said.
  std::optional<Twist2D> Update(double time, bool standing) {
    constexpr double kLongest = 0.5;  // s
    if (!since_) return std::nullopt;
    const double elapsed = time - *since_;
    if ((standing && elapsed > 0.0) || elapsed > kLongest) {
      since_.reset();
      return std::nullopt;
    }
    return Twist2D();
  }

 private:
  std::optional<double> since_;
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_NAVIGATION_STOP_BURST_H_
