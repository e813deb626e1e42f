#ifndef VFH_ASTAR_TEST_UNIT_SIMULATION_RAY_DISTANCE_H_
#define VFH_ASTAR_TEST_UNIT_SIMULATION_RAY_DISTANCE_H_

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "vfh_astar/simulation/shape.h"

namespace vfh_astar {

/// Where one ray meets one shape first, the plain way.
/// @param[in] direction a unit vector.
/// @return metres from the origin; 0 when the origin lies inside; infinity
///   when the ray misses.
inline double RayDistance(const Shape& shape, const Eigen::Vector2d& origin,
                          const Eigen::Vector2d& direction) {
  constexpr double kMiss = std::numeric_limits<double>::infinity();
  const auto cross = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return a.x() * b.y() - a.y() * b.x();
  };
  if (shape.IsDisc()) {
    const Eigen::Vector2d to_center = shape.center - origin;
    if (to_center.norm() <= shape.radius) return 0.0;
    const double along = to_center.dot(direction);
    const double aside = cross(to_center, direction);
    const double half_chord_squared =
        shape.radius * shape.radius - aside * aside;
    if (along < 0.0 || half_chord_squared < 0.0) return kMiss;
    return along - std::sqrt(half_chord_squared);
  }
  // The part of the ray that lies inside of every edge.
  double enter = 0.0;
  double leave = kMiss;
  const auto& v = shape.vertices;
  for (std::size_t i = 0; i < v.size(); ++i) {
    const Eigen::Vector2d edge = v[(i + 1) % v.size()] - v[i];
    const double outside = -cross(edge, origin - v[i]);
    const double rate = cross(edge, direction);
    if (rate > 0.0) {
      enter = std::max(enter, outside / rate);
    } else if (rate < 0.0) {
      leave = std::min(leave, outside / rate);
    } else if (outside > 0.0) {
      return kMiss;
    }
  }
  return enter <= leave ? enter : kMiss;
}

/// The same for the first of many shapes within `range`.
inline double RayDistance(const std::vector<Shape>& shapes,
                          const Eigen::Vector2d& origin,
                          const Eigen::Vector2d& direction, double range) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Shape& shape : shapes) {
    nearest = std::min(nearest, RayDistance(shape, origin, direction));
  }
  return nearest <= range ? nearest : std::numeric_limits<double>::infinity();
}

}  // namespace vfh_astar

#endif  // VFH_ASTAR_TEST_UNIT_SIMULATION_RAY_DISTANCE_H_
