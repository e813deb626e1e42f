#include <nav_msgs/GetPlan.h>
#include <nodelet/nodelet.h>
#include <tf2_ros/transform_listener.h>

#include <atomic>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <pluginlib/class_list_macros.hpp>
#include <string>
#include <thread>
#include <utility>

#include "vfh_astar/planning/path_planner.h"
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

/// What the planning thread shares with the callbacks.
struct PlanningDesk {
  explicit PlanningDesk(const PathPlannerParameters& parameters)
      : planner(parameters) {}

  PathPlanner planner;
  std::optional<MotionQuery> query;   ///< waits to be planned.
  std::vector<Eigen::Vector2d> path;  ///< the last one found.
  bool is_closing = false;
};

}  // namespace

/// Questions and the map in; plans out. Plans in a thread of its own, so that a
/// newer question can cut short the one that is being planned. `make_plan` is
/// answered by the same planner between two of them: a plan takes milliseconds,
/// a second planner as much memory again as the first.
class PathPlannerNodelet : public nodelet::Nodelet {
 public:
  ~PathPlannerNodelet() override {
    if (!thread_.joinable()) return;
    is_outdated_ = true;
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      desk_->is_closing = true;
    }
    wake_.notify_one();
    thread_.join();
  }

 private:
  void onInit() override {
    parameters_ =
        ReadParameters<PathPlannerNodeletParameters>(getPrivateNodeHandle());
    desk_ = std::make_unique<PlanningDesk>(parameters_.planner);
    ros::NodeHandle& node = getNodeHandle();
    plan_publisher_ = node.advertise<nav_msgs::Path>("plan", 1);
    failure_publisher_ = node.advertise<MotionFailure>("plan_failure", 10);
    inflated_publisher_ =
        node.advertise<nav_msgs::OccupancyGrid>("inflated_map", 1, true);
    listener_ = std::make_unique<tf2_ros::TransformListener>(transforms_, node);
    thread_ = std::thread([this] { PlanUntilClosed(); });
    map_subscription_ = std::make_unique<MapSubscription>(
        node, [this](const OccupancyGrid& map) { OnMap(map); },
        [this](const cv::Rect& window, const std::vector<std::int8_t>& values) {
          OnWindow(window, values);
        });
    query_subscriber_ = node.subscribe<MotionQuery>(
        "plan_request", 10,
        [this](const MotionQueryConstPtr& query) { OnQuery(*query); });
    services_ = {node.advertiseService("make_plan",
                                       &PathPlannerNodelet::OnMakePlan, this),
                 // Where clients of move_base look for it.
                 node.advertiseService("move_base/make_plan",
                                       &PathPlannerNodelet::OnMakePlan, this)};
    inflated_timer_ = node.createTimer(
        ros::Duration(parameters_.inflated_map_period),
        [this](const ros::TimerEvent&) { PublishInflatedMap(); });
  }

  void OnMap(const OccupancyGrid& map) {
    const std::lock_guard<std::mutex> lock(mutex_);
    desk_->planner.SetMap(map);
    is_map_new_ = true;
  }

  void OnWindow(const cv::Rect& window,
                const std::vector<std::int8_t>& values) {
    const std::lock_guard<std::mutex> lock(mutex_);
    desk_->planner.UpdateMap(window, values);
    is_map_new_ = true;
  }

  void OnQuery(const MotionQuery& query) {
    // The lock is free as soon as a plan that is being made sees this.
    is_outdated_ = true;
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      desk_->query = query;
      is_outdated_ = false;
    }
    wake_.notify_one();
  }

  void PlanUntilClosed() {
    std::unique_lock<std::mutex> lock(mutex_);
    while (true) {
      wake_.wait(lock, [this] { return desk_->is_closing || desk_->query; });
      if (desk_->is_closing) return;
      const MotionQuery query = *std::exchange(desk_->query, std::nullopt);
      PlanRequest request = ToPlanRequest(query);
      request.previous = desk_->path;
      PlanResult result = desk_->planner.Plan(request, &is_outdated_);
      if (result.outcome == Outcome::kSuccess) desk_->path = result.path;
      lock.unlock();
      Answer(query, result);
      lock.lock();
    }
  }

  void Answer(const MotionQuery& query, const PlanResult& result) {
    if (result.outcome == Outcome::kSuccess) {
      plan_publisher_.publish(ToPathMessage(result.path, result.goal,
                                            parameters_.frames.map_frame,
                                            query.header.stamp));
      if (result.goal.position() != ToPose2D(query.goal).position()) {
        NODELET_INFO_THROTTLE(5.0, "%s", result.message.c_str());
      }
    } else if (result.outcome != Outcome::kCancelled) {
      failure_publisher_.publish(ToFailureMessage(
          query, "path_planner", result.outcome, result.message));
    }
  }

  bool OnMakePlan(nav_msgs::GetPlan::Request& question,
                  nav_msgs::GetPlan::Response& answer) {
    const std::string& frame = parameters_.frames.map_frame;
    PlanRequest request;
    request.tolerance = question.tolerance;
    try {
      request.start = question.start.header.frame_id.empty()
                          ? RobotPose()
                          : PoseInFrame(question.start, frame, transforms_);
      request.goal = PoseInFrame(question.goal, frame, transforms_);
    } catch (const MessageError& error) {
      NODELET_ERROR("make_plan: %s", error.what());
      return false;
    }
    std::unique_lock<std::mutex> lock(mutex_);
    const PlanResult result = desk_->planner.Plan(request);
    lock.unlock();
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
    return PoseInFrame(pose, parameters_.frames.map_frame, transforms_);
  }

  void PublishInflatedMap() {
    if (!is_map_new_ || inflated_publisher_.getNumSubscribers() == 0) return;
    is_map_new_ = false;
    std::unique_lock<std::mutex> lock(mutex_);
    const OccupancyGrid map = desk_->planner.InflatedMap();
    lock.unlock();
    inflated_publisher_.publish(
        ToMapMessage(map, parameters_.frames.map_frame, ros::Time::now()));
  }

  PathPlannerNodeletParameters parameters_;
  std::mutex mutex_;
  std::condition_variable wake_;
  std::unique_ptr<PlanningDesk> desk_;    ///< under mutex_.
  std::atomic<bool> is_outdated_{false};  ///< what is being planned is.
  bool is_map_new_ = false;               ///< since the last inflated map.

  tf2_ros::Buffer transforms_;
  std::unique_ptr<tf2_ros::TransformListener> listener_;
  ros::Publisher plan_publisher_;
  ros::Publisher failure_publisher_;
  ros::Publisher inflated_publisher_;
  std::unique_ptr<MapSubscription> map_subscription_;
  ros::Subscriber query_subscriber_;
  std::vector<ros::ServiceServer> services_;
  ros::Timer inflated_timer_;
  std::thread thread_;
};

}  // namespace vfh_astar

PLUGINLIB_EXPORT_CLASS(vfh_astar::PathPlannerNodelet, nodelet::Nodelet)
