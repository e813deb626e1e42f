#ifndef VFH_ASTAR_SIMULATION_ODOMETRY_FILTER_H_
#define VFH_ASTAR_SIMULATION_ODOMETRY_FILTER_H_

#include <Eigen/Core>

#include "vfh_astar/geometry.h"

namespace vfh_astar {

/// The extended Kalman filter that a Jackal runs over its wheel odometry and
/// its gyro: state x, y, theta, v, w with constant velocity, corrected by the
/// wheels' v and w and by the gyro's w. The wheels' w counts little, since a
/// skid-steered robot's wheels say little about its turning.
class OdometryFilter {
 public:
  using State = Eigen::Matrix<double, 5, 1>;
  using Covariance = Eigen::Matrix<double, 5, 5>;

  OdometryFilter();

  /// Moves the estimate on by `duration` seconds.
  void Predict(double duration);

  void CorrectWithWheels(const Twist2D& twist);

  /// @param[in] yaw_rate rad/s
  void CorrectWithGyro(double yaw_rate);

  Pose2D pose() const;  ///< since the start.
  Twist2D twist() const { return {state_[3], state_[4]}; }
  const Covariance& covariance() const { return covariance_; }

 private:
  /// Corrects one element of the state by a measurement of it.
  void Correct(int element, double measured, double variance);

  State state_ = State::Zero();
  Covariance covariance_;
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_SIMULATION_ODOMETRY_FILTER_H_
