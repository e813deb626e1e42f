#ifndef VFH_ASTAR_ROS_CYCLE_MONITOR_H_
#define VFH_ASTAR_ROS_CYCLE_MONITOR_H_

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/node_handle.h>

#include <string>

#include "vfh_astar/ros/robot_inputs.h"

namespace vfh_astar {

/// Watches over the control cycle: publishes its health on /diagnostics once a
/// second, and says in one message what is missing a few seconds after the
/// start, and again when all is there. Counts the wall's seconds for that, as a
/// missing /clock is one of the things that can be missing.
class CycleMonitor {
 public:
  /// @param[in] period s between two cycles at the most.
  /// @param[in] inputs has to outlive the monitor.
  CycleMonitor(ros::NodeHandle node, ros::NodeHandle private_node,
               const std::string& name, double period,
               const RobotInputs& inputs);

  /// Takes note of a cycle.
  void Count(const ros::Time& time);

 private:
  void Diagnose(diagnostic_updater::DiagnosticStatusWrapper& status);
  void CheckStart();

  double period_;
  const RobotInputs& inputs_;
  ros::Time last_cycle_;
  ros::Time last_report_;
  int cycles_ = 0;  ///< since the last report.
  int missed_ = 0;  ///< since the last report.

  enum class Start { kWaiting, kIncomplete, kComplete };
  Start start_ = Start::kWaiting;
  int seconds_ = 0;  ///< of the wall's, since the start.

  diagnostic_updater::Updater updater_;
  ros::WallTimer timer_;
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_ROS_CYCLE_MONITOR_H_
