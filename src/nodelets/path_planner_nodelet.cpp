#include <nav_msgs/GetPlan.h>
#include <nodelet/nodelet.h>
#include <ros/callback_queue.h>
#include <ros/spinner.h>
#include <tf2_ros/transform_listener.h>

#include <atomic>
#include <condition_variable>
#include <deque>
#include <future>
#include <iterator>
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

/// Somebody's wish for a plan who waits for it.
struct PlanQuestion {
  PlanRequest request;
  std::promise<PlanResult> answer;
};

struct MapWindow {
  cv::Rect cells;
  std::vector<std::int8_t> values;
};

/// What the callbacks leave for the planning thread.
struct PlanningDesk {
  std::optional<OccupancyGrid> map;
  std::vector<MapWindow> windows;    ///< of the map, or of the one before it.
  std::optional<MotionQuery> query;  ///< goes before the questions.
  std::deque<PlanQuestion> questions;
  bool wants_inflated_map = false;
  bool is_closing = false;

  bool HasWork() const {
    return is_closing || map || !windows.empty() || query ||
           !questions.empty() || wants_inflated_map;
  }
};

}  // namespace

/// Requests and the map in; plans out. The planner belongs to a thread of its
/// own, for which the callbacks leave what has come, so that no search makes
/// them wait. A newer request cuts short whatever is being planned. `make_plan`
/// is answered by the same planner while no request waits: a plan takes
/// milliseconds, a second planner as much memory again as the first.
class PathPlannerNodelet : public nodelet::Nodelet {
 public:
  ~PathPlannerNodelet() override {
    if (!thread_.joinable()) return;
    Leave([this](PlanningDesk& desk) {
      desk.is_closing = true;
      is_outdated_ = true;
    });
    thread_.join();
    // Whoever waits for an answer has one by now.
    service_spinner_->stop();
  }

