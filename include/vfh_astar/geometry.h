#ifndef VFH_ASTAR_GEOMETRY_H_
#define VFH_ASTAR_GEOMETRY_H_

#include <Eigen/Core>
#include <cmath>

namespace vfh_astar {

inline constexpr double kPi = 3.14159265358979323846;

/// Wraps an angle to (-pi, pi].
/// @param[in] angle rad, finite.
inline double NormalizeAngle(double angle) {
  // Nearly all are, and std::remainder is slow.
  if (-kPi < angle && angle <= kPi) return angle;
  const double wrapped = std::remainder(angle, 2.0 * kPi);
  return wrapped <= -kPi ? wrapped + 2.0 * kPi : wrapped;
}

/// A pose in the plane: metres and radians, counter-clockwise from x (REP-103).
struct Pose2D {
  double x = 0.0;
  double y = 0.0;
  double theta = 0.0;

  Pose2D() = default;
  Pose2D(double x_in, double y_in, double theta_in)
      : x(x_in), y(y_in), theta(theta_in) {}
  Pose2D(const Eigen::Vector2d& position, double theta_in)
      : x(position.x()), y(position.y()), theta(theta_in) {}

  Eigen::Vector2d position() const { return {x, y}; }

  /// The unit vector along the heading.
  Eigen::Vector2d heading() const { return {std::cos(theta), std::sin(theta)}; }

  /// Takes a point from this pose's frame to the frame the pose is given in.
  Eigen::Vector2d operator*(const Eigen::Vector2d& point) const {
    const double c = std::cos(theta);
    const double s = std::sin(theta);
    return {x + c * point.x() - s * point.y(),
            y + s * point.x() + c * point.y()};
  }

  /// Chains transforms: `a_from_b * b_from_c` is `a_from_c`.
  Pose2D operator*(const Pose2D& other) const {
    return {*this * other.position(), NormalizeAngle(theta + other.theta)};
  }

  Pose2D Inverse() const {
    const double c = std::cos(theta);
    const double s = std::sin(theta);
    return {-c * x - s * y, s * x - c * y, NormalizeAngle(-theta)};
  }

  bool IsFinite() const {
    return std::isfinite(x) && std::isfinite(y) && std::isfinite(theta);
  }
};

/// A pose that takes many points to its frame, its sine and cosine worked out
/// once.
class PointTransform {
 public:
  explicit PointTransform(const Pose2D& pose)
      : x_(pose.x),
        y_(pose.y),
        cos_(std::cos(pose.theta)),
        sin_(std::sin(pose.theta)) {}

  /// That of `pose.Inverse()`: takes points from the frame the pose is given in
  /// to the pose's own.
  static PointTransform Into(const Pose2D& pose) {
    PointTransform transform(pose);
    const double c = transform.cos_;
    const double s = transform.sin_;
    transform.x_ = -c * pose.x - s * pose.y;
    transform.y_ = s * pose.x - c * pose.y;
    transform.sin_ = -s;
    return transform;
  }

  Eigen::Vector2d operator*(const Eigen::Vector2d& point) const {
    return {x_ + cos_ * point.x() - sin_ * point.y(),
            y_ + sin_ * point.x() + cos_ * point.y()};
  }

 private:
  double x_;
  double y_;
  double cos_;
  double sin_;
};

/// Velocity of a differential-drive robot in its own frame.
struct Twist2D {
  double v = 0.0;  ///< m/s, forward.
  double w = 0.0;  ///< rad/s, counter-clockwise.

  bool IsFinite() const { return std::isfinite(v) && std::isfinite(w); }
};

/// The pose reached from `pose` when `twist` is held for `duration` seconds
/// (exact arc, no slip).
inline Pose2D Integrate(const Pose2D& pose, const Twist2D& twist,
                        double duration) {
  const double turn = twist.w * duration;
  const double length = twist.v * duration;
  // The chord of an arc points along the heading half way through the turn.
  const double half = 0.5 * turn;
  const double chord =
      std::abs(half) < 1e-6 ? length : length * std::sin(half) / half;
  return {pose.x + chord * std::cos(pose.theta + half),
          pose.y + chord * std::sin(pose.theta + half),
          NormalizeAngle(pose.theta + turn)};
}

}  // namespace vfh_astar

#endif  // VFH_ASTAR_GEOMETRY_H_
