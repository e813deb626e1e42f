#include "vfh_astar/simulation/odometry_filter.h"

#include <cmath>

namespace vfh_astar {
namespace {

// Variances of the measurements, and by how much the truth wanders in a second.
// The wheels' w is off by several percent of itself when the robot skids.
constexpr double kWheelSpeedVariance = 1e-4;  // (m/s)^2
constexpr double kWheelTurnVariance = 4e-2;   // (rad/s)^2
constexpr double kGyroVariance = 1e-5;        // (rad/s)^2
constexpr double kPositionWander = 1e-5;      // m^2/s
constexpr double kHeadingWander = 1e-6;       // rad^2/s
constexpr double kSpeedWander = 10.0;         // (m/s)^2/s
constexpr double kTurnWander = 50.0;          // (rad/s)^2/s

/// Accelerations are white noise; what they do to speed within a step they also
/// do to the way, or heading and position would lag half a step behind every
/// change of speed that the sensors report.
OdometryFilter::Covariance ProcessNoise(double duration, double c, double s) {
  using Column = OdometryFilter::State;
  const auto integrated = [duration](const Column& way, const Column& speed,
                                     double intensity) {
    const double d = duration;
    const OdometryFilter::Covariance noise =
        d * d * d / 3.0 * way * way.transpose() +
        d * d / 2.0 * (way * speed.transpose() + speed * way.transpose()) +
        d * speed * speed.transpose();
    return OdometryFilter::Covariance(intensity * noise);
  };
  const Column along = (Column() << c, s, 0.0, 0.0, 0.0).finished();
  OdometryFilter::Covariance noise =
      integrated(along, Column::Unit(3), kSpeedWander) +
      integrated(Column::Unit(2), Column::Unit(4), kTurnWander);
  noise.diagonal() += duration * (Column() << kPositionWander, kPositionWander,
                                  kHeadingWander, 0.0, 0.0)
                                     .finished();
  return noise;
}

}  // namespace

OdometryFilter::OdometryFilter() : covariance_(1e-9 * Covariance::Identity()) {}

Pose2D OdometryFilter::pose() const {
  return {state_[0], state_[1], NormalizeAngle(state_[2])};
}

void OdometryFilter::Predict(double duration) {
  const double half_turn = state_[2] + 0.5 * state_[4] * duration;
  const double c = std::cos(half_turn);
  const double s = std::sin(half_turn);
  const double length = state_[3] * duration;
  Covariance jacobian = Covariance::Identity();
  jacobian(0, 2) = -length * s;
  jacobian(0, 3) = duration * c;
  jacobian(0, 4) = -0.5 * duration * length * s;
  jacobian(1, 2) = length * c;
  jacobian(1, 3) = duration * s;
  jacobian(1, 4) = 0.5 * duration * length * c;
  jacobian(2, 4) = duration;
  state_[0] += length * c;
  state_[1] += length * s;
  state_[2] += state_[4] * duration;
  covariance_ = jacobian * covariance_ * jacobian.transpose() +
                ProcessNoise(duration, c, s);
}

void OdometryFilter::Correct(int element, double measured, double variance) {
  const State gain =
      covariance_.col(element) / (covariance_(element, element) + variance);
  state_ += gain * (measured - state_[element]);
  covariance_ -= gain * covariance_.row(element).eval();
}

void OdometryFilter::CorrectWithWheels(const Twist2D& twist) {
  Correct(3, twist.v, kWheelSpeedVariance);
  Correct(4, twist.w, kWheelTurnVariance);
}

void OdometryFilter::CorrectWithGyro(double yaw_rate) {
  Correct(4, yaw_rate, kGyroVariance);
}

}  // namespace vfh_astar
