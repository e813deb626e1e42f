#ifndef VFH_ASTAR_ROS_GOAL_SERVER_H_
#define VFH_ASTAR_ROS_GOAL_SERVER_H_

#include <actionlib/server/action_server.h>
#include <geometry_msgs/PoseStamped.h>
#include <move_base_msgs/MoveBaseAction.h>
#include <ros/node_handle.h>
#include <tf2_ros/buffer.h>

#include <functional>
#include <optional>
#include <string>

#include "vfh_astar/geometry.h"
#include "vfh_astar/navigation/navigator.h"

namespace vfh_astar {

/// The action `move_base` and the topic `move_base_simple/goal`, with
/// move_base's manners: one goal at a time, a new one preempts the old one, and
/// one that makes no sense is aborted with the reason, and the old one with it.
class GoalServer {
 public:
  using Start = std::function<void(const std::string& goal_id, const Pose2D&)>;
  using Cancel = std::function<void()>;

  /// @param[in] node whose callback queue brings the goals.
  /// @param[in] transforms has to outlive the server.
  /// @param[in] start called with a new goal in `map_frame`.
  /// @param[in] cancel called when the goal is withdrawn; its end is to be
  ///   reported through Finish.
  GoalServer(ros::NodeHandle node, const tf2_ros::Buffer& transforms,
             std::string map_frame, Start start, Cancel cancel);

  /// Ends the present goal; a result for any other one is dropped.
  void Finish(const GoalResult& result);

  /// Aborts the present goal, if there is one.
  void Abort(const std::string& reason);

  /// Tells the present goal's client where the robot is.
  void Report(const geometry_msgs::PoseStamped& robot_pose);

 private:
  using Server = actionlib::ActionServer<move_base_msgs::MoveBaseAction>;
  using Handle = Server::GoalHandle;

  void OnGoal(Handle goal);
  void OnCancel(Handle goal);

  const tf2_ros::Buffer& transforms_;
  std::string map_frame_;
  Start start_;
  Cancel cancel_;
  std::optional<Handle> goal_;  ///< the present one.
  ros::Publisher goal_publisher_;
  ros::Subscriber simple_goal_subscriber_;
  Server server_;
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_ROS_GOAL_SERVER_H_
