#include "vfh_astar/ros/transforms.h"

#include <tf2_geometry_msgs/tf2_geometry_msgs.h>
#include <tf2_ros/transform_listener.h>

#include <mutex>

#include "vfh_astar/ros/geometry_messages.h"
#include "vfh_astar/ros/message_error.h"

namespace vfh_astar {
namespace {

struct HeardTransforms {
  tf2_ros::Buffer buffer;
  tf2_ros::TransformListener listener{buffer};
};

}  // namespace

std::shared_ptr<const tf2_ros::Buffer> SharedTransforms() {
  static std::mutex mutex;
  static std::weak_ptr<HeardTransforms> shared;
  const std::lock_guard<std::mutex> lock(mutex);
  std::shared_ptr<HeardTransforms> heard = shared.lock();
  if (!heard) {
    heard = std::make_shared<HeardTransforms>();
    shared = heard;
  }
  return {heard, &heard->buffer};
}

Pose2D PoseInFrame(const geometry_msgs::PoseStamped& pose,
                   const std::string& frame,
                   const tf2_ros::Buffer& transforms) {
  if (const auto defect = DescribeDefect(pose.pose)) {
    throw MessageError(*defect);
  }
  const std::string from = WithoutSlash(pose.header.frame_id);
  if (from == frame) return ToPose2D(pose.pose);
  if (from.empty()) {
    throw MessageError("the pose has no frame_id; expected " + frame +
                       " or a frame with a transform to it");
  }
  try {
    geometry_msgs::PoseStamped result;
    tf2::doTransform(pose, result,
                     transforms.lookupTransform(frame, from, ros::Time(0)));
    return ToPose2D(result.pose);
  } catch (const tf2::TransformException& error) {
    throw MessageError("there is no transform from " + from + " to " + frame +
                       ": " + error.what());
  }
}

}  // namespace vfh_astar
