#include <nodelet/nodelet.h>

#include <algorithm>
#include <deque>
#include <memory>
#include <optional>
#include <pluginlib/class_list_macros.hpp>
#include <string>
#include <vector>

#include "vfh_astar/grid/clearance.h"
#include "vfh_astar/grid/map_window.h"
#include "vfh_astar/ros/frame_names.h"
#include "vfh_astar/ros/geometry_messages.h"
#include "vfh_astar/ros/map_subscription.h"
#include "vfh_astar/ros/message_error.h"
#include "vfh_astar/ros/motion_messages.h"
#include "vfh_astar/ros/reconfiguration.h"
#include "vfh_astar/ros/ros_parameter_reader.h"
#include "vfh_astar/trajectory/trajectory_fitter.h"

namespace vfh_astar {
namespace {

constexpr std::size_t kRememberedQueries = 8;

struct TrajectoryFitterNodeletParameters {
  TrajectoryFitterParameters fitter;
  FrameNames frames;

  void Read(ParameterReader& reader) {
    fitter.Read(reader);
    frames.Read(reader);
  }
};

}  // namespace

/// Plans and the map in; trajectories out. A plan is matched to its question by
/// the stamp; one that answers none is fitted from rest at its first pose.
class TrajectoryFitterNodelet : public nodelet::Nodelet {
 private:
  void onInit() override {
    parameters_ = ReadParameters<TrajectoryFitterNodeletParameters>(
        getPrivateNodeHandle());
    fitter_ = std::make_unique<TrajectoryFitter>(parameters_.fitter);
    clearance_ =
        std::make_unique<ClearanceMap>(parameters_.fitter.occupied_threshold,
                                       parameters_.fitter.ClearanceReach());
    ros::NodeHandle& node = getNodeHandle();
    trajectory_publisher_ = node.advertise<QuinticTrajectory>("trajectory", 1);
    path_publisher_ = node.advertise<nav_msgs::Path>("trajectory_path", 1);
    failure_publisher_ = node.advertise<MotionFailure>("plan_failure", 10);
    limits_ = std::make_unique<Reconfiguration<LimitsConfig>>(
        ros::NodeHandle(getPrivateNodeHandle(), "limits"),
        ToConfig(parameters_.fitter.limits),
        [this](const LimitsConfig& config) {
          Apply(config, parameters_.fitter.limits);
          fitter_ = std::make_unique<TrajectoryFitter>(parameters_.fitter);
        });
    // From here on callbacks come, in another thread than this one.
    map_subscription_ = std::make_unique<MapSubscription>(
        node, parameters_.frames.map_frame,
        [this](const OccupancyGrid& map) {
          windows_.clear();
          clearance_->SetMap(map);
          has_map_ = true;
        },
        [this](const cv::Rect& window, const std::vector<std::int8_t>& values) {
          windows_.push_back({window, values});
          if (windows_.size() >= kMostGatheredWindows) TakeInWindows();
        });
    query_subscriber_ = node.subscribe<MotionQuery>(
        "plan_request", 10,
        [this](const MotionQueryConstPtr& query) { OnQuery(*query); });
    plan_subscriber_ = node.subscribe<nav_msgs::Path>(
        "plan", 10,
        [this](const nav_msgs::PathConstPtr& plan) { OnPlan(plan); });
  }

  void TakeInWindows() {
    if (!windows_.empty()) clearance_->Update(windows_);
    windows_.clear();
  }

  void OnQuery(const MotionQuery& query) {
    queries_.push_back(query);
    if (queries_.size() > kRememberedQueries) queries_.pop_front();
    // The plan may have overtaken its question.
    if (plan_ && plan_->header.stamp == query.header.stamp) Fit(*plan_, &query);
  }

  void OnPlan(const nav_msgs::PathConstPtr& plan) {
    plan_ = plan;
    const auto query = std::find_if(
        queries_.begin(), queries_.end(), [&plan](const MotionQuery& query) {
          return query.header.stamp == plan->header.stamp;
        });
    if (query == queries_.end()) {
      Fit(*plan, nullptr);
    } else if (std::next(query) == queries_.end()) {
      Fit(*plan, &*query);
    }
    // Else there is a newer question, and its plan is on the way.
  }

  void Fit(const nav_msgs::Path& plan, const MotionQuery* query) {
    try {
      CheckFrame(plan.header.frame_id, parameters_.frames.map_frame);
      const FitRequest request = ToFitRequest(plan, query);
      TakeInWindows();
      const FitResult result = Fit(request);
      if (result.outcome == Outcome::kSuccess) {
        Publish(result.trajectory, query);
      } else {
        Report(result, query);
      }
    } catch (const MessageError& error) {
      NODELET_WARN_THROTTLE(10.0, "a plan is dropped: %s", error.what());
    }
  }

  FitResult Fit(const FitRequest& request) const {
    if (has_map_) return fitter_->Fit(request, *clearance_);
    FitResult result;
    result.outcome = Outcome::kNoMap;
    result.message = "the trajectory fitter has received no map";
    return result;
  }

  void Publish(const Trajectory& trajectory, const MotionQuery* query) {
    const std::string& frame = parameters_.frames.map_frame;
    const ros::Time start = query ? query->start_time : ros::Time::now();
    QuinticTrajectory message = ToTrajectoryMessage(trajectory, frame, start);
    if (query) {
      message.goal_id = query->goal_id;
      message.request_id = query->id;
    }
    trajectory_publisher_.publish(message);
    if (path_publisher_.getNumSubscribers() > 0) {
      path_publisher_.publish(ToPathMessage(trajectory, frame, start));
    }
  }

  void Report(const FitResult& result, const MotionQuery* query) {
    if (query) {
      failure_publisher_.publish(ToFailureMessage(
          *query, "trajectory_fitter", result.outcome, result.message));
    } else {
      NODELET_WARN("no trajectory for a plan: %s", result.message.c_str());
    }
  }

  TrajectoryFitterNodeletParameters parameters_;
  std::unique_ptr<TrajectoryFitter> fitter_;
  std::unique_ptr<ClearanceMap> clearance_;
  std::vector<MapWindow> windows_;  ///< that clearance_ does not have yet.
  bool has_map_ = false;
  std::deque<MotionQuery> queries_;  ///< oldest first.
  nav_msgs::PathConstPtr plan_;      ///< the newest.

  std::unique_ptr<Reconfiguration<LimitsConfig>> limits_;
  ros::Publisher trajectory_publisher_;
  ros::Publisher path_publisher_;
  ros::Publisher failure_publisher_;
  std::unique_ptr<MapSubscription> map_subscription_;
  ros::Subscriber query_subscriber_;
  ros::Subscriber plan_subscriber_;
};

}  // namespace vfh_astar

PLUGINLIB_EXPORT_CLASS(vfh_astar::TrajectoryFitterNodelet, nodelet::Nodelet)
