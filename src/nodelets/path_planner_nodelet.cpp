#include <nav_msgs/GetPlan.h>
#include <nodelet/nodelet.h>
#include <ros/callback_queue.h>
#include <ros/spinner.h>

#include <memory>
#include <pluginlib/class_list_macros.hpp>
#include <string>
#include <vector>

#include "vfh_astar/planning/path_planner.h"
#include "vfh_astar/planning/planning_thread.h"
#include "vfh_astar/ros/frame_names.h"
#include "vfh_astar/ros/geometry_messages.h"
#include "vfh_astar/ros/map_subscription.h"
#include "vfh_astar/ros/message_error.h"
#include "vfh_astar/ros/motion_messages.h"
#include "vfh_astar/ros/ros_parameter_reader.h"
#include "vfh_astar/ros/transforms.h"

namespace vfh_astar {
namespace {

struct PathPlannerNodeletParameters {
  PathPlannerParameters planner;
  FrameNames frames;
  double inflated_map_period = 1.0;  ///< s between two inflated maps, while
                                     ///< somebody listens.

  void Read(ParameterReader& reader) {
    planner.Read(reader);
    frames.Read(reader);
    reader.Number("inflated_map_period", inflated_map_period, 0.05, 3600.0);
  }
};

}  // namespace

/// Requests and the map in; plans out. The callbacks leave what has come for
/// the planning thread, and `make_plan` waits for it in a thread of its own.
class PathPlannerNodelet : public nodelet::Nodelet {
 public:
  ~PathPlannerNodelet() override {
    if (!planning_) return;
    planning_->Close();
    // Whoever waited for an answer has one by now.
    if (service_spinner_) service_spinner_->stop();
  }

 private:
  void onInit() override {
    parameters_ =
        ReadParameters<PathPlannerNodeletParameters>(getPrivateNodeHandle());
    ros::NodeHandle& node = getNodeHandle();
    plan_publisher_ = node.advertise<nav_msgs::Path>("plan", 1);
    failure_publisher_ = node.advertise<MotionFailure>("plan_failure", 10);
    inflated_publisher_ =
        node.advertise<nav_msgs::OccupancyGrid>("inflated_map", 1, true);
    transforms_ = SharedTransforms();
    planning_ = std::make_unique<PlanningThread>(parameters_.planner);
    map_subscription_ = std::make_unique<MapSubscription>(
        node, parameters_.frames.map_frame,
        [this](const OccupancyGrid& map) {
          planning_->SetMap(map);
          is_map_new_ = true;
        },
        [this](const cv::Rect& window, const std::vector<std::int8_t>& values) {
          planning_->UpdateMap({window, values});
          is_map_new_ = true;
        });
    query_subscriber_ = node.subscribe<MotionQuery>(
        "plan_request", 10,
        [this](const MotionQueryConstPtr& query) { OnQuery(*query); });
    AdvertiseServices(node);
    inflated_timer_ =
        node.createTimer(ros::Duration(parameters_.inflated_map_period),
                         [this](const ros::TimerEvent&) { OnInflatedTimer(); });
  }

  void AdvertiseServices(ros::NodeHandle node) {
    // A caller waits in a queue of its own, and keeps nothing else waiting.
    node.setCallbackQueue(&service_queue_);
    services_ = {node.advertiseService("make_plan",
                                       &PathPlannerNodelet::OnMakePlan, this),
                 // Where clients of move_base look for it.
                 node.advertiseService("move_base/make_plan",
                                       &PathPlannerNodelet::OnMakePlan, this)};
    service_spinner_ = std::make_unique<ros::AsyncSpinner>(1, &service_queue_);
    service_spinner_->start();
  }

  void OnQuery(const MotionQuery& query) {
    try {
      planning_->Request(
          ToPlanRequest(query, parameters_.frames.map_frame),
          [this, query](const PlanResult& result) { Answer(query, result); });
    } catch (const MessageError& error) {
      PublishFailure(
          query, Outcome::kInvalidGoal,
          std::string("the question cannot be used: ") + error.what());
    }
  }

  /// In the planning thread.
  void Answer(const MotionQuery& query, const PlanResult& result) {
    if (result.outcome != Outcome::kSuccess) {
      PublishFailure(query, result.outcome, result.message);
      return;
    }
    plan_publisher_.publish(ToPathMessage(result.path, result.goal,
                                          parameters_.frames.map_frame,
                                          query.header.stamp));
    if (result.goal.position() != ToPose2D(query.goal).position()) {
      NODELET_INFO_THROTTLE(5.0, "%s", result.message.c_str());
    }
  }

  void PublishFailure(const MotionQuery& query, Outcome outcome,
                      const std::string& message) {
    failure_publisher_.publish(
        ToFailureMessage(query, "path_planner", outcome, message));
  }

  bool OnMakePlan(nav_msgs::GetPlan::Request& question,
                  nav_msgs::GetPlan::Response& answer) {
    const std::string& frame = parameters_.frames.map_frame;
    PlanRequest request;
    request.tolerance = question.tolerance;
    try {
      request.start = question.start.header.frame_id.empty()
                          ? RobotPose()
                          : PoseInFrame(question.start, frame, *transforms_);
      request.goal = PoseInFrame(question.goal, frame, *transforms_);
    } catch (const MessageError& error) {
      NODELET_ERROR("make_plan: %s", error.what());
      return false;
    }
    const PlanResult result = planning_->Plan(request);
    answer.plan.header.frame_id = frame;
    answer.plan.header.stamp = ros::Time::now();
    if (result.outcome == Outcome::kSuccess) {
      answer.plan = ToPathMessage(result.path, result.goal, frame,
                                  answer.plan.header.stamp);
    } else {
      // move_base too answers with an empty path.
      NODELET_WARN("make_plan: %s", result.message.c_str());
    }
    return true;
  }

  Pose2D RobotPose() const {
    geometry_msgs::PoseStamped pose;
    pose.header.frame_id = parameters_.frames.base_frame;
    pose.pose.orientation.w = 1.0;
    return PoseInFrame(pose, parameters_.frames.map_frame, *transforms_);
  }

  void OnInflatedTimer() {
    if (!is_map_new_ || inflated_publisher_.getNumSubscribers() == 0) return;
    is_map_new_ = false;
    planning_->InflateMap([this](const OccupancyGrid& map) {
      inflated_publisher_.publish(
          ToMapMessage(map, parameters_.frames.map_frame, ros::Time::now()));
    });
  }

  PathPlannerNodeletParameters parameters_;
  bool is_map_new_ = false;  ///< since the last inflated map.

  std::shared_ptr<const tf2_ros::Buffer> transforms_;
  ros::Publisher plan_publisher_;
  ros::Publisher failure_publisher_;
  ros::Publisher inflated_publisher_;
  std::unique_ptr<PlanningThread> planning_;
  // Their callbacks need what stands above.
  std::unique_ptr<MapSubscription> map_subscription_;
  ros::Subscriber query_subscriber_;
  ros::CallbackQueue service_queue_;
  std::vector<ros::ServiceServer> services_;
  std::unique_ptr<ros::AsyncSpinner> service_spinner_;
  ros::Timer inflated_timer_;
};

}  // namespace vfh_astar

PLUGINLIB_EXPORT_CLASS(vfh_astar::PathPlannerNodelet, nodelet::Nodelet)
