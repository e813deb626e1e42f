#include <nodelet/nodelet.h>
#include <std_msgs/Empty.h>
#include <std_srvs/Empty.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <pluginlib/class_list_macros.hpp>
#include <string>

#include "vfh_astar/navigation/navigator.h"
#include "vfh_astar/ros/cycle_monitor.h"
#include "vfh_astar/ros/frame_names.h"
#include "vfh_astar/ros/geometry_messages.h"
#include "vfh_astar/ros/goal_server.h"
#include "vfh_astar/ros/lockstep.h"
#include "vfh_astar/ros/message_error.h"
#include "vfh_astar/ros/motion_messages.h"
#include "vfh_astar/ros/navigation_display.h"
#include "vfh_astar/ros/navigation_messages.h"
#include "vfh_astar/ros/reconfiguration.h"
#include "vfh_astar/ros/robot_inputs.h"
#include "vfh_astar/ros/ros_parameter_reader.h"

namespace vfh_astar {
namespace {

// By how much clocks may step back without it being another time.
const ros::Duration kClockTolerance(1.0);

struct NavigatorNodeletParameters {
  NavigatorParameters navigator;
  FrameNames frames;
  double control_frequency = 20.0;  ///< Hz, of the cycle while no scan comes;
                                    ///< else every scan brings one.
  bool lockstep = false;            ///< with a simulator that is, see Lockstep.

  void Read(ParameterReader& reader) {
    navigator.Read(reader);
    frames.Read(reader);
    reader.Number("control_frequency", control_frequency, 1.0, 200.0);
    reader.Flag("lockstep", lockstep);
  }
};

}  // namespace

/// Goals, scans, odometry and trajectories in; cmd_vel out. One cycle for every
/// scan. All callbacks run in one thread.
class NavigatorNodelet : public nodelet::Nodelet {
 public:
  ~NavigatorNodelet() override {
    // Nobody else stops a robot whose navigation is unloaded while it drives.
    if (is_moving_) command_publisher_.publish(geometry_msgs::Twist());
  }

 private:
  void onInit() override {
    parameters_ =
        ReadParameters<NavigatorNodeletParameters>(getPrivateNodeHandle());
    period_ = ros::Duration(1.0 / parameters_.control_frequency);
    navigator_ = std::make_unique<Navigator>(parameters_.navigator);
    lockstep_ = std::make_unique<Lockstep>(parameters_.lockstep);
    Advertise();
    ros::NodeHandle& node = getNodeHandle();
    inputs_ = std::make_unique<RobotInputs>(
        node, parameters_.frames, parameters_.navigator.occupied_threshold);
    monitor_ = std::make_unique<CycleMonitor>(
        node, getPrivateNodeHandle(), getName(), period_.toSec(), *inputs_);
    ServeReconfiguration();
    // From here on callbacks come, in another thread than this one.
    Listen();
  }

  void Advertise() {
    ros::NodeHandle& node = getNodeHandle();
    command_publisher_ = node.advertise<geometry_msgs::Twist>("cmd_vel", 1);
    query_publisher_ = node.advertise<MotionQuery>("plan_request", 10);
    state_publisher_ = node.advertise<NavigationState>("navigation_state", 10);
    display_ = std::make_unique<NavigationDisplay>(node, parameters_.frames);
  }

