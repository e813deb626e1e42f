#ifndef VFH_ASTAR_TRAJECTORY_LEG_FITTER_H_
#define VFH_ASTAR_TRAJECTORY_LEG_FITTER_H_

#include <Eigen/Core>
#include <vector>

#include "vfh_astar/trajectory/polyline.h"
#include "vfh_astar/trajectory/pose_check.h"
#include "vfh_astar/trajectory/spline_curve.h"

namespace vfh_astar {

/// A drive without a stop.
struct LegRequest {
  Polyline line;   ///< m, from start to end, longer than 0.
  CurveEnd start;  ///< heading is that of the travel, also in reverse.
  CurveEnd end;
  bool reverse = false;  ///< the robot's tail is ahead.
};

struct LegResult {
  bool free = false;  ///< the footprint fits all along, and no bend is a cusp.
  std::vector<CurvePoint> points;  ///< of the curve, from end to end.
  Eigen::Vector2d blocked_at = Eigen::Vector2d::Zero();  ///< where it does not,
                                                         ///< when not free.
  double effort = 0.0;  ///< m of curves that were fitted on the way.
};

/// Fits a smooth curve to a line.
///
/// Each control point may leave the line by a bubble that the clearance there
/// allows. Where the footprint, swept along the curve, is not free, the bubbles
/// shrink and the curve is fitted again, down to the line itself with its
/// corners rounded over the spacing of the control points.
class LegFitter {
 public:
  /// Keeps a reference to `check`.
  /// @param[in] fast_room m between footprint and obstacle beyond which more
  ///   room makes nothing faster.
  LegFitter(const PoseCheck& check, double fast_room);

  LegResult Fit(const LegRequest& request) const;

 private:
  double BubbleRadius(const Eigen::Vector2d& centre) const;

  const PoseCheck& check_;
  double fast_room_;
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_TRAJECTORY_LEG_FITTER_H_
