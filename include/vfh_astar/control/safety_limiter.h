#ifndef VFH_ASTAR_CONTROL_SAFETY_LIMITER_H_
#define VFH_ASTAR_CONTROL_SAFETY_LIMITER_H_

#include <Eigen/Core>
#include <vector>

#include "vfh_astar/footprint.h"
#include "vfh_astar/geometry.h"
#include "vfh_astar/parameters.h"
#include "vfh_astar/tracking/moving_obstacle.h"

namespace vfh_astar {

struct SafetyLimiterParameters {
  double margin = 0.03;        ///< m kept around the footprint.
  double reaction_time = 0.1;  ///< s from a scan until a command acts on it.
  double deceleration = 2.5;   ///< m/s^2 the robot brakes with for certain.
  double angular_deceleration = 8.0;  ///< rad/s^2
  double scan_timeout = 0.25;         ///< s; older scans stop the robot.
  double swerve = 0.3;    ///< of its speed, by which a moving obstacle may have
                          ///< left its straight way.
  double surprise = 1.0;  ///< of its speed, with which it may come at the robot
                          ///< from now on, and
  double hard_deceleration = 5.0;  ///< m/s^2 the robot then brakes with.

  void Read(ParameterReader& reader);
};

struct LimitedCommand {
  Twist2D command;
  bool limited = false;  ///< the command was changed.
};

/// The last stage before cmd_vel: passes on only commands from which the robot
/// can stop before its footprint, grown by the margin, reaches a hit of the
/// latest scan.
///
/// The motion that is checked is the command held for reaction_time, then
/// braking along the same arc to rest; sweeping it is sweeping the arc of the
/// command for reaction_time plus half the braking time. A command that fails
/// is scaled down along its arc, and where that leaves no way forward the robot
/// may still turn on the spot. A point that lies within the margin already
/// forbids only what brings it nearer, so that the robot can leave.
///
/// Things that move are discs on straight ways, growing with time by `swerve`
/// of their speed. The same motion, now in time, must not bring the footprint
/// nearer to one than the margin, or than it would come to a robot that stands,
/// and must not touch one before the robot has come to rest. Nor must one that
/// turns around now reach the robot before it stands when it brakes hard.
class SafetyLimiter {
 public:
  SafetyLimiter(const SafetyLimiterParameters& parameters,
                const Footprint& footprint);

  /// @param[in] command wanted.
  /// @param[in] twist measured. When braking from it at once would not do, the
  ///   answer is to stop, whatever was wanted; so it is when either is not
  ///   finite.
  /// @param[in] obstacles points in the robot's frame now, m.
  /// @param[in] movers in the robot's frame now.
  LimitedCommand Limit(const Twist2D& command, const Twist2D& twist,
                       const std::vector<Eigen::Vector2d>& obstacles,
                       const std::vector<MovingObstacle>& movers = {}) const;

  /// True when the robot, driving `command` for `hold` seconds and braking
  /// then, keeps clear.
  bool CanStop(const Twist2D& command, double hold,
               const std::vector<Eigen::Vector2d>& obstacles) const;

  /// The same against things that move.
  bool CanStopBefore(const Twist2D& command, double hold,
                     const std::vector<MovingObstacle>& movers) const;

  /// m from the robot beyond which nothing that stands limits a command, or
  /// calls for a stop, at speeds of up to those of `fastest` (both positive)
  /// either way.
  double Reach(const Twist2D& fastest) const;

  /// The motion that is checked for a command: where the robot is, in its frame
  /// now, from the present pose until it stands, in steps of 0.1 m (of any
  /// point of the footprint) at most. The zone that must be free is the
  /// footprint, grown by the margin, at all of them.
  std::vector<Pose2D> StoppingMotion(const Twist2D& command) const;

  /// True for a command that passes both for the reaction time.
  bool IsSafe(const Twist2D& command,
              const std::vector<Eigen::Vector2d>& obstacles,
              const std::vector<MovingObstacle>& movers) const;

 private:
  /// s for which the command's arc is driven when it is held for `hold` s.
  double ArcTime(const Twist2D& command, double hold) const;
  bool IsReadyForTurn(const Twist2D& command, double hold,
                      const MovingObstacle& mover) const;
  Twist2D ScaleDown(const Twist2D& command,
                    const std::vector<Eigen::Vector2d>& obstacles,
                    const std::vector<MovingObstacle>& movers) const;

  SafetyLimiterParameters parameters_;
  Footprint footprint_;
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_CONTROL_SAFETY_LIMITER_H_
