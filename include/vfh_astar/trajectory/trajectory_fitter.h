#ifndef VFH_ASTAR_TRAJECTORY_TRAJECTORY_FITTER_H_
#define VFH_ASTAR_TRAJECTORY_TRAJECTORY_FITTER_H_

#include <Eigen/Core>
#include <string>
#include <vector>

#include "vfh_astar/footprint.h"
#include "vfh_astar/geometry.h"
#include "vfh_astar/grid/clearance.h"
#include "vfh_astar/outcome.h"
#include "vfh_astar/parameters.h"
#include "vfh_astar/robot_limits.h"
#include "vfh_astar/trajectory/first_collision.h"  // IWYU pragma: export
#include "vfh_astar/trajectory/trajectory.h"

namespace vfh_astar {

struct TrajectoryFitterParameters {
  std::string fit = "piecewise";  ///< piecewise, or quintic (the paper's single
                                  ///< one, which may cut corners).
  Footprint footprint;
  RobotLimits limits;
  int occupied_threshold = 65;  ///< percent, of the clearance map given to Fit.
  double safety_margin = 0.02;  ///< m kept between footprint and obstacle.
  double time_per_metre = 1.0;  ///< s/m, the paper's T in t_f = T * range; for
                                ///< `quintic`.
  double clearance_slow = 0.1;  ///< m between footprint and obstacle at which
                                ///< max_v_near is allowed.
  double clearance_fast = 0.6;  ///< m from which on max_v is allowed.
  double max_v_near = 0.8;      ///< m/s
  double turn_threshold = 0.6;  ///< rad by which start or goal heading must be
                                ///< off the path for a turn on the spot.

  void Read(ParameterReader& reader);

  /// m; more of clearance changes neither a fit nor its speeds.
  double ClearanceReach() const {
    return clearance_fast + footprint.CircumscribedRadius();
  }
};

struct FitRequest {
  std::vector<Eigen::Vector2d> path;  ///< map frame, at least one point; from
                                      ///< the start's cell to the goal.
  Reference start;  ///< what the trajectory joins in position, velocity and
                    ///< curvature; at rest when its twist is 0.
  Pose2D goal;      ///< map frame; the heading is reached at the end.
};

struct FitResult {
  Outcome outcome = Outcome::kSuccess;  ///< or kNoTrajectory.
  std::string message;                  ///< on failure: where, and why.
  Trajectory trajectory;                ///< empty on failure.
};

/// Fits a trajectory to a path.
class TrajectoryFitter {
 public:
  explicit TrajectoryFitter(const TrajectoryFitterParameters& parameters);

  /// @param[in] clearance of the map the path was planned on.
  /// @return with fit `piecewise`: a trajectory whose footprint, swept along
  /// it,
  ///   is free of occupied cells and which keeps every limit; else
  ///   kNoTrajectory. With `quintic`: the paper's fit, unchecked.
  FitResult Fit(const FitRequest& request, const ClearanceMap& clearance) const;

 private:
  TrajectoryFitterParameters parameters_;
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_TRAJECTORY_TRAJECTORY_FITTER_H_
