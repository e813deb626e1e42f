#ifndef VFH_ASTAR_FOOTPRINT_H_
#define VFH_ASTAR_FOOTPRINT_H_

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>

#include "vfh_astar/geometry.h"
#include "vfh_astar/parameters.h"

namespace vfh_astar {

/// The robot seen from above: a rectangle about the centre of rotation.
/// Defaults are a Clearpath Jackal with its wheels.
struct Footprint {
  double front = 0.229;       ///< m, from the centre to the front edge.
  double rear = 0.229;        ///< m, from the centre to the rear edge.
  double half_width = 0.208;  ///< m

  double InscribedRadius() const { return std::min({front, rear, half_width}); }
  double CircumscribedRadius() const {
    return std::hypot(std::max(front, rear), half_width);
  }

  Footprint Grown(double margin) const {
    return {front + margin, rear + margin, half_width + margin};
  }

  /// True when a point of the robot's frame lies in or on the rectangle.
  bool Contains(const Eigen::Vector2d& point) const {
    return -rear <= point.x() && point.x() <= front &&
           std::abs(point.y()) <= half_width;
  }

  /// Distance in metres from the rectangle to a point of the robot's frame;
  /// inside it is negative: how deep the point lies.
  double SignedDistance(const Eigen::Vector2d& point) const {
    const double dx = std::max(-rear - point.x(), point.x() - front);
    const double dy = std::abs(point.y()) - half_width;
    if (dx <= 0.0 || dy <= 0.0) return std::max(dx, dy);
    return std::sqrt(dx * dx + dy * dy);
  }

  /// The corners in the robot's frame, counter-clockwise from front left.
  std::array<Eigen::Vector2d, 4> Corners() const {
    return {Eigen::Vector2d(front, half_width),
            Eigen::Vector2d(-rear, half_width),
            Eigen::Vector2d(-rear, -half_width),
            Eigen::Vector2d(front, -half_width)};
  }

  void Read(ParameterReader& reader) {
    reader.Number("front", front, 0.01, 10.0);
    reader.Number("rear", rear, 0.01, 10.0);
    reader.Number("half_width", half_width, 0.01, 10.0);
  }
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_FOOTPRINT_H_
