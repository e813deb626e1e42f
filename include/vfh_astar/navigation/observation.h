#ifndef VFH_ASTAR_NAVIGATION_OBSERVATION_H_
#define VFH_ASTAR_NAVIGATION_OBSERVATION_H_

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "vfh_astar/geometry.h"
#include "vfh_astar/grid/clearance.h"
#include "vfh_astar/laser_scan.h"
#include "vfh_astar/navigation/navigator_parameters.h"
#include "vfh_astar/outcome.h"
#include "vfh_astar/tracking/obstacle_tracker.h"

namespace vfh_astar {

/// What the navigator is given in one cycle. All stamps on one clock, s.
struct NavigatorInput {
  double time = 0.0;  ///< now.

  std::optional<Pose2D> map_from_odom;        ///< nothing while tf lacks it.
  std::optional<double> map_from_odom_stamp;  ///< until when it is known to
                                              ///< hold; nothing: for ever.
  bool is_lost = false;                  ///< nobody knows where in the map.
  std::optional<double> odometry_stamp;  ///< nothing before the first message.
  Pose2D odom_from_base;                 ///< at odometry_stamp.
  Twist2D twist;                         ///< at odometry_stamp.

  const LaserScan* scan = nullptr;  ///< the newest, without defect; null before
                                    ///< the first.
  Pose2D base_from_laser;
  std::string scan_defect;  ///< why newer scans could not be used, if any came.

  const ClearanceMap* map = nullptr;  ///< null before the first.
};

/// An input that is missing or too old to drive by.
struct Fault {
  Outcome outcome;
  std::string message;
};

/// The inputs brought to one time and one frame.
struct Observation {
  double time = 0.0;           ///< s
  std::optional<Fault> fault;  ///< when set, nothing below is fit to drive by.
  Pose2D pose;                 ///< map frame, predicted to `time`; (0, 0, 0)
                               ///< while odometry or transform are missing.
  Twist2D twist;               ///< measured.
  std::vector<Eigen::Vector2d> obstacles;   ///< hits of the scan in the robot's
                                            ///< frame at `time`, m, without
  std::vector<Eigen::Vector2d> mover_hits;  ///< those on what moves.
  std::vector<MovingObstacle> movers;       ///< in the same frame, at `time`.
  const ClearanceMap* map = nullptr;        ///< may be null.
};

/// Predicts the pose to the cycle's time with the measured twist, moves the
/// scan's hits to where they lie now, and says what is missing or too old.
/// @param[in] tracker has been given all scans up to the input's by
///   TrackObstacles; null: nothing moves.
Observation Observe(const NavigatorInput& input,
                    const NavigatorParameters& parameters,
                    const ObstacleTracker* tracker = nullptr);

/// Gives the tracker the input's scan, placed by odometry; without one of the
/// two nothing happens.
void TrackObstacles(const NavigatorInput& input, ObstacleTracker& tracker);

/// m from the footprint to the nearest obstacle, negative inside; +inf when
/// there is none.
double FootprintClearance(const Footprint& footprint,
                          const std::vector<Eigen::Vector2d>& obstacles);

}  // namespace vfh_astar

#endif  // VFH_ASTAR_NAVIGATION_OBSERVATION_H_
