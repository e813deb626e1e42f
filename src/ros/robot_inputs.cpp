#include "vfh_astar/ros/robot_inputs.h"

#include <ros/console.h>

#include <utility>

#include "vfh_astar/ros/geometry_messages.h"
#include "vfh_astar/ros/message_error.h"
#include "vfh_astar/ros/scan_messages.h"
#include "vfh_astar/ros/transforms.h"

namespace vfh_astar {
namespace {

// m of clearance around a trajectory that are worth knowing.
constexpr double kClearanceReach = 1.0;
// s after the mapper's last word in which it still holds.
constexpr double kLocalizationHolds = 1.0;
// s that the laser's clock may be ahead.
constexpr double kClockTolerance = 1.0;

void CheckStamp(const ros::Time& stamp) {
  // A simulated clock comes by message, and that may well come late.
  if (ros::Time::isSimTime()) return;
  const double ahead = (stamp - ros::Time::now()).toSec();
  if (ahead > kClockTolerance) {
    throw MessageError("its stamp lies " + std::to_string(ahead) +
                       " s in the future");
  }
}

}  // namespace

RobotInputs::RobotInputs(ros::NodeHandle node, const FrameNames& frames,
                         int occupied_threshold)
    : frames_(frames),
      transforms_(SharedTransforms()),
      map_(occupied_threshold, kClearanceReach),
      map_subscription_(
          node, frames.map_frame,
          [this](const OccupancyGrid& map) {
            map_.SetMap(map);
            has_map_ = true;
          },
          [this](const cv::Rect& window,
                 const std::vector<std::int8_t>& values) {
            map_.Update(window, values);
          }) {}

void RobotInputs::Listen(ros::NodeHandle node, OnInput on_scan,
                         OnInput on_odometry, OnMapped on_mapped) {
  on_scan_ = std::move(on_scan);
  on_odometry_ = std::move(on_odometry);
  on_mapped_ = std::move(on_mapped);
  const ros::TransportHints hints = ros::TransportHints().tcpNoDelay();
  // One scan and no more waits: an older one is no ground to drive on.
  scan_subscriber_ = node.subscribe<sensor_msgs::LaserScan>(
      "front/scan", 1,
      [this](const sensor_msgs::LaserScanConstPtr& scan) { Take(*scan); },
      nullptr, hints);
  odometry_subscriber_ = node.subscribe<nav_msgs::Odometry>(
      "odometry/filtered", 1,
      [this](const nav_msgs::OdometryConstPtr& odometry) { Take(*odometry); },
      nullptr, hints);
  localization_subscriber_ = node.subscribe<LocalizationState>(
      "localization", 10,
      [this](const LocalizationStateConstPtr& state) { Take(*state); });
}

void RobotInputs::Take(const sensor_msgs::LaserScan& message) {
  try {
    CheckStamp(message.header.stamp);
    const LaserMount mount = ToLaserMount(
        transforms_
            ->lookupTransform(frames_.base_frame,
                              WithoutSlash(message.header.frame_id),
                              ros::Time(0))
            .transform);
    LaserScan scan = ToLaserScan(message, mount.upside_down);
    if (const auto defect = DescribeDefect(scan)) throw MessageError(*defect);
    scan_ = std::move(scan);
    scan_stamp_ = message.header.stamp;
    base_from_laser_ = mount.pose;
    scan_defect_.clear();
  } catch (const MessageError& error) {
    scan_defect_ = error.what();
  } catch (const tf2::TransformException& error) {
    scan_defect_ = "there is no transform from " + frames_.base_frame + " to " +
                   message.header.frame_id + ": " + error.what();
  }
  if (scan_defect_.empty()) {
    on_scan_();
  } else {
    ++unusable_scans_;
    ROS_WARN_THROTTLE(10.0, "a scan is dropped: %s", scan_defect_.c_str());
  }
}

void RobotInputs::Take(const nav_msgs::Odometry& message) {
  const Pose2D pose = ToPose2D(message.pose.pose);
  const Twist2D twist = ToTwist2D(message.twist.twist);
  if (!pose.IsFinite() || !twist.IsFinite()) {
    ROS_WARN_THROTTLE(10.0, "an odometry message is dropped: not finite");
    return;
  }
  odometry_stamp_ = message.header.stamp.toSec();
  odom_from_base_ = pose;
  twist_ = twist;
  on_odometry_();
}

void RobotInputs::Take(const LocalizationState& message) {
  localization_stamp_ = message.header.stamp;
  map_from_odom_ = ToPose2D(message.map_from_odom);
  is_lost_ = message.lost;
  on_mapped_(message.header.stamp);
}

std::optional<geometry_msgs::TransformStamped> RobotInputs::MapFromOdom()
    const {
  try {
    return transforms_->lookupTransform(frames_.map_frame, frames_.odom_frame,
                                        ros::Time(0));
  } catch (const tf2::TransformException&) {
    return std::nullopt;
  }
}

NavigatorInput RobotInputs::At(const ros::Time& time) const {
  NavigatorInput input;
  input.time = time.toSec();
  const bool has_mapper =
      !localization_stamp_.isZero() &&
      time - localization_stamp_ < ros::Duration(kLocalizationHolds);
  if (has_mapper) {
    input.map_from_odom = map_from_odom_;
    input.map_from_odom_stamp = localization_stamp_.toSec();
    input.is_lost = is_lost_;
  } else if (const auto transform = MapFromOdom()) {
    input.map_from_odom = ToPose2D(transform->transform);
    // tf gives what is static no stamp.
    if (!transform->header.stamp.isZero()) {
      input.map_from_odom_stamp = transform->header.stamp.toSec();
    }
  }
  input.odometry_stamp = odometry_stamp_;
  input.odom_from_base = odom_from_base_;
  input.twist = twist_;
  input.scan = scan_ ? &*scan_ : nullptr;
  input.base_from_laser = base_from_laser_;
  input.scan_defect = scan_defect_;
  input.map = has_map_ ? &map_ : nullptr;
  return input;
}

std::optional<double> RobotInputs::TransformAge(const ros::Time& time) const {
  const auto transform = MapFromOdom();
  if (!transform) return std::nullopt;
  return (time - transform->header.stamp).toSec();
}

std::vector<std::string> RobotInputs::Missing() const {
  std::vector<std::string> missing;
  if (!scan_) {
    missing.push_back("no usable scan on " + scan_subscriber_.getTopic() +
                      (scan_defect_.empty() ? "" : ": " + scan_defect_));
  }
  if (!odometry_stamp_) {
    missing.push_back("no odometry on " + odometry_subscriber_.getTopic());
  }
  if (!MapFromOdom()) {
    missing.push_back("no transform from " + frames_.map_frame + " to " +
                      frames_.odom_frame);
  }
  if (!transforms_->canTransform(frames_.odom_frame, frames_.base_frame,
                                 ros::Time(0))) {
    missing.push_back("no transform from " + frames_.odom_frame + " to " +
                      frames_.base_frame);
  }
  if (!has_map_) missing.push_back("no map on map");
  return missing;
}

void RobotInputs::ForgetAfter(const ros::Time& time) {
  if (scan_stamp_ > time) {
    scan_.reset();
    scan_stamp_ = ros::Time();
  }
  if (odometry_stamp_ && *odometry_stamp_ > time.toSec()) {
    odometry_stamp_.reset();
  }
  if (localization_stamp_ > time) localization_stamp_ = ros::Time();
}

}  // namespace vfh_astar
