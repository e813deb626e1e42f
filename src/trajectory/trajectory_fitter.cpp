#include "vfh_astar/trajectory/trajectory_fitter.h"

#include <cassert>

#include "vfh_astar/trajectory/paper_fit.h"
#include "vfh_astar/trajectory/piecewise_fit.h"
#include "vfh_astar/trajectory/polyline.h"

namespace vfh_astar {

void TrajectoryFitterParameters::Read(ParameterReader& reader) {
  reader.Choice("fit", fit, {"piecewise", "quintic"});
  reader.Group("footprint", footprint);
  reader.Group("limits", limits);
  reader.Integer("occupied_threshold", occupied_threshold, 1, 100);
  reader.Number("safety_margin", safety_margin, 0.0, 1.0);
  reader.Number("time_per_metre", time_per_metre, 0.05, 100.0);
  reader.Number("clearance_slow", clearance_slow, 0.0, 5.0);
  reader.Number("clearance_fast", clearance_fast, 0.0, 5.0);
  reader.Number("max_v_near", max_v_near, 0.05, 20.0);
  reader.Number("turn_threshold", turn_threshold, 0.0, kPi);
  if (clearance_fast < clearance_slow) {
    throw ParameterError("clearance_fast is " + std::to_string(clearance_fast) +
                         ", expected at least clearance_slow (" +
                         std::to_string(clearance_slow) + ")");
  }
}

TrajectoryFitter::TrajectoryFitter(const TrajectoryFitterParameters& parameters)
    : parameters_(parameters) {}

FitResult TrajectoryFitter::Fit(const FitRequest& request,
                                const ClearanceMap& clearance) const {
  assert(!request.path.empty());
  const Polyline path = CleanPath(request);
  // A quintic over no length has no time; a turn at the goal is all there is.
  if (parameters_.fit == "piecewise" ||
      Length(path) <= ArrivalFinder::kArrived) {
    return PiecewiseFit(parameters_, request, clearance).Run();
  }
  FitResult result;
  const Eigen::Vector2d velocity =
      request.start.twist.v * request.start.pose.heading();
  result.trajectory =
      FitSingleQuintic(path, velocity, parameters_.time_per_metre);
  return result;
}

}  // namespace vfh_astar
