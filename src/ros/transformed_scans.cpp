#include "vfh_astar/ros/transformed_scans.h"

#include <ros/console.h>

#include <cmath>
#include <utility>

#include "vfh_astar/ros/geometry_messages.h"
#include "vfh_astar/ros/message_error.h"
#include "vfh_astar/ros/scan_messages.h"

namespace vfh_astar {
namespace {

constexpr int kQueueSize = 100;
constexpr double kLongestWait = 2.0;  // s

}  // namespace

TransformedScans::TransformedScans(ros::NodeHandle node,
                                   const tf2_ros::Buffer& transforms,
                                   std::string frame, Use use)
    : transforms_(transforms), frame_(std::move(frame)), use_(std::move(use)) {
  subscriber_ = node.subscribe<sensor_msgs::LaserScan>(
      "front/scan", kQueueSize,
      [this](const sensor_msgs::LaserScanConstPtr& scan) { Take(scan); },
      nullptr, ros::TransportHints().tcpNoDelay());
}

void TransformedScans::Take(const sensor_msgs::LaserScanConstPtr& newest) {
  waiting_.push_back(newest);
  std::deque<sensor_msgs::LaserScanConstPtr> still_waiting;
  for (const sensor_msgs::LaserScanConstPtr& scan : waiting_) {
    const double wait = (newest->header.stamp - scan->header.stamp).toSec();
    if (transforms_.canTransform(frame_, WithoutSlash(scan->header.frame_id),
                                 scan->header.stamp)) {
      TryToUse(*scan);
    } else if (std::abs(wait) < kLongestWait) {
      still_waiting.push_back(scan);
    } else {
      DropLate(*scan);
    }
  }
  waiting_ = std::move(still_waiting);
}

void TransformedScans::TryToUse(const sensor_msgs::LaserScan& message) {
  try {
    const LaserMount mount = ToLaserMount(
        transforms_
            .lookupTransform(frame_, WithoutSlash(message.header.frame_id),
                             message.header.stamp)
            .transform);
    const LaserScan scan = ToLaserScan(message, mount.upside_down);
    if (const auto defect = DescribeDefect(scan)) throw MessageError(*defect);
    use_(scan, mount.pose, message.header.stamp);
  } catch (const MessageError& error) {
    ++unusable_;
    ROS_WARN_THROTTLE(10.0, "a scan is dropped: %s", error.what());
  } catch (const tf2::TransformException&) {
    DropLate(message);
  }
}

void TransformedScans::DropLate(const sensor_msgs::LaserScan& message) {
  ++late_;
  ROS_WARN_THROTTLE(10.0,
                    "scans are dropped: no transform from %s to %s at their "
                    "time",
                    message.header.frame_id.c_str(), frame_.c_str());
}

}  // namespace vfh_astar
