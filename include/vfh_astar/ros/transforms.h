#ifndef VFH_ASTAR_ROS_TRANSFORMS_H_
#define VFH_ASTAR_ROS_TRANSFORMS_H_

#include <geometry_msgs/PoseStamped.h>
#include <tf2_ros/buffer.h>

#include <memory>
#include <string>

#include "vfh_astar/geometry.h"

namespace vfh_astar {

/// What tf says, listened to once for all nodelets of a process: each transform
/// would else wake as many threads. Listening begins with the first call and
/// ends when nobody holds the result any more.
std::shared_ptr<const tf2_ros::Buffer> SharedTransforms();

/// A pose of any frame in the given one, by the newest transform.
/// @throws MessageError when the pose is unfit (see DescribeDefect) or there is
///   no such transform; the text names both frames.
Pose2D PoseInFrame(const geometry_msgs::PoseStamped& pose,
                   const std::string& frame, const tf2_ros::Buffer& transforms);

}  // namespace vfh_astar

#endif  // VFH_ASTAR_ROS_TRANSFORMS_H_
