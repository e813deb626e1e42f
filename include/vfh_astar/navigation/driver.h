#ifndef VFH_ASTAR_NAVIGATION_DRIVER_H_
#define VFH_ASTAR_NAVIGATION_DRIVER_H_

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "vfh_astar/control/evasion.h"
#include "vfh_astar/control/safety_limiter.h"
#include "vfh_astar/control/vfh.h"
#include "vfh_astar/geometry.h"
#include "vfh_astar/navigation/navigator_parameters.h"
#include "vfh_astar/navigation/observation.h"
#include "vfh_astar/navigation/trajectory_follower.h"

namespace vfh_astar {

/// Turns what the state machine has decided into commands: tracking, avoiding,
/// and on every one of them the limits on speed and acceleration and the safety
/// limiter, in this order.
class Driver {
 public:
  /// @param[in] parameters kept by reference: changes count at once, but for
  ///   those of the sub-components, which need ParametersChanged.
  explicit Driver(const NavigatorParameters& parameters);

  void ParametersChanged();

  TrajectoryFollower& follower() { return follower_; }
  const TrajectoryFollower& follower() const { return follower_; }

  /// The error against the reference now.
  Eigen::Vector3d Error(const Observation& observation) const;

  /// Moves the reference on by `duration` seconds and follows it. While the
  /// robot lags behind, the reference slows down with it.
  /// @param[in] hold_position at the end of the trajectory: only turn.
  Twist2D Track(const Observation& observation, double duration,
                bool hold_position);

  /// Follows VFH towards the reference. Unless the reference runs in time
  /// regardless (lag 0), it waits where the robot is nearest.
  Twist2D Avoid(const Observation& observation, double duration);

  /// Finds a way between what moves, towards the reference, which waits
  /// likewise.
  Twist2D Evade(const Observation& observation, double duration);

  /// True when something that moves would come as near to the robot, if that
  /// stood, as evasion does not let it.
  bool IsMoverComing(const Observation& observation) const;

  /// Out of the way of what moves, and no farther; without a trajectory.
  Twist2D Yield(const Observation& observation, double duration);

  /// Begins anew with avoiding.
  void ResetAvoidance() {
    vfh_.Reset();
    evasion_.Reset();
  }

  /// What VFH saw when it was last asked.
  const VfhResult& avoidance() const { return avoidance_; }

  /// Takes a wanted command through the limits and the safety limiter; what
  /// comes out is what is sent.
  LimitedCommand Limit(const Twist2D& wanted, const Observation& observation,
                       double duration);

  /// Notes that the robot is being told to stand still.
  void Stopped() { previous_ = Twist2D(); }

  /// What was last sent.
  const Twist2D& previous() const { return previous_; }

 private:
  double ReferenceRate(double lag) const;
  /// The search's command on the way to `target` (m, robot frame).
  Twist2D EvadeTowards(const Eigen::Vector2d& target,
                       const Observation& observation, double duration);
  /// Within the limits on speed and acceleration.
  Twist2D Shape(const Twist2D& wanted, double duration) const;
  /// The hits that may be in the way of what the robot can do next.
  std::vector<Eigen::Vector2d> HitsWithinReach(
      const Observation& observation) const;
  void LetReferenceWait(const Observation& observation, double duration);
  /// The point of the trajectory that is `distance` m away from the robot, in
  /// its frame.
  Eigen::Vector2d Target(const Observation& observation, double distance) const;

  const NavigatorParameters& parameters_;
  TrajectoryFollower follower_;
  Vfh vfh_;
  Evasion evasion_;
  SafetyLimiter limiter_;
  VfhResult avoidance_;
  Twist2D previous_;
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_NAVIGATION_DRIVER_H_
