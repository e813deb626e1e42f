#include "robot_topics.h"

#include <std_msgs/Float64.h>

#include <optional>

#include "sensor_messages.h"
#include "vfh_astar/ros/geometry_messages.h"

namespace vfh_astar {
namespace {

// Messages for a subscriber that is late: a fraction of a second of them, as
// unpaced a second of simulated time takes a hundredth.
constexpr int kQueueSize = 50;
// m above base_link, as urdf/jackal.urdf has it.
constexpr double kLaserHeight = 0.24;

geometry_msgs::TransformStamped Stamped(const geometry_msgs::Transform& value,
                                        double stamp,
                                        const std::string& frame_id,
                                        const std::string& child_frame_id) {
  geometry_msgs::TransformStamped message;
  message.header.stamp.fromSec(stamp);
  message.header.frame_id = frame_id;
  message.child_frame_id = child_frame_id;
  message.transform = value;
  return message;
}

}  // namespace

RobotTopics::RobotTopics(ros::NodeHandle node, Simulation* simulation,
                         std::size_t robot, const std::string& tf_prefix,
                         bool listens_to_navigation)
    : simulation_(simulation), robot_(robot) {
  const std::string prefix = tf_prefix.empty() ? "" : tf_prefix + "/";
  frames_ = {prefix + "odom", prefix + "base_link", prefix + "front_laser"};

  scan_publisher_ =
      node.advertise<sensor_msgs::LaserScan>("front/scan", kQueueSize);
  filtered_publisher_ =
      node.advertise<nav_msgs::Odometry>("odometry/filtered", kQueueSize);
  wheel_publisher_ = node.advertise<nav_msgs::Odometry>(
      "jackal_velocity_controller/odom", kQueueSize);
  imu_publisher_ = node.advertise<sensor_msgs::Imu>("imu/data", kQueueSize);
  joint_publisher_ =
      node.advertise<sensor_msgs::JointState>("joint_states", kQueueSize);
  truth_publisher_ =
      node.advertise<nav_msgs::Odometry>("ground_truth/odom", kQueueSize);
  collision_publisher_ = node.advertise<CollisionReport>("collision", 1, true);
  clearance_publisher_ =
      node.advertise<std_msgs::Float64>("clearance", kQueueSize);
  PublishCollision();

  // Small messages on which the clock may wait: no delay to gather more.
  const auto hints = ros::TransportHints().tcpNoDelay();
  command_subscriber_ = node.subscribe<geometry_msgs::Twist>(
      "cmd_vel", kQueueSize,
      [this](const geometry_msgs::TwistConstPtr& message) {
        OnCommand(*message);
      },
      ros::VoidConstPtr(), hints);
  if (!listens_to_navigation) return;
  navigation_subscriber_ = node.subscribe<NavigationState>(
      "navigation_state", kQueueSize,
      [this](const NavigationStateConstPtr& message) {
        OnNavigationState(*message);
      },
      ros::VoidConstPtr(), hints);
}

void RobotTopics::OnCommand(const geometry_msgs::Twist& message) {
  answer_.TakeCommand();
  const Twist2D command = ToTwist2D(message);
  if (command.IsFinite()) {
    simulation_->SetCommand(robot_, command);
  } else {
    ROS_WARN_THROTTLE(10.0,
                      "a command on %s is refused: linear.x is %g, angular.z "
                      "is %g; expected finite numbers",
                      command_subscriber_.getTopic().c_str(), command.v,
                      command.w);
  }
}

void RobotTopics::OnNavigationState(const NavigationState& message) {
  answer_.TakeState(message.scan_stamp.toSec(), message.commanded);
}

void RobotTopics::Publish(const StepEvents& events) {
  if (simulation_->collision(robot_).has_value() != is_collision_known_) {
    PublishCollision();
  }
  // Before the scan, which is placed by it.
  if (events.odometry) PublishMotion();
  if (simulation_->HasNewScan(robot_)) PublishScan();
}

void RobotTopics::PublishScan() {
  const LaserScan& scan = simulation_->scan(robot_);
  const double period = 1.0 / simulation_->laser(robot_).rate;
  scan_publisher_.publish(ToScanMessage(scan, period, frames_.laser));
  answer_.TakeScan(scan.stamp);
}

void RobotTopics::PublishMotion() {
  const OdometryReading& filtered = simulation_->filtered_odometry(robot_);
  broadcaster_.sendTransform(Stamped(ToTransformMessage(filtered.pose),
                                     filtered.stamp, frames_.odom,
                                     frames_.base));
  filtered_publisher_.publish(
      ToOdometryMessage(filtered, frames_.odom, frames_.base));
  wheel_publisher_.publish(ToOdometryMessage(
      simulation_->wheel_odometry(robot_), frames_.odom, frames_.base));
  imu_publisher_.publish(ToImuMessage(
      simulation_->imu(robot_), simulation_->parameters().noise, frames_.base));
  joint_publisher_.publish(
      ToJointMessage(simulation_->WheelAngles(robot_), filtered.stamp));

  OdometryReading truth;
  truth.stamp = simulation_->time();
  truth.pose = simulation_->TruePose(robot_);
  truth.twist = simulation_->TrueTwist(robot_);
  truth_publisher_.publish(ToOdometryMessage(truth, "world", frames_.base));
  if (clearance_publisher_.getNumSubscribers() > 0) {
    std_msgs::Float64 clearance;
    clearance.data = simulation_->Clearance(robot_);
    clearance_publisher_.publish(clearance);
  }
}

void RobotTopics::PublishCollision() {
  const std::optional<Collision>& collision = simulation_->collision(robot_);
  collision_publisher_.publish(
      ToCollisionMessage(collision, simulation_->time(), frames_.base));
  is_collision_known_ = collision.has_value();
}

bool RobotTopics::HasAnswer() const {
  return answer_.IsComplete(navigation_subscriber_.getNumPublishers() > 0,
                            command_subscriber_.getNumPublishers() > 0);
}

void RobotTopics::BeginAnew() {
  answer_ = ScanAnswer();
  PublishCollision();
}

geometry_msgs::TransformStamped RobotTopics::LaserTransform() const {
  geometry_msgs::TransformStamped transform =
      Stamped(ToTransformMessage(simulation_->laser(robot_).mount), 0.0,
              frames_.base, frames_.laser);
  transform.transform.translation.z = kLaserHeight;
  return transform;
}

}  // namespace vfh_astar
