#ifndef VFH_ASTAR_NAVIGATION_NAVIGATOR_PARAMETERS_H_
#define VFH_ASTAR_NAVIGATION_NAVIGATOR_PARAMETERS_H_

#include <string>

#include "vfh_astar/control/evasion.h"
#include "vfh_astar/control/safety_limiter.h"
#include "vfh_astar/control/tracking_law.h"
#include "vfh_astar/control/vfh.h"
#include "vfh_astar/footprint.h"
#include "vfh_astar/parameters.h"
#include "vfh_astar/robot_limits.h"
#include "vfh_astar/tracking/obstacle_tracker.h"

namespace vfh_astar {

struct GoalParameters {
  double tolerance = 0.5;          ///< m by which a blocked goal may be moved;
                                   ///< 0 is strict.
  double xy_goal_tolerance = 0.1;  ///< m
  double yaw_goal_tolerance = 0.03;  ///< rad
  double stopped_v = 0.02;           ///< m/s below which the robot stands,
  double stopped_w = 0.05;           ///< rad/s likewise.
  double settle_time = 1.5;  ///< s after the trajectory's end until a new one
                             ///< is asked for, when the goal is not reached.
  double patience = 3.0;     ///< s for which a failure that may pass (no path,
                             ///< goal blocked) is asked about again.

  void Read(ParameterReader& reader);
};

struct ReplanParameters {
  double max_error = 0.3;  ///< m of tracking error that asks for a replan.
  double max_heading_error = 0.8;  ///< rad likewise.
  double blocked_time = 0.1;       ///< s the trajectory must stay blocked.
  double horizon = 6.0;            ///< s of the trajectory that are watched.
  double margin = 0.0;   ///< m around the footprint that must be free.
  double period = 0.25;  ///< s between two requests at least.
  double timeout = 2.0;  ///< s to wait for an answer.
  double latency = 0.1;  ///< s ahead at which a new trajectory starts.
  double lag = 0.15;     ///< m behind the reference from which on the reference
                         ///< waits for the robot; it stands still at max_error.
                         ///< 0: it never waits (the paper).

  void Read(ParameterReader& reader);
};

struct AvoidanceParameters {
  std::string rule = "time_to_collision";  ///< or distance, the paper's rule.
  double enter_time = 0.8;      ///< s to collision below which VFH takes over.
  double leave_time = 1.6;      ///< s to collision above which it gives back.
  double enter_distance = 0.5;  ///< m, for the rule `distance`.
  double leave_distance = 0.7;  ///< m
  double min_time = 0.3;        ///< s that VFH keeps the robot at least.
  double blocked_time = 0.1;    ///< s of avoiding until a plan is asked for.

  void Read(ParameterReader& reader);
};

struct RecoveryParameters {
  double stuck_time = 2.0;        ///< s without progress.
  double stuck_distance = 0.1;    ///< m that count as progress.
  double stuck_angle = 0.3;       ///< rad that count as progress.
  double back_up_distance = 0.4;  ///< m
  double speed = 0.2;             ///< m/s
  double turn_speed = 0.8;        ///< rad/s
  double max_time = 4.0;          ///< s for one manoeuvre.
  int max_attempts = 6;           ///< per goal, without progress in between.

  void Read(ParameterReader& reader);
};

struct OscillationParameters {
  double time = 10.0;     ///< s of moving, not counting evasion of what moves,
                          ///< within
  double distance = 0.5;  ///< m of one place that are oscillation; time 0: no
                          ///< motion is.

  void Read(ParameterReader& reader);
};

struct WatchdogParameters {
  double odometry_timeout = 0.25;  ///< s; older odometry stops the robot.
  double transform_timeout = 1.0;  ///< s; an older transform from map to odom
                                   ///< stops it too; a static one has no age.
  double fault_patience = 3.0;     ///< s without scan, odometry or transform
                                   ///< after which the goal is given up.

  void Read(ParameterReader& reader);
};

struct NavigatorParameters {
  Footprint footprint;
  RobotLimits limits = RobotLimits::ForCommands();
  int occupied_threshold = 65;    ///< percent.
  double actuation_delay = 0.05;  ///< s from a command until the robot obeys.
  TrackingParameters tracking;
  VfhParameters vfh;
  TrackerParameters movers;
  EvasionParameters evasion;
  SafetyLimiterParameters safety;
  GoalParameters goal;
  ReplanParameters replan;
  AvoidanceParameters avoidance;
  RecoveryParameters recovery;
  OscillationParameters oscillation;
  WatchdogParameters watchdog;

  void Read(ParameterReader& reader);
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_NAVIGATION_NAVIGATOR_PARAMETERS_H_
