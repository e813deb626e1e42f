#include "vfh_astar/ros/goal_server.h"

#include <ros/console.h>

#include <utility>

#include "vfh_astar/ros/message_error.h"
#include "vfh_astar/ros/transforms.h"

namespace vfh_astar {

GoalServer::GoalServer(ros::NodeHandle node, const tf2_ros::Buffer& transforms,
                       std::string map_frame, Start start, Cancel cancel)
    : transforms_(transforms),
      map_frame_(std::move(map_frame)),
      start_(std::move(start)),
      cancel_(std::move(cancel)),
      goal_publisher_(node.advertise<move_base_msgs::MoveBaseActionGoal>(
          "move_base/goal", 1)),
      server_(
          node, "move_base", [this](Handle goal) { OnGoal(std::move(goal)); },
          [this](Handle goal) { OnCancel(std::move(goal)); },
          /*auto_start=*/false) {
  // A goal without a client goes the way of all goals, so that it shows in the
  // action's status and can be cancelled there.
  simple_goal_subscriber_ = node.subscribe<geometry_msgs::PoseStamped>(
      "move_base_simple/goal", 1,
      [this](const geometry_msgs::PoseStampedConstPtr& pose) {
        move_base_msgs::MoveBaseActionGoal goal;
        goal.header.stamp = ros::Time::now();
        goal.goal.target_pose = *pose;
        goal_publisher_.publish(goal);
      });
  server_.start();
}

void GoalServer::OnGoal(Handle goal) {
  goal.setAccepted();
  std::optional<Pose2D> pose;
  std::string defect;
  try {
    pose = PoseInFrame(goal.getGoal()->target_pose, map_frame_, transforms_);
  } catch (const MessageError& error) {
    defect = std::string("the goal cannot be used: ") + error.what();
  }
  if (goal_) {
    goal_->setCanceled({}, "replaced by a new goal");
    goal_.reset();
    if (!pose) cancel_();
  }
  if (!pose) {
    ROS_ERROR("%s", defect.c_str());
    goal.setAborted({}, defect);
    return;
  }
  start_(goal.getGoalID().id, *pose);
  goal_ = std::move(goal);
}

void GoalServer::OnCancel(Handle goal) {
  if (goal_ && goal == *goal_) cancel_();
}

void GoalServer::Finish(const GoalResult& result) {
  if (!goal_ || goal_->getGoalID().id != result.goal_id) return;
  switch (result.outcome) {
    case Outcome::kSuccess:
      goal_->setSucceeded({}, result.message);
      break;
    case Outcome::kCancelled:
      goal_->setCanceled({}, result.message);
      break;
    default:
      goal_->setAborted({}, result.message);
  }
  goal_.reset();
}

void GoalServer::Abort(const std::string& reason) {
  if (goal_) goal_->setAborted({}, reason);
  goal_.reset();
}

void GoalServer::Report(const geometry_msgs::PoseStamped& robot_pose) {
  if (!goal_) return;
  move_base_msgs::MoveBaseFeedback feedback;
  feedback.base_position = robot_pose;
  goal_->publishFeedback(feedback);
}

}  // namespace vfh_astar
