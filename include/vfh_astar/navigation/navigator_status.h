#ifndef VFH_ASTAR_NAVIGATION_NAVIGATOR_STATUS_H_
#define VFH_ASTAR_NAVIGATION_NAVIGATOR_STATUS_H_

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "vfh_astar/geometry.h"
#include "vfh_astar/navigation/driver.h"
#include "vfh_astar/navigation/goal_record.h"
#include "vfh_astar/navigation/navigator_parameters.h"
#include "vfh_astar/navigation/observation.h"
#include "vfh_astar/navigation/state_machine.h"
#include "vfh_astar/tracking/moving_obstacle.h"

namespace vfh_astar {

/// What RViz and `navigation_state` show of a cycle.
struct NavigatorStatus {
  State state = State::kIdle;
  std::string reason;  ///< why the robot is in this state, or what holds it up.
  std::string goal_id;
  Eigen::Vector3d error = Eigen::Vector3d::Zero();  ///< e1, e2 (m), e3 (rad).
  double clearance = 0.0;  ///< m from the footprint to the nearest hit of the
                           ///< scan; +inf when there is none, NaN without a
                           ///< scan to go by.
  double speed = 0.0;      ///< m/s, measured.
  double distance_to_goal = 0.0;  ///< m, straight; 0 without goal.
  int replans = 0;                ///< since the goal came in.
  bool limited = false;           ///< the safety limiter changed the command.
  Pose2D pose;                    ///< map frame, at the cycle's time.
  std::optional<Reference> reference;  ///< what is being tracked.
  std::vector<double> vfh_histogram;   ///< polar density by sector, 0 to 1,
                                       ///< counter-clockwise from straight
                                       ///< behind (-pi); empty unless AVOIDING.
  std::vector<bool> vfh_blocked;       ///< as many.
  double vfh_direction = 0.0;          ///< rad, robot frame, chosen.
  std::vector<MovingObstacle> movers;  ///< map frame.
};

/// What can be seen of a cycle from the outside; `limited` is left false.
/// @param[in] reason why the robot is in this state; a fault that holds up a
///   goal goes before it.
/// @param[in] avoiding the command came from avoidance.
NavigatorStatus Describe(State state, const std::string& reason,
                         const GoalRecord& record,
                         const Observation& observation, const Driver& driver,
                         bool avoiding, const NavigatorParameters& parameters);

}  // namespace vfh_astar

#endif  // VFH_ASTAR_NAVIGATION_NAVIGATOR_STATUS_H_
