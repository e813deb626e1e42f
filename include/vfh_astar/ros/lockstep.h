#ifndef VFH_ASTAR_ROS_LOCKSTEP_H_
#define VFH_ASTAR_ROS_LOCKSTEP_H_

#include <ros/time.h>
#include <vfh_astar/NavigationState.h>

#include <optional>

#include "vfh_astar/navigation/motion_request.h"

namespace vfh_astar {

/// For a simulator that holds its clock until `navigation_state` answers its
/// scan: lets the cycle of a scan run when the newest odometry of that moment
/// and all scans that can be in the map by then have come, and lets a cycle
/// that asks for a trajectory answer only when the trajectory has come. So
/// every cycle sees the same, and mapping and planning take the same simulated
/// time, however slow the machine and whichever message is first.
///
/// Odometry comes, together with its transform, at a steady rate, which is
/// taken from its stamps. A scan can be in the map when there is odometry of
/// its time or later; the clock stands, so that is its own time or never.
///
/// When it is off nothing waits.
class Lockstep {
 public:
  explicit Lockstep(bool is_on) : is_on_(is_on) {}

  /// A scan has come.
  /// @return true when its cycle may run now. A scan that comes while the one
  ///   before it still waits is let through: the simulator has lost patience.
  bool TakeScan(const ros::Time& stamp);

  /// The map has all scans up to `stamp`.
  /// @return true when a cycle has waited for that.
  bool TakeMapped(const ros::Time& stamp);

  /// Odometry has come.
  /// @return true when a cycle has waited for that.
  bool TakeOdometry(const ros::Time& stamp);

  /// A cycle has run.
  /// @param[in] question the id of what it asked, if it did.
  /// @return the state to send now; nothing when it waits for the answer.
  std::optional<NavigationState> TakeState(
      const NavigationState& state, std::optional<MotionRequestId> question);

  /// A question was answered.
  /// @return the state that has waited for that.
  std::optional<NavigationState> TakeAnswer(const MotionRequestId& question);

  /// Time begins anew.
  void Reset();

 private:
  bool IsReady() const;
  bool EndWaiting();

  bool is_on_;
  ros::Time scan_;         ///< the newest,
  ros::Time scan_before_;  ///< and the one before it.
  ros::Time mapped_;
  ros::Time odometry_;             ///< the newest.
  ros::Duration odometry_period_;  ///< 0: not known yet.
  bool is_waiting_ = false;        ///< a cycle is.
  std::optional<MotionRequestId> question_;
  NavigationState held_;  ///< while question_ is set.
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_ROS_LOCKSTEP_H_