 private:
  void onInit() override {
    parameters_ =
        ReadParameters<PathPlannerNodeletParameters>(getPrivateNodeHandle());
    planner_ = std::make_unique<PathPlanner>(parameters_.planner);
    ros::NodeHandle& node = getNodeHandle();
    plan_publisher_ = node.advertise<nav_msgs::Path>("plan", 1);
    failure_publisher_ = node.advertise<MotionFailure>("plan_failure", 10);
    inflated_publisher_ =
        node.advertise<nav_msgs::OccupancyGrid>("inflated_map", 1, true);
    listener_ = std::make_unique<tf2_ros::TransformListener>(transforms_, node);
    thread_ = std::thread([this] { PlanUntilClosed(); });
    map_subscription_ = std::make_unique<MapSubscription>(
        node, parameters_.frames.map_frame,
        [this](const OccupancyGrid& map) { OnMap(map); },
        [this](const cv::Rect& window, const std::vector<std::int8_t>& values) {
          OnWindow(window, values);
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

  /// Changes what lies on the desk, and wakes the planning thread.
  template <typename Change>
  void Leave(Change change) {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      change(desk_);
    }
    wake_.notify_one();
  }

  void OnMap(const OccupancyGrid& map) {
    Leave([&map](PlanningDesk& desk) {
      desk.map = map;
      desk.windows.clear();
    });
    is_map_new_ = true;
  }

  void OnWindow(const cv::Rect& cells, const std::vector<std::int8_t>& values) {
    Leave([&](PlanningDesk& desk) { desk.windows.push_back({cells, values}); });
    is_map_new_ = true;
  }

  void OnQuery(const MotionQuery& query) {
    Leave([this, &query](PlanningDesk& desk) {
      desk.query = query;
      is_outdated_ = true;
    });
  }

  void PlanUntilClosed() {
    while (true) {
      PlanningDesk work = TakeWork();
      if (work.is_closing) {
        for (PlanQuestion& question : work.questions) {
          Answer(question, Closing());
        }
        return;
      }
      if (work.map) planner_->SetMap(*work.map);
      for (const MapWindow& window : work.windows) {
        planner_->UpdateMap(window.cells, window.values);
      }
      if (work.query) Plan(*work.query);
      if (!work.questions.empty()) Plan(work.questions.front());
      if (work.wants_inflated_map) PublishInflatedMap();
    }
  }

  /// Waits for work. A question is taken only when no query is; on closing, all
  /// of them.
  PlanningDesk TakeWork() {
    std::unique_lock<std::mutex> lock(mutex_);
    wake_.wait(lock, [this] { return desk_.HasWork(); });
    PlanningDesk work = std::exchange(desk_, {});
    desk_.is_closing = work.is_closing;
    if (!work.is_closing) {
      const int taken = work.query || work.questions.empty() ? 0 : 1;
      desk_.questions.assign(
          std::make_move_iterator(work.questions.begin() + taken),
          std::make_move_iterator(work.questions.end()));
      work.questions.resize(taken);
      is_outdated_ = false;
    }
    return work;
  }

  void Plan(const MotionQuery& query) {
    PlanResult result;
    try {
      PlanRequest request = ToPlanRequest(query, parameters_.frames.map_frame);
      request.previous = path_;
      result = planner_->Plan(request, &is_outdated_);
      if (result.outcome == Outcome::kSuccess) path_ = result.path;
    } catch (const MessageError& error) {
      result.outcome = Outcome::kInvalidGoal;
      result.message =
          std::string("the question cannot be used: ") + error.what();
    }
    Answer(query, result);
  }

  void Plan(PlanQuestion& question) {
    const PlanResult result = planner_->Plan(question.request, &is_outdated_);
    if (result.outcome != Outcome::kCancelled) {
      Answer(question, result);
      return;
    }
    // It has made way for a query and is next after it.
    Leave([&question](PlanningDesk& desk) {
      desk.questions.push_front(std::move(question));
    });
  }

  static PlanResult Closing() {
    PlanResult result;
    result.outcome = Outcome::kCancelled;
    result.message = "the planner is being closed";
    return result;
  }

  static void Answer(PlanQuestion& question, const PlanResult& result) {
    question.answer.set_value(result);
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
    const PlanResult result = Ask(std::move(request));
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

  /// Has the planning thread make a plan, and waits for it.
  PlanResult Ask(PlanRequest request) {
    PlanQuestion question;
    question.request = std::move(request);
    std::future<PlanResult> answer = question.answer.get_future();
    bool is_closing = false;
    Leave([&](PlanningDesk& desk) {
      is_closing = desk.is_closing;
      if (!is_closing) desk.questions.push_back(std::move(question));
    });
    return is_closing ? Closing() : answer.get();
  }

  Pose2D RobotPose() const {
    geometry_msgs::PoseStamped pose;
    pose.header.frame_id = parameters_.frames.base_frame;
    pose.pose.orientation.w = 1.0;
    return PoseInFrame(pose, parameters_.frames.map_frame, transforms_);
  }

  void OnInflatedTimer() {
    if (!is_map_new_ || inflated_publisher_.getNumSubscribers() == 0) return;
    is_map_new_ = false;
    Leave([](PlanningDesk& desk) { desk.wants_inflated_map = true; });
  }

  void PublishInflatedMap() {
    inflated_publisher_.publish(ToMapMessage(planner_->InflatedMap(),
                                             parameters_.frames.map_frame,
                                             ros::Time::now()));
  }

  PathPlannerNodeletParameters parameters_;
  std::mutex mutex_;
  std::condition_variable wake_;
  PlanningDesk desk_;                     ///< under mutex_.
  std::atomic<bool> is_outdated_{false};  ///< what is being planned is; written
                                          ///< under mutex_.
  bool is_map_new_ = false;               ///< since the last inflated map.
  // The planning thread's:
  std::unique_ptr<PathPlanner> planner_;
  std::vector<Eigen::Vector2d> path_;  ///< the last one found.

  tf2_ros::Buffer transforms_;
  std::unique_ptr<tf2_ros::TransformListener> listener_;
  ros::Publisher plan_publisher_;
  ros::Publisher failure_publisher_;
  ros::Publisher inflated_publisher_;
  std::unique_ptr<MapSubscription> map_subscription_;
  ros::Subscriber query_subscriber_;
  ros::CallbackQueue service_queue_;
  std::vector<ros::ServiceServer> services_;
  std::unique_ptr<ros::AsyncSpinner> service_spinner_;
  ros::Timer inflated_timer_;
  std::thread thread_;
};

}  // namespace vfh_astar

PLUGINLIB_EXPORT_CLASS(vfh_astar::PathPlannerNodelet, nodelet::Nodelet)
