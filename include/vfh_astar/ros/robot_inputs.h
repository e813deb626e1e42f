#ifndef VFH_ASTAR_ROS_ROBOT_INPUTS_H_
#define VFH_ASTAR_ROS_ROBOT_INPUTS_H_

#include <nav_msgs/Odometry.h>
#include <ros/node_handle.h>
#include <sensor_msgs/LaserScan.h>
#include <tf2_ros/buffer.h>
#include <vfh_astar/LocalizationState.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "vfh_astar/geometry.h"
#include "vfh_astar/grid/clearance.h"
#include "vfh_astar/laser_scan.h"
#include "vfh_astar/navigation/observation.h"
#include "vfh_astar/ros/frame_names.h"
#include "vfh_astar/ros/map_subscription.h"

namespace vfh_astar {

/// What the navigator drives by: the newest of `front/scan`,
/// `odometry/filtered`, `map`, `localization` and tf. The mapper says on
/// `localization` where odometry lies in the map before tf has brought it;
/// where another node localises, tf alone says so. Messages that cannot be used
/// are dropped with a warning and counted.
class RobotInputs {
 public:
  using OnInput = std::function<void()>;
  using OnMapped = std::function<void(const ros::Time& stamp)>;

  /// @param[in] node whose callback queue brings the messages.
  /// @param[in] occupied_threshold percent, of the map.
  RobotInputs(ros::NodeHandle node, const FrameNames& frames,
              int occupied_threshold);
  RobotInputs(const RobotInputs&) = delete;
  RobotInputs& operator=(const RobotInputs&) = delete;

  /// Begins to take scans and odometry.
  /// @param[in] on_scan called after every scan that can be used,
  /// @param[in] on_odometry and after all such odometry.
  /// @param[in] on_mapped called when the mapper has a scan.
  void Listen(ros::NodeHandle node, OnInput on_scan, OnInput on_odometry,
              OnMapped on_mapped);

  /// What is known at a time; what it points to lives until the next message.
  NavigatorInput At(const ros::Time& time) const;

  const tf2_ros::Buffer& transforms() const { return *transforms_; }

  /// 0 before the first.
  const ros::Time& scan_stamp() const { return scan_stamp_; }
  /// s; nothing before the first.
  const std::optional<double>& odometry_stamp() const {
    return odometry_stamp_;
  }
  int unusable_scans() const { return unusable_scans_; }

  /// s since the newest transform from map to odom, nothing without one; it is
  /// negative while that one is valid beyond `time`.
  std::optional<double> TransformAge(const ros::Time& time) const;

  /// What has not come yet, a line for each.
  std::vector<std::string> Missing() const;

  /// Forgets scan and odometry that are younger than `time`: time went back,
  /// and they are of the future.
  void ForgetAfter(const ros::Time& time);

 private:
  void Take(const sensor_msgs::LaserScan& message);
  void Take(const nav_msgs::Odometry& message);
  void Take(const LocalizationState& message);
  std::optional<geometry_msgs::TransformStamped> MapFromOdom() const;

  FrameNames frames_;
  OnInput on_scan_;
  OnInput on_odometry_;
  OnMapped on_mapped_;
  std::shared_ptr<const tf2_ros::Buffer> transforms_;

  std::optional<LaserScan> scan_;
  ros::Time scan_stamp_;
  Pose2D base_from_laser_;
  int unusable_scans_ = 0;
  std::string scan_defect_;  ///< of the newest scan; empty when it is usable.

  std::optional<double> odometry_stamp_;
  Pose2D odom_from_base_;
  Twist2D twist_;

  ros::Time localization_stamp_;  ///< 0 before the first.
  Pose2D map_from_odom_;
  bool is_lost_ = false;

  ClearanceMap map_;
  bool has_map_ = false;

  MapSubscription map_subscription_;
  ros::Subscriber scan_subscriber_;
  ros::Subscriber odometry_subscriber_;
  ros::Subscriber localization_subscriber_;
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_ROS_ROBOT_INPUTS_H_
