#ifndef VFH_ASTAR_ROS_TRANSFORMED_SCANS_H_
#define VFH_ASTAR_ROS_TRANSFORMED_SCANS_H_

#include <ros/node_handle.h>
#include <sensor_msgs/LaserScan.h>
#include <tf2_ros/buffer.h>

#include <deque>
#include <functional>
#include <string>

#include "vfh_astar/geometry.h"
#include "vfh_astar/laser_scan.h"

namespace vfh_astar {

/// The scans on `front/scan` with the laser's pose in a frame of tf when each
/// was taken. Transforms come a little later than the scans that need them, so
/// scans wait, until a scan comes that is 2 s younger. A tf2_ros::MessageFilter
/// would lose the one whose transform comes while it is being queued.
///
/// Scans that cannot be used are dropped with a warning and counted.
class TransformedScans {
 public:
  using Use = std::function<void(const LaserScan& scan,
                                 const Pose2D& laser_pose, const ros::Time&)>;

  /// @param[in] node whose callback queue brings the scans.
  /// @param[in] transforms has to outlive this.
  /// @param[in] use may throw tf2::TransformException; then the scan has come
  ///   too late.
  TransformedScans(ros::NodeHandle node, const tf2_ros::Buffer& transforms,
                   std::string frame, Use use);
  TransformedScans(const TransformedScans&) = delete;
  TransformedScans& operator=(const TransformedScans&) = delete;

  /// How many were dropped for want of a transform,
  int late() const { return late_; }
  /// and how many for what was in them.
  int unusable() const { return unusable_; }

 private:
  void UseWhatIsReady();
  void TryToUse(const sensor_msgs::LaserScan& message);
  void DropLate(const sensor_msgs::LaserScan& message);

  const tf2_ros::Buffer& transforms_;
  std::string frame_;
  Use use_;
  std::deque<sensor_msgs::LaserScanConstPtr> waiting_;
  int late_ = 0;
  int unusable_ = 0;
  ros::WallTimer retry_timer_;  ///< runs while scans wait.
  ros::Subscriber subscriber_;
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_ROS_TRANSFORMED_SCANS_H_
