#include "vfh_astar/ros/geometry_messages.h"

#include <cmath>

#include "vfh_astar/ros/message_error.h"

namespace vfh_astar {
namespace {

// The cosine of the tilt that is still taken for level, as move_base does.
constexpr double kLevel = 1.0 - 1e-3;

geometry_msgs::Quaternion ToQuaternion(double yaw) {
  geometry_msgs::Quaternion rotation;
  rotation.z = std::sin(0.5 * yaw);
  rotation.w = std::cos(0.5 * yaw);
  return rotation;
}

double SquaredLength(const geometry_msgs::Quaternion& q) {
  return q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w;
}

}  // namespace

double Yaw(const geometry_msgs::Quaternion& q) {
  return std::atan2(2.0 * (q.w * q.z + q.x * q.y),
                    q.w * q.w + q.x * q.x - q.y * q.y - q.z * q.z);
}

Pose2D ToPose2D(const geometry_msgs::Pose& pose) {
  return {pose.position.x, pose.position.y, Yaw(pose.orientation)};
}

Pose2D ToPose2D(const geometry_msgs::Transform& transform) {
  return {transform.translation.x, transform.translation.y,
          Yaw(transform.rotation)};
}

geometry_msgs::Point ToPointMessage(const Eigen::Vector2d& point) {
  geometry_msgs::Point message;
  message.x = point.x();
  message.y = point.y();
  return message;
}

geometry_msgs::Pose ToPoseMessage(const Pose2D& pose) {
  geometry_msgs::Pose message;
  message.position = ToPointMessage(pose.position());
  message.orientation = ToQuaternion(pose.theta);
  return message;
}

geometry_msgs::Transform ToTransformMessage(const Pose2D& pose) {
  geometry_msgs::Transform message;
  message.translation.x = pose.x;
  message.translation.y = pose.y;
  message.rotation = ToQuaternion(pose.theta);
  return message;
}

Twist2D ToTwist2D(const geometry_msgs::Twist& twist) {
  return {twist.linear.x, twist.angular.z};
}

geometry_msgs::Twist ToTwistMessage(const Twist2D& twist) {
  geometry_msgs::Twist message;
  message.linear.x = twist.v;
  message.angular.z = twist.w;
  return message;
}

std::optional<std::string> DescribeDefect(const geometry_msgs::Pose& pose) {
  const geometry_msgs::Point& p = pose.position;
  const geometry_msgs::Quaternion& q = pose.orientation;
  if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) {
    return "the position (" + std::to_string(p.x) + ", " + std::to_string(p.y) +
           ", " + std::to_string(p.z) + ") is not finite";
  }
  const double length = SquaredLength(q);
  if (!std::isfinite(length) || length < 1e-6) {
    return "the orientation quaternion (" + std::to_string(q.x) + ", " +
           std::to_string(q.y) + ", " + std::to_string(q.z) + ", " +
           std::to_string(q.w) + ") is no rotation; expected length 1";
  }
  // The z component of where the rotation takes the z axis.
  const double up = 1.0 - 2.0 * (q.x * q.x + q.y * q.y) / length;
  if (up < kLevel) {
    return "the orientation is tilted out of the plane by " +
           std::to_string(std::acos(std::fmax(up, -1.0))) +
           " rad; expected a turn about z alone";
  }
  return std::nullopt;
}

std::string WithoutSlash(const std::string& frame_id) {
  return !frame_id.empty() && frame_id[0] == '/' ? frame_id.substr(1)
                                                 : frame_id;
}

void CheckFrame(const std::string& frame_id, const std::string& expected) {
  if (WithoutSlash(frame_id) != expected) {
    throw MessageError("its frame is '" + frame_id + "'; expected '" +
                       expected + "'");
  }
}

}  // namespace vfh_astar