  void Listen() {
    ros::NodeHandle& node = getNodeHandle();
    goals_ = std::make_unique<GoalServer>(
        node, inputs_->transforms(), parameters_.frames.map_frame,
        [this](const std::string& goal_id, const Pose2D& goal) {
          navigator_->SetGoal(goal_id, goal);
        },
        [this] { navigator_->Cancel(); });
    pause_service_ =
        node.advertiseService("pause", &NavigatorNodelet::OnPause, this);
    resume_service_ =
        node.advertiseService("resume", &NavigatorNodelet::OnResume, this);
    trajectory_subscriber_ = node.subscribe<QuinticTrajectory>(
        "trajectory", 10, [this](const QuinticTrajectoryConstPtr& message) {
          OnTrajectory(*message);
        });
    failure_subscriber_ = node.subscribe<MotionFailure>(
        "plan_failure", 10, [this](const MotionFailureConstPtr& message) {
          const MotionAnswer answer = ToAnswer(*message);
          navigator_->PlanFailed(answer.id, answer.outcome, answer.message);
          PublishState(lockstep_->TakeAnswer(answer.id));
        });
    cancel_subscriber_ = node.subscribe<std_msgs::Empty>(
        "cancel", 1,
        [this](const std_msgs::EmptyConstPtr&) { navigator_->Cancel(); });
    inputs_->Listen(
        node,
        [this] {
          if (lockstep_->TakeScan(inputs_->scan_stamp())) Cycle();
        },
        [this] {
          const ros::Time stamp(*inputs_->odometry_stamp());
          if (lockstep_->TakeOdometry(stamp)) Cycle();
        },
        [this](const ros::Time& stamp) {
          if (lockstep_->TakeMapped(stamp)) Cycle();
        });
    timer_ = node.createTimer(period_, [this](const ros::TimerEvent&) {
      // Scans that keep away must not keep the watchdogs from running. The
      // clock may have lagged behind the scan of the last cycle.
      const ros::Time last = std::max(last_now_, last_scan_);
      if (ros::Time::now() - last >= period_ || IsTimeReset()) Cycle();
    });
  }

  void ServeReconfiguration() {
    NavigatorParameters& values = parameters_.navigator;
    const auto group = [this](const std::string& name) {
      return ros::NodeHandle(getPrivateNodeHandle(), name);
    };
    limits_ = std::make_unique<Reconfiguration<LimitsConfig>>(
        group("limits"), ToConfig(values.limits),
        [this, &values](const LimitsConfig& config) {
          Apply(config, values.limits);
          navigator_->SetParameters(values);
        });
    goal_ = std::make_unique<Reconfiguration<GoalConfig>>(
        group("goal"), ToConfig(values.goal),
        [this, &values](const GoalConfig& config) {
          Apply(config, values.goal);
          navigator_->SetParameters(values);
        });
    safety_ = std::make_unique<Reconfiguration<SafetyConfig>>(
        group("safety"), ToConfig(values.safety),
        [this, &values](const SafetyConfig& config) {
          Apply(config, values.safety);
          navigator_->SetParameters(values);
        });
  }

  void OnTrajectory(const QuinticTrajectory& message) {
    try {
      CheckFrame(message.header.frame_id, parameters_.frames.map_frame);
      const MotionRequestId id{static_cast<int>(message.request_id),
                               message.goal_id};
      navigator_->SetTrajectory(id, ToTrajectory(message));
      PublishState(lockstep_->TakeAnswer(id));
    } catch (const MessageError& error) {
      NODELET_WARN_THROTTLE(10.0, "a trajectory is dropped: %s", error.what());
    }
  }

  bool OnPause(std_srvs::Empty::Request&, std_srvs::Empty::Response&) {
    navigator_->Pause();
    return true;
  }

  bool OnResume(std_srvs::Empty::Request&, std_srvs::Empty::Response&) {
    navigator_->Resume();
    return true;
  }

  /// True when the clock, or the laser's, is behind where it was.
  bool IsTimeReset() const {
    return ros::Time::now() + kClockTolerance < last_now_ ||
           inputs_->scan_stamp() + kClockTolerance < last_scan_;
  }

  void Cycle() {
    if (IsTimeReset()) BeginAnew();
    last_now_ = ros::Time::now();
    last_scan_ = inputs_->scan_stamp();
    // The clock's message may come after the scan of that moment.
    const ros::Time time = std::max({last_now_, last_scan_, last_cycle_});
    if (time.isZero()) return;
    last_cycle_ = time;
    monitor_->Count(time);
    const NavigatorInput input = inputs_->At(time);
    const NavigatorOutput output = navigator_->Update(input);
    Act(output);
    ReportPose(input, time);
    AnswerScan(output);
    display_->Show(output, parameters_.navigator, time);
  }

