#ifndef VFH_ASTAR_TRAJECTORY_SPEED_PROFILE_H_
#define VFH_ASTAR_TRAJECTORY_SPEED_PROFILE_H_

#include <optional>
#include <vector>

namespace vfh_astar {

/// What bounds the speed along a chain of spans, which meet at nodes: n spans
/// and n + 1 nodes. Lengths are in metres along a curve, or in radians of a
/// turn on the spot; then speeds are in rad/s.
struct ProfileProblem {
  std::vector<double> lengths;          ///< m, of each span, more than 0.
  std::vector<double> max_speeds;       ///< m/s, in each span, more than 0.
  std::vector<double> curvatures;       ///< 1/m, at each node.
  std::vector<double> curvature_rates;  ///< 1/m^2, at each node.
  std::vector<double> max_angular_accelerations;  ///< rad/s^2, at each node.
  double max_acceleration = 0.0;                  ///< m/s^2
  double max_deceleration = 0.0;                  ///< m/s^2
  double start_speed = 0.0;                       ///< m/s
  std::optional<double> start_acceleration;  ///< m/s^2, kept as far as limits
                                             ///< allow; at rest not looked at.
};

struct SpeedProfile {
  std::vector<double> speeds;         ///< m/s, at each node; 0 at the last.
  std::vector<double> accelerations;  ///< m/s^2, at each node.
  std::vector<double> durations;      ///< s, of each span.
  bool keeps_limits =
      true;  ///< false when the start is too fast for them; then
             ///< it brakes as hard as it may until they hold.
};

/// The fastest motion along the chain that ends at rest.
///
/// The squared speed u is a quadratic B-spline over length, so that speed and
/// acceleration a = u' / 2 are continuous. Each span has one coefficient, and
/// both u and u' are convex combinations of coefficients and of their
/// differences: bounds put on those hold for the motion (where the bound on
/// speed jumps from span to span, that of the span beside). What remains is a
/// chain of linear constraints between neighbouring coefficients,
///
///   c <= max_speed^2,
///   -max_deceleration <= a <= max_acceleration,
///   |curvature_rate u + curvature a| <= max_angular_acceleration (dw/dt),
///
/// whose optimum a backward pass (the largest coefficients from which the end
/// can be reached) and a greedy forward pass find exactly (Pham and Pham 2018,
/// time-optimal path parameterisation by reachability analysis).
SpeedProfile OptimizeSpeed(const ProfileProblem& problem);

}  // namespace vfh_astar

#endif  // VFH_ASTAR_TRAJECTORY_SPEED_PROFILE_H_
