#include "vfh_astar/simulation/robot_sensors.h"

#include "vfh_astar/simulation/normal_noise.h"

namespace vfh_astar {
namespace {

double Gaussian(double sigma, std::mt19937* random) {
  return sigma == 0.0 ? 0.0 : sigma * DrawNormal(random);
}

}  // namespace

Twist2D RobotSensors::ReadWheels(double duration, const Jackal& robot,
                                 std::mt19937* random) {
  const std::array<double, 4>& angles = robot.wheel_angles();
  std::array<double, 4> speeds;
  for (std::size_t i = 0; i < 4; ++i) {
    const double side = i < 2 ? 1.0 : -1.0;
    const double scale = 1.0 + noise_.wheel_scale_error +
                         0.5 * side * noise_.wheel_difference +
                         Gaussian(noise_.encoder_sigma, random);
    speeds[i] =
        scale * (angles[i] - last_angles_[i]) * model_.wheel_radius / duration;
  }
  last_angles_ = angles;
  const double left = 0.5 * (speeds[0] + speeds[1]);
  const double right = 0.5 * (speeds[2] + speeds[3]);
  return {0.5 * (left + right), 0.5 * (right - left) / model_.HalfSeparation()};
}

void RobotSensors::ReadImu(double duration, const Jackal& robot,
                           std::mt19937* random) {
  const Eigen::Vector2d acceleration =
      (robot.velocity() - last_velocity_) / duration;
  last_velocity_ = robot.velocity();
  const Eigen::Vector2d in_robot =
      Pose2D(0.0, 0.0, -robot.pose().theta) * acceleration;
  imu_.yaw_rate = (1.0 + noise_.gyro_scale_error) * robot.twist().w +
                  noise_.gyro_bias + Gaussian(noise_.gyro_sigma, random);
  imu_.yaw = NormalizeAngle(imu_.yaw + imu_.yaw_rate * duration);
  imu_.forward_acceleration = in_robot.x() + noise_.acceleration_bias +
                              Gaussian(noise_.acceleration_sigma, random);
  imu_.left_acceleration = in_robot.y() + noise_.acceleration_bias +
                           Gaussian(noise_.acceleration_sigma, random);
}

void RobotSensors::Read(double stamp, double duration, const Jackal& robot,
                        std::mt19937* random) {
  wheels_.stamp = filtered_.stamp = imu_.stamp = stamp;
  wheels_.twist = ReadWheels(duration, robot, random);
  wheels_.pose = Integrate(wheels_.pose, wheels_.twist, duration);
  ReadImu(duration, robot, random);

  filter_.Predict(duration);
  filter_.CorrectWithWheels(wheels_.twist);
  filter_.CorrectWithGyro(imu_.yaw_rate);
  filtered_.pose = filter_.pose();
  filtered_.twist = filter_.twist();
  const Eigen::Matrix<double, 5, 1> variance = filter_.covariance().diagonal();
  filtered_.pose_variance = variance.head<3>();
  filtered_.twist_variance = variance.tail<2>();
}

}  // namespace vfh_astar
