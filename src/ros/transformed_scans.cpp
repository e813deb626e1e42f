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
constexpr double kLongestWait = 2.0;    // s
constexpr double kRetryPeriod = 0.005;  // s of the wall's.

}  // namespace

TransformedScans::TransformedScans(ros::NodeHandle node,
                                   const tf2_ros::Buffer& transforms,
                                   std::string frame, Use use)
    : transforms_(transforms), frame_(std::move(frame)), use_(std::move(use)) {
  retry_timer_ = node.createWallTimer(
      ros::WallDuration(kRetryPeriod),
      [this](const ros::WallTimerEvent&) { UseWhatIsReady(); },
      /*oneshot=*/false, /*autostart=*/false);
  subscriber_ = node.subscribe<sensor_msgs::LaserScan>(
      "front/scan", kQueueSize,
      [this](const sensor_msgs::LaserScanConstPtr& scan) {
        waiting_.push_back(scan);
        UseWhatIsReady();
      },
      nullptr, ros::TransportHints().tcpNoDelay());
}

void TransformedScans::UseWhatIsReady() {
  std::deque<sensor_msgs::LaserScanConstPtr> still_waiting;
  for (const sensor_msgs::LaserScanConstPtr& scan : waiting_) {
    const ros::Time newest = waiting_.back()->header.stamp;
    const double wait = (newest - scan->header.stamp).toSec();
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
  if (waiting_.empty()) {
    retry_timer_.stop();
  } else {
    retry_timer_.start();
  }
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
