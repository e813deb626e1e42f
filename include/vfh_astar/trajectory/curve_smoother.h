#ifndef VFH_ASTAR_TRAJECTORY_CURVE_SMOOTHER_H_
#define VFH_ASTAR_TRAJECTORY_CURVE_SMOOTHER_H_

#include <Eigen/Core>
#include <vector>

#include "vfh_astar/trajectory/spline_curve.h"

namespace vfh_astar {

/// A disc that a control point of the curve is kept in.
struct Bubble {
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();  ///< m
  double radius = 0.0;                               ///< m, 0 or more.
};

/// The smoothest curve through a chain of bubbles: the control points Q_i
/// minimise
///
///   sum |third difference of Q|^2 + w sum |second difference of Q|^2,
///   |Q_i - centre_i| <= radius_i,
///
/// that is jerk, and a little curvature, of a motion at constant speed along
/// the curve. Solved by the alternating direction method of multipliers
/// (Boyd et al. 2011): a banded system, factored once, and a projection on the
/// discs take turns.
/// @param[in] start, end the first and last five control points follow from
///   them.
/// @param[in] spacing m between the centres of neighbouring bubbles.
/// @param[in] bubbles one for each knot, n + 1 of them, n >= 8; those within
///   two knots of an end are not looked at.
SplineCurve SmoothThroughBubbles(const CurveEnd& start, const CurveEnd& end,
                                 double spacing,
                                 const std::vector<Bubble>& bubbles);

}  // namespace vfh_astar

#endif  // VFH_ASTAR_TRAJECTORY_CURVE_SMOOTHER_H_
