#ifndef VFH_ASTAR_NODES_PACE_H_
#define VFH_ASTAR_NODES_PACE_H_

#include <algorithm>
#include <optional>

namespace vfh_astar {

/// Keeps simulated time in step with the wall's. What is lost by less than
/// kMaxLag is made up for; a machine that falls farther behind just runs late,
/// as nobody wants a burst of speed once it can keep up again.
class Pace {
 public:
  static constexpr double kMaxLag = 0.1;  ///< s of the wall clock.

  /// @param[in] real_time_factor simulated s per wall s; 0: no waiting.
  explicit Pace(double real_time_factor) : factor_(real_time_factor) {}

  /// Seconds of the wall clock until simulated time may go on; 0 for now.
  /// @param[in] wall s, of a clock that never jumps.
  /// @param[in] simulated s
  double WaitTime(double wall, double simulated) {
    if (factor_ == 0.0) return 0.0;
    if (origin_) {
      const double due =
          origin_->wall + (simulated - origin_->simulated) / factor_;
      if (wall - due <= kMaxLag) return std::max(0.0, due - wall);
    }
    origin_ = Origin{wall, simulated};
    return 0.0;
  }

  /// Counts from the next call on. For when simulated time has moved, or stood
  /// still, by other means.
  void Restart() { origin_.reset(); }

 private:
  struct Origin {
    double wall;
    double simulated;
  };

  double factor_;
  std::optional<Origin> origin_;
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_NODES_PACE_H_
