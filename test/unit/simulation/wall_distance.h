#ifndef VFH_ASTAR_TEST_WALL_DISTANCE_H_
#define VFH_ASTAR_TEST_WALL_DISTANCE_H_

#include <algorithm>
#include <cmath>
#include <limits>

#include "vfh_astar/simulation/world.h"

namespace vfh_astar {

/// m from a point to the surface of a shape, from within or without.
inline double SurfaceDistance(const Shape& shape,
                              const Eigen::Vector2d& point) {
  if (shape.IsDisc()) {
    return std::abs((point - shape.center).norm() - shape.radius);
  }
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < shape.vertices.size(); ++i) {
    const Eigen::Vector2d& from = shape.vertices[i];
    const Eigen::Vector2d along =
        shape.vertices[(i + 1) % shape.vertices.size()] - from;
    const double part =
        std::clamp((point - from).dot(along) / along.squaredNorm(), 0.0, 1.0);
    nearest = std::min(nearest, (from + part * along - point).norm());
  }
  return nearest;
}

/// m from a point to the nearest surface of what does not move.
inline double WallDistance(const World& world, const Eigen::Vector2d& point) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const StaticObstacle& obstacle : world.obstacles) {
    for (const Shape& shape : obstacle.shapes) {
      nearest = std::min(nearest, SurfaceDistance(shape, point));
    }
  }
  return nearest;
}

}  // namespace vfh_astar

#endif  // VFH_ASTAR_TEST_WALL_DISTANCE_H_
