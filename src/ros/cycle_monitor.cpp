#include "vfh_astar/ros/cycle_monitor.h"

#include <ros/console.h>

#include <optional>
#include <vector>

namespace vfh_astar {
namespace {

// s of the wall's in which everything should have come up.
constexpr int kStartSeconds = 3;
// Periods between two cycles that make a missed one.
constexpr double kMissed = 2.0;

}  // namespace

CycleMonitor::CycleMonitor(ros::NodeHandle node, ros::NodeHandle private_node,
                           const std::string& name, double period,
                           const RobotInputs& inputs)
    : period_(period), inputs_(inputs), updater_(node, private_node, name) {
  updater_.setHardwareID("none");
  updater_.add("control cycle", this, &CycleMonitor::Diagnose);
  timer_ = node.createWallTimer(ros::WallDuration(1.0),
                                [this](const ros::WallTimerEvent&) {
                                  ++seconds_;
                                  CheckStart();
                                  updater_.force_update();
                                });
}

void CycleMonitor::Count(const ros::Time& time) {
  ++cycles_;
  const double gap = (time - last_cycle_).toSec();
  if (!last_cycle_.isZero() && gap > kMissed * period_) ++missed_;
  last_cycle_ = time;
}

void CycleMonitor::CheckStart() {
  if (start_ == Start::kComplete || seconds_ < kStartSeconds) return;
  std::vector<std::string> missing = inputs_.Missing();
  if (ros::Time::now().isZero()) {
    missing.insert(missing.begin(),
                   "no time on /clock, and use_sim_time is set");
  }
  if (missing.empty()) {
    ROS_INFO(
        "navigation is ready: scan, odometry, transforms and map are there");
    start_ = Start::kComplete;
  } else if (start_ == Start::kWaiting) {
    std::string list;
    for (const std::string& item : missing) list += "\n  - " + item;
    ROS_WARN("navigation cannot drive yet:%s", list.c_str());
    start_ = Start::kIncomplete;
  }
}

void CycleMonitor::Diagnose(
    diagnostic_updater::DiagnosticStatusWrapper& status) {
  using diagnostic_msgs::DiagnosticStatus;
  const ros::Time now = ros::Time::now();
  const double elapsed = (now - last_report_).toSec();
  const std::vector<std::string> missing = inputs_.Missing();
  if (!missing.empty()) {
    status.summary(DiagnosticStatus::WARN, missing.front());
  } else if (missed_ > 0) {
    status.summary(DiagnosticStatus::WARN, "the control cycle came late");
  } else {
    status.summary(DiagnosticStatus::OK, "the control cycle runs");
  }
  if (!last_report_.isZero() && elapsed > 0.0) {
    status.add("cycle rate [Hz]", cycles_ / elapsed);
  }
  status.add("cycles missed", missed_);
  status.add("scans dropped, unusable", inputs_.unusable_scans());
  if (!inputs_.scan_stamp().isZero()) {
    status.add("scan age [s]", (now - inputs_.scan_stamp()).toSec());
  }
  if (const std::optional<double> age = inputs_.TransformAge(now)) {
    status.add("age of map to odom [s]", *age);
  }
  last_report_ = now;
  cycles_ = 0;
  missed_ = 0;
}

}  // namespace vfh_astar
