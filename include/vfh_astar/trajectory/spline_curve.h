#ifndef VFH_ASTAR_TRAJECTORY_SPLINE_CURVE_H_
#define VFH_ASTAR_TRAJECTORY_SPLINE_CURVE_H_

#include <Eigen/Core>
#include <array>
#include <vector>

namespace vfh_astar {

/// A point of a curve and how the curve bends there.
struct CurvePoint {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  ///< m
  double heading = 0.0;         ///< rad, along the direction of travel.
  double curvature = 0.0;       ///< 1/m, positive to the left.
  double curvature_rate = 0.0;  ///< 1/m^2, d(curvature)/d(length).
  double length = 0.0;          ///< m from the point before; 0 for the first.
  double knot = 0.0;            ///< of the curve: its interval, and how far in.
};

/// How a curve leaves or reaches an end.
struct CurveEnd {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  ///< m
  double heading = 0.0;                                ///< rad
  double curvature = 0.0;                              ///< 1/m
};

/// A uniform quintic B-spline in the plane: four times continuously
/// differentiable, so that curvature and its rate are continuous, and held by
/// its control points: a point of the curve lies in the convex hull of the six
/// control points about it.
class SplineCurve {
 public:
  /// Control points that fix one end: with these five first (or last) the curve
  /// has its end's position, direction and curvature.
  static constexpr int kEndPoints = 5;

  /// @param[in] spacing m between control points; near this the parameter of
  ///   the curve runs with its length.
  /// @return Q_-2..Q_2 about the end, in the direction of travel.
  static std::array<Eigen::Vector2d, kEndPoints> EndPoints(const CurveEnd& end,
                                                           double spacing);

  /// @param[in] control_points Q_-2..Q_n+2 of a curve of n >= 1 intervals.
  explicit SplineCurve(std::vector<Eigen::Vector2d> control_points);

  int intervals() const { return static_cast<int>(points_.size()) - 5; }

  /// Points from end to end, two to an interval, and four or eight where the
  /// curvature changes fast; with the length between them by Gauss-Legendre
  /// quadrature.
  std::vector<CurvePoint> Sample() const;

 private:
  std::vector<Eigen::Vector2d> points_;
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_TRAJECTORY_SPLINE_CURVE_H_
