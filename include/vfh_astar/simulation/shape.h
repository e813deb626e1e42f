#ifndef VFH_ASTAR_SIMULATION_SHAPE_H_
#define VFH_ASTAR_SIMULATION_SHAPE_H_

#include <Eigen/Core>
#include <vector>

#include "vfh_astar/geometry.h"

namespace vfh_astar {

/// A solid seen from above: a disc or a convex polygon. Everything a planar
/// robot can meet is made of these; heights do not matter.
struct Shape {
  Eigen::Vector2d center = Eigen::Vector2d::Zero();  ///< m
  /// m; of the disc, or of a circle about `center` that holds the polygon.
  double radius = 0.0;
  /// m, counter-clockwise; empty for a disc.
  std::vector<Eigen::Vector2d> vertices;

  bool IsDisc() const { return vertices.empty(); }

  /// This shape, given in the frame of `pose`, in the frame `pose` is given in.
  Shape At(const Pose2D& pose) const;
};

/// @param[in] radius m, above 0.
Shape MakeDisc(const Eigen::Vector2d& center, double radius);

/// @param[in] vertices three or more, convex, counter-clockwise.
Shape MakeConvexPolygon(std::vector<Eigen::Vector2d> vertices);

/// @param[in] size m, along the box's own x and y.
Shape MakeBox(const Pose2D& pose, const Eigen::Vector2d& size);

/// Cuts a simple polygon, convex or not and in either sense of rotation, into
/// triangles.
/// @return empty when the outline crosses itself or has no area.
std::vector<Shape> MakePolygon(std::vector<Eigen::Vector2d> outline);

/// A wall of constant thickness along a line through two points or more, with
/// square ends; corners are filled.
/// @param[in] closed joins the last point with the first.
std::vector<Shape> MakeWall(const std::vector<Eigen::Vector2d>& points,
                            double thickness, bool closed);

/// True when the point lies in or on the shape.
bool Contains(const Shape& shape, const Eigen::Vector2d& point);

/// Least distance in metres between two shapes; 0 when they touch or overlap.
double Distance(const Shape& a, const Shape& b);

/// A point in which two shapes touch.
struct ContactPoint {
  Eigen::Vector2d point = Eigen::Vector2d::Zero();   ///< m
  Eigen::Vector2d normal = Eigen::Vector2d::Zero();  ///< unit, from b into a.
  double depth = 0.0;  ///< m that b reaches into a along the normal.
};

/// The points in which two shapes touch: none when they are apart, else one, or
/// two where edges lie on each other. Separating axes, with the incident edge
/// clipped to the reference edge.
/// @param[in] a a polygon.
std::vector<ContactPoint> FindContact(const Shape& a, const Shape& b);

}  // namespace vfh_astar

#endif  // VFH_ASTAR_SIMULATION_SHAPE_H_
