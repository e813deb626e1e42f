#ifndef VFH_ASTAR_CONTROL_TRACKING_LAW_H_
#define VFH_ASTAR_CONTROL_TRACKING_LAW_H_

#include <Eigen/Core>

#include "vfh_astar/geometry.h"
#include "vfh_astar/parameters.h"
#include "vfh_astar/trajectory/trajectory.h"

namespace vfh_astar {

struct TrackingParameters {
  /// `adaptive`: k1 = k3 = 2 damping sqrt(w_d^2 + bandwidth v_d^2) and
  /// k2 = bandwidth, so that the response to an error looks the same at every
  /// speed; k1 and k3 below are their least values. `constant`: k1, k2, k3 as
  /// they are, as in the paper.
  std::string gains = "adaptive";
  double damping = 0.8;
  double bandwidth = 6.0;  ///< 1/m^2
  double k1 = 1.0;         ///< 1/s
  double k2 = 6.0;         ///< 1/m^2
  double k3 = 1.5;         ///< 1/s

  void Read(ParameterReader& reader);
};

/// The error of a pose against its reference, in the robot's frame:
/// e = R(theta)^T (reference - pose), e3 in (-pi, pi].
/// @return e1 (m, ahead), e2 (m, to the left), e3 (rad).
Eigen::Vector3d TrackingError(const Pose2D& pose, const Pose2D& reference);

/// The nonlinear tracking law of Besseghieur et al. (2018), which Ma et al.
/// use:
///   v = v_d cos(e3) - u1,  u1 = -k1 e1
///   w = w_d - u2,          u2 = -k2 v_d (sin(e3) / e3) e2 - k3 e3
/// Ma et al. print u2 without e2; that would turn the robot on its reference
/// and never correct a lateral error. With e = 0 the command is (v_d, w_d).
Twist2D TrackingCommand(const Eigen::Vector3d& error, const Twist2D& reference,
                        const TrackingParameters& parameters);

}  // namespace vfh_astar

#endif  // VFH_ASTAR_CONTROL_TRACKING_LAW_H_
