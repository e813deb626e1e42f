#ifndef VFH_ASTAR_TRAJECTORY_POLYLINE_H_
#define VFH_ASTAR_TRAJECTORY_POLYLINE_H_

#include <Eigen/Core>
#include <vector>

#include "vfh_astar/geometry.h"

namespace vfh_astar {

/// Points joined by straight lines, m.
using Polyline = std::vector<Eigen::Vector2d>;

/// m
double Length(const Polyline& line);

/// rad, of the first and of the last part of a line of at least two points.
double FirstDirection(const Polyline& line);
double LastDirection(const Polyline& line);

/// Points along a line at equal distances, `count` of them (2 or more), with
/// both ends.
Polyline Resample(const Polyline& line, int count);

/// The part of a line up to `length` metres, and the part from there on; both
/// have the point between them.
struct SplitLine {
  Polyline before;
  Polyline after;
};
SplitLine SplitAt(const Polyline& line, double length);

/// m along a line to that of its points which is nearest to `point`.
double NearestPlace(const Polyline& line, const Eigen::Vector2d& point);

/// `from` and the path from its point nearest to it on.
Polyline PathFrom(const Eigen::Vector2d& from, const Polyline& path);

/// The path up to its point nearest to `to`, and `to`.
Polyline PathTo(const Eigen::Vector2d& to, const Polyline& path);

/// An arc as a robot drives it, or a clothoid: its curvature changes in
/// proportion to the length.
struct ArcShape {
  double length = 0.0;     ///< m
  double curvature = 0.0;  ///< 1/m at the start: rad that the robot turns to
                           ///< the left in a metre, forward or in reverse.
  double end_curvature = 0.0;  ///< 1/m
  bool reverse = false;        ///< the robot's tail is ahead.

  /// rad, from start to end.
  double turn() const { return 0.5 * (curvature + end_curvature) * length; }
};

/// Points along an arc from a robot's pose on.
Polyline Points(const ArcShape& arc, const Pose2D& from);

}  // namespace vfh_astar

#endif  // VFH_ASTAR_TRAJECTORY_POLYLINE_H_
