#ifndef VFH_ASTAR_NODES_ROBOT_TOPICS_H_
#define VFH_ASTAR_NODES_ROBOT_TOPICS_H_

#include <geometry_msgs/TransformStamped.h>
#include <geometry_msgs/Twist.h>
#include <ros/node_handle.h>
#include <tf2_ros/transform_broadcaster.h>
#include <vfh_astar/NavigationState.h>

#include <cstddef>
#include <string>

#include "scan_answer.h"
#include "vfh_astar/simulation/simulation.h"

namespace vfh_astar {

/// One simulated robot's side of the ROS interface, as a real Jackal has it:
/// `cmd_vel` in, sensors and tf out; and what no real robot knows of itself:
/// `ground_truth/odom` in the frame `world`, `collision` (latched), `clearance`
/// (m from the footprint to the nearest solid thing).
class RobotTopics {
 public:
  /// @param[in] node in whose namespace the topics are, and whose queue brings
  ///   the commands.
  /// @param[in] simulation has to outlive this object.
  /// @param[in] robot its number in the simulation.
  /// @param[in] tf_prefix of its frames; empty for none.
  /// @param[in] listens_to_navigation HasAnswer() waits for it where it runs.
  RobotTopics(ros::NodeHandle node, Simulation* simulation, std::size_t robot,
              const std::string& tf_prefix, bool listens_to_navigation);
  RobotTopics(const RobotTopics&) = delete;
  RobotTopics& operator=(const RobotTopics&) = delete;

  /// Publishes what became new in the last step.
  void Publish(const StepEvents& events);

  /// True when the scan published last was answered, as ScanAnswer tells, and
  /// when there is nobody who could.
  bool HasAnswer() const;

  /// An answer has not come in time.
  void GiveUpAnswer() { answer_.GiveUp(); }

  /// The simulation was reset: no answer to earlier scans is to come.
  void BeginAnew();

  /// Where the laser is mounted.
  geometry_msgs::TransformStamped LaserTransform() const;

 private:
  void OnCommand(const geometry_msgs::Twist& message);
  void OnNavigationState(const NavigationState& message);
  void PublishScan();
  void PublishMotion();
  void PublishCollision();

  struct Frames {
    std::string odom;
    std::string base;
    std::string laser;
  };

  Simulation* simulation_;
  std::size_t robot_;
  Frames frames_;
  bool is_collision_known_ = false;  ///< to the topic.
  ScanAnswer answer_;

  ros::Publisher scan_publisher_;
  ros::Publisher filtered_publisher_;
  ros::Publisher wheel_publisher_;
  ros::Publisher imu_publisher_;
  ros::Publisher joint_publisher_;
  ros::Publisher truth_publisher_;
  ros::Publisher collision_publisher_;
  ros::Publisher clearance_publisher_;
  tf2_ros::TransformBroadcaster broadcaster_;
  ros::Subscriber command_subscriber_;
  ros::Subscriber navigation_subscriber_;
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_NODES_ROBOT_TOPICS_H_