  void AnswerScan(const NavigatorOutput& output) {
    std_msgs::Header header;
    header.stamp = last_cycle_;
    header.frame_id = parameters_.frames.map_frame;
    std::optional<MotionRequestId> question;
    if (output.request) question = output.request->id;
    NavigationState state =
        ToStateMessage(output.status, header, inputs_->scan_stamp());
    state.commanded = output.command.has_value();
    PublishState(lockstep_->TakeState(state, question));
  }

  void PublishState(const std::optional<NavigationState>& state) {
    if (state) state_publisher_.publish(*state);
  }

  /// A simulation was reset: what was going on belongs to a time that is to
  /// come again.
  void BeginAnew() {
    NODELET_WARN("time went back: navigation begins anew");
    if (is_moving_) command_publisher_.publish(geometry_msgs::Twist());
    inputs_->ForgetAfter(std::min(ros::Time::now(), inputs_->scan_stamp()) +
                         kClockTolerance);
    goals_->Abort("time went back");
    navigator_ = std::make_unique<Navigator>(parameters_.navigator);
    last_cycle_ = ros::Time();
    is_moving_ = false;
    lockstep_->Reset();
  }

  void Act(const NavigatorOutput& output) {
    if (output.command) {
      command_publisher_.publish(ToTwistMessage(*output.command));
      is_moving_ = output.command->v != 0.0 || output.command->w != 0.0;
    }
    if (output.request) {
      // A stamp of its own for every question, also within one tick of a clock.
      query_stamp_ = std::max(last_cycle_, query_stamp_ + ros::Duration(0, 1));
      query_publisher_.publish(ToQueryMessage(*output.request, query_stamp_,
                                              parameters_.frames.map_frame));
    }
    if (output.result) goals_->Finish(*output.result);
  }

  void ReportPose(const NavigatorInput& input, const ros::Time& time) {
    if (!input.map_from_odom || !input.odometry_stamp) return;
    geometry_msgs::PoseStamped pose;
    pose.header.stamp = time;
    pose.header.frame_id = parameters_.frames.map_frame;
    pose.pose = ToPoseMessage(*input.map_from_odom * input.odom_from_base);
    goals_->Report(pose);
  }

  NavigatorNodeletParameters parameters_;
  ros::Duration period_;
  std::unique_ptr<Navigator> navigator_;
  std::unique_ptr<Lockstep> lockstep_;
  ros::Time last_cycle_;
  ros::Time last_now_;   ///< the clock at the last cycle.
  ros::Time last_scan_;  ///< the newest scan's stamp at the last cycle.
  ros::Time query_stamp_;
  bool is_moving_ = false;  ///< by the last command.

  ros::Publisher command_publisher_;
  ros::Publisher query_publisher_;
  ros::Publisher state_publisher_;
  std::unique_ptr<NavigationDisplay> display_;
  std::unique_ptr<RobotInputs> inputs_;
  std::unique_ptr<CycleMonitor> monitor_;
  std::unique_ptr<GoalServer> goals_;
  std::unique_ptr<Reconfiguration<LimitsConfig>> limits_;
  std::unique_ptr<Reconfiguration<GoalConfig>> goal_;
  std::unique_ptr<Reconfiguration<SafetyConfig>> safety_;
  ros::ServiceServer pause_service_;
  ros::ServiceServer resume_service_;
  ros::Subscriber trajectory_subscriber_;
  ros::Subscriber failure_subscriber_;
  ros::Subscriber cancel_subscriber_;
  ros::Timer timer_;
};

}  // namespace vfh_astar

PLUGINLIB_EXPORT_CLASS(vfh_astar::NavigatorNodelet, nodelet::Nodelet)
