#ifndef VFH_ASTAR_TRAJECTORY_QUINTIC_H_
#define VFH_ASTAR_TRAJECTORY_QUINTIC_H_

#include <Eigen/Core>

namespace vfh_astar {

/// Coefficients c0..c5 of a polynomial in tau = t / duration, 0 <= tau <= 1.
using Quintic = Eigen::Matrix<double, 6, 1>;

/// A value and its first three derivatives.
struct Jet {
  double value = 0.0;
  double first = 0.0;
  double second = 0.0;
  double third = 0.0;
};

/// @param[in] duration s, more than 0.
/// @return the polynomial at `tau`, its derivatives taken in time (1/s^k).
Jet Evaluate(const Quintic& quintic, double duration, double tau);

/// The quintic that meets value, first and second derivative in time at both
/// ends; the third derivatives are not looked at.
/// @param[in] duration s, more than 0.
Quintic HermiteQuintic(const Jet& start, const Jet& end, double duration);

}  // namespace vfh_astar

#endif  // VFH_ASTAR_TRAJECTORY_QUINTIC_H_
