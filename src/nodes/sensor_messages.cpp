#include "sensor_messages.h"

#include "vfh_astar/ros/geometry_messages.h"

namespace vfh_astar {
namespace {

// Of what the plane forbids: not 0, as a filter would have to invert it.
constexpr double kForbiddenVariance = 1e-6;
constexpr double kGravity = 9.80665;  // m/s^2

// Where each direction lies on the diagonal of a 6 x 6 covariance.
constexpr int kX = 0;
constexpr int kY = 7;
constexpr int kYaw = 35;

boost::array<double, 36> ForbiddenCovariance() {
  boost::array<double, 36> covariance;
  covariance.fill(0.0);
  for (int i = 0; i < 6; ++i) covariance[7 * i] = kForbiddenVariance;
  return covariance;
}

}  // namespace

sensor_msgs::LaserScan ToScanMessage(const LaserScan& scan, double period,
                                     const std::string& frame_id) {
  sensor_msgs::LaserScan message;
  message.header.stamp.fromSec(scan.stamp);
  message.header.frame_id = frame_id;
  message.angle_min = static_cast<float>(scan.angle_min);
  message.angle_max = static_cast<float>(scan.Angle(scan.ranges.size() - 1));
  message.angle_increment = static_cast<float>(scan.angle_increment);
  message.scan_time = static_cast<float>(period);
  message.range_min = static_cast<float>(scan.range_min);
  message.range_max = static_cast<float>(scan.range_max);
  message.ranges = scan.ranges;
  return message;
}

nav_msgs::Odometry ToOdometryMessage(const OdometryReading& reading,
                                     const std::string& frame_id,
                                     const std::string& child_frame_id) {
  nav_msgs::Odometry message;
  message.header.stamp.fromSec(reading.stamp);
  message.header.frame_id = frame_id;
  message.child_frame_id = child_frame_id;
  message.pose.pose = ToPoseMessage(reading.pose);
  message.pose.covariance = ForbiddenCovariance();
  message.pose.covariance[kX] = reading.pose_variance[0];
  message.pose.covariance[kY] = reading.pose_variance[1];
  message.pose.covariance[kYaw] = reading.pose_variance[2];
  message.twist.twist = ToTwistMessage(reading.twist);
  message.twist.covariance = ForbiddenCovariance();
  message.twist.covariance[kX] = reading.twist_variance[0];
  message.twist.covariance[kYaw] = reading.twist_variance[1];
  return message;
}

sensor_msgs::Imu ToImuMessage(const ImuReading& reading,
                              const NoiseModel& noise,
                              const std::string& frame_id) {
  sensor_msgs::Imu message;
  message.header.stamp.fromSec(reading.stamp);
  message.header.frame_id = frame_id;
  message.orientation = ToPoseMessage({0.0, 0.0, reading.yaw}).orientation;
  message.angular_velocity.z = reading.yaw_rate;
  message.linear_acceleration.x = reading.forward_acceleration;
  message.linear_acceleration.y = reading.left_acceleration;
  message.linear_acceleration.z = kGravity;
  for (int i = 0; i < 3; ++i) {
    message.angular_velocity_covariance[4 * i] =
        noise.gyro_sigma * noise.gyro_sigma;
    message.linear_acceleration_covariance[4 * i] =
        noise.acceleration_sigma * noise.acceleration_sigma;
  }
  return message;
}

sensor_msgs::JointState ToJointMessage(
    const std::array<double, 4>& wheel_angles, double stamp) {
  sensor_msgs::JointState message;
  message.header.stamp.fromSec(stamp);
  message.name = {"front_left_wheel", "rear_left_wheel", "front_right_wheel",
                  "rear_right_wheel"};
  message.position.assign(wheel_angles.begin(), wheel_angles.end());
  return message;
}

CollisionReport ToCollisionMessage(const std::optional<Collision>& collision,
                                   double stamp, const std::string& frame_id) {
  CollisionReport message;
  message.header.stamp.fromSec(collision ? collision->time : stamp);
  message.header.frame_id = frame_id;
  message.collided = collision.has_value();
  if (collision) {
    message.touched = collision->with;
    message.robot_speed = collision->robot_speed;
  }
  return message;
}

}  // namespace vfh_astar
