#ifndef VFH_ASTAR_TRACKING_MOVING_OBSTACLE_H_
#define VFH_ASTAR_TRACKING_MOVING_OBSTACLE_H_

#include <Eigen/Core>

#include "vfh_astar/geometry.h"

namespace vfh_astar {

/// A disc that moves in a straight line, in some frame.
struct MovingObstacle {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  ///< m, of its centre.
  Eigen::Vector2d velocity =
      Eigen::Vector2d::Zero();  ///< m/s, over the ground.
  double radius = 0.0;          ///< m

  Eigen::Vector2d At(double time) const { return position + time * velocity; }
};

/// The obstacle in frame a.
/// @param[in] a_from_b where frame b, which it is given in, stands in a.
inline MovingObstacle Transform(const Pose2D& a_from_b,
                                const MovingObstacle& obstacle) {
  const Pose2D turn(0.0, 0.0, a_from_b.theta);
  return {a_from_b * obstacle.position, turn * obstacle.velocity,
          obstacle.radius};
}

}  // namespace vfh_astar

#endif  // VFH_ASTAR_TRACKING_MOVING_OBSTACLE_H_
