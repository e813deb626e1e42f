#ifndef VFH_ASTAR_TRAJECTORY_PIECEWISE_FIT_H_
#define VFH_ASTAR_TRAJECTORY_PIECEWISE_FIT_H_

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "vfh_astar/grid/clearance.h"
#include "vfh_astar/trajectory/arrival_finder.h"
#include "vfh_astar/trajectory/leg_search.h"
#include "vfh_astar/trajectory/manoeuvre.h"
#include "vfh_astar/trajectory/polyline.h"
#include "vfh_astar/trajectory/pose_check.h"
#include "vfh_astar/trajectory/trajectory.h"
#include "vfh_astar/trajectory/trajectory_fitter.h"

namespace vfh_astar {

/// The path with the exact places of start and goal at its ends, and without
/// repeated points.
Polyline CleanPath(const FitRequest& request);

/// One request's way to a trajectory of the fit `piecewise`: a manoeuvre that
/// is free, found for the motion that the robot is in, and timed.
class PiecewiseFit {
 public:
  /// Keeps references to all three.
  PiecewiseFit(const TrajectoryFitterParameters& parameters,
               const FitRequest& request, const ClearanceMap& clearance);

  FitResult Run();

 private:
  FitResult FromRest();
  std::optional<FitResult> Join();
  FitResult StopFirst();
  std::optional<Leg> StoppingLeg(double reserve, double end_curvature);
  std::optional<Manoeuvre> FromStop(const Leg& leg);
  std::optional<Manoeuvre> Complete(const Departure& departure,
                                    const Polyline& path);
  FitResult Time(const Manoeuvre& manoeuvre);
  std::vector<TrajectoryPiece> Time(const std::variant<Leg, Turn>& stage,
                                    bool is_first);
  TrajectoryPiece Stand() const;
  FitResult Blocked() const;

  const TrajectoryFitterParameters& parameters_;
  const FitRequest& request_;
  PoseCheck check_;
  LegSearch search_;
  ArrivalFinder finder_;
  Polyline path_;
  bool has_heading_ = true;   ///< of the manoeuvre found last.
  bool keeps_limits_ = true;  ///< of the motion timed last.
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_TRAJECTORY_PIECEWISE_FIT_H_
