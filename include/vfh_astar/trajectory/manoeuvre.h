#ifndef VFH_ASTAR_TRAJECTORY_MANOEUVRE_H_
#define VFH_ASTAR_TRAJECTORY_MANOEUVRE_H_

#include <variant>
#include <vector>

#include "vfh_astar/geometry.h"
#include "vfh_astar/trajectory/polyline.h"
#include "vfh_astar/trajectory/spline_curve.h"

namespace vfh_astar {

/// A drive without a stop.
struct Leg {
  std::vector<CurvePoint>
      points;            ///< of its curve, in the direction of travel.
  bool reverse = false;  ///< the robot's tail is ahead.
};

/// A turn on the spot.
struct Turn {
  Pose2D pose;         ///< before it.
  double angle = 0.0;  ///< rad, signed.
};

/// What the robot does, without time: legs and turns in order, each starting
/// where the one before it ends. Between two stages it stands.
using Manoeuvre = std::vector<std::variant<Leg, Turn>>;

/// The pose in which a manoeuvre that is not empty ends.
Pose2D EndOf(const Manoeuvre& manoeuvre);

void Append(Manoeuvre& manoeuvre, const Manoeuvre& more);

/// How a manoeuvre begins.
struct Departure {
  Pose2D pose;
  bool moving = false;     ///< forward; then it has to begin with a drive along
                           ///< the heading,
  double curvature = 0.0;  ///< 1/m, with this curvature,
  Polyline lead;           ///< along these points before it takes to the path.
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_TRAJECTORY_MANOEUVRE_H_
