#ifndef VFH_ASTAR_ROS_GEOMETRY_MESSAGES_H_
#define VFH_ASTAR_ROS_GEOMETRY_MESSAGES_H_

#include <geometry_msgs/Point.h>
#include <geometry_msgs/Pose.h>
#include <geometry_msgs/Quaternion.h>
#include <geometry_msgs/Transform.h>
#include <geometry_msgs/Twist.h>

#include <optional>
#include <string>

#include "vfh_astar/geometry.h"

namespace vfh_astar {

/// The turn about z of a rotation, rad in (-pi, pi]; its length does not
/// matter, as long as it is not 0.
double Yaw(const geometry_msgs::Quaternion& rotation);

/// What a pose or a transform is in the plane.
Pose2D ToPose2D(const geometry_msgs::Pose& pose);
Pose2D ToPose2D(const geometry_msgs::Transform& transform);

geometry_msgs::Point ToPointMessage(const Eigen::Vector2d& point);
geometry_msgs::Pose ToPoseMessage(const Pose2D& pose);
geometry_msgs::Transform ToTransformMessage(const Pose2D& pose);

/// The forward speed and the turn about z; the rest is not the robot's to do.
Twist2D ToTwist2D(const geometry_msgs::Twist& twist);
geometry_msgs::Twist ToTwistMessage(const Twist2D& twist);

/// Says what makes a pose unfit to be driven to (a number that is not finite, a
/// quaternion of length 0, a tilt out of the plane), or nothing.
std::optional<std::string> DescribeDefect(const geometry_msgs::Pose& pose);

/// A frame id as tf2 wants it; old publishers put a slash in front.
std::string WithoutSlash(const std::string& frame_id);

/// @param[in] frame_id of a message, with or without a slash in front.
/// @throws MessageError when it is another than `expected`.
void CheckFrame(const std::string& frame_id, const std::string& expected);

}  // namespace vfh_astar

#endif  // VFH_ASTAR_ROS_GEOMETRY_MESSAGES_H_
