#ifndef VFH_ASTAR_TEST_BUILDING_H_
#define VFH_ASTAR_TEST_BUILDING_H_

#include <Eigen/Core>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "vfh_astar/geometry.h"
#include "vfh_astar/laser_scan.h"

namespace vfh_astar {

/// Straight walls, for a laser to look at.
struct Wall {
  Eigen::Vector2d from;
  Eigen::Vector2d to;
};

using Building = std::vector<Wall>;

inline void AddPolygon(const std::vector<Eigen::Vector2d>& corners,
                       Building& building) {
  for (std::size_t i = 0; i < corners.size(); ++i) {
    building.push_back({corners[i], corners[(i + 1) % corners.size()]});
  }
}

/// A room of 6 by 4 m around the origin with a cupboard in a corner.
inline Building Room() {
  Building room;
  AddPolygon({{-3, -2}, {3, -2}, {3, 1.2}, {2.1, 1.2}, {2.1, 2}, {-3, 2}},
             room);
  return room;
}

/// A corridor 2 m wide around a block, 24 by 16 m outside, with niches of many
/// widths. The origin is in its lower left.
inline Building RingCorridor() {
  Building ring;
  AddPolygon({{-1, -1}, {5, -1},  {5, -2},    {6.5, -2},  {6.5, -1},
              {23, -1}, {23, 4},  {24.2, 4},  {24.2, 5},  {23, 5},
              {23, 15}, {14, 15}, {14, 15.7}, {11, 15.7}, {11, 15},
              {-1, 15}, {-1, 9},  {-2, 9},    {-2, 6.2},  {-1, 6.2}},
             ring);
  AddPolygon({{1, 1},
              {1, 13},
              {8, 13},
              {8, 12.2},
              {9, 12.2},
              {9, 13},
              {21, 13},
              {21, 1},
              {17, 1},
              {17, 1.6},
              {15, 1.6},
              {15, 1}},
             ring);
  return ring;
}

inline double Distance(const Building& building, const Eigen::Vector2d& origin,
                       double angle) {
  const Eigen::Vector2d ray(std::cos(angle), std::sin(angle));
  double nearest = std::numeric_limits<double>::infinity();
  for (const Wall& wall : building) {
    const Eigen::Vector2d along = wall.to - wall.from;
    const Eigen::Vector2d gap = wall.from - origin;
    const double cross = ray.x() * along.y() - ray.y() * along.x();
    if (std::abs(cross) < 1e-12) continue;
    const double distance = (gap.x() * along.y() - gap.y() * along.x()) / cross;
    const double part = (gap.x() * ray.y() - gap.y() * ray.x()) / cross;
    if (distance > 0.0 && 0.0 <= part && part <= 1.0) {
      nearest = std::min(nearest, distance);
    }
  }
  return nearest;
}

/// What a laser of 180 beams over 180 degrees sees.
/// @param[in] sigma m, of its noise.
inline LaserScan Look(const Building& building, const Pose2D& pose,
                      double sigma, std::mt19937& random) {
  std::normal_distribution<double> normal;
  LaserScan scan;
  scan.angle_min = -0.5 * kPi;
  scan.angle_increment = kPi / 180.0;
  scan.range_max = 30.0;
  for (int i = 0; i < 180; ++i) {
    scan.ranges.push_back(static_cast<float>(
        Distance(building, pose.position(), pose.theta + scan.Angle(i)) +
        sigma * normal(random)));
  }
  return scan;
}

/// A drive around RingCorridor(), a pose about every 0.5 m or 0.4 rad.
inline std::vector<Pose2D> Laps(int laps) {
  std::vector<Pose2D> poses;
  const std::vector<Eigen::Vector2d> corners = {
      {0, 0}, {22, 0}, {22, 14}, {0, 14}};
  for (int lap = 0; lap < laps; ++lap) {
    for (int side = 0; side < 4; ++side) {
      const Eigen::Vector2d& from = corners[side];
      const Eigen::Vector2d way = corners[(side + 1) % 4] - from;
      const double heading = side * 0.5 * kPi;
      const int steps = static_cast<int>(way.norm() / 0.5);
      for (int i = 0; i < steps; ++i) {
        poses.emplace_back(from + way * i / steps, heading);
      }
      for (int i = 1; i < 4; ++i) {
        poses.emplace_back(from + way, heading + i * 0.125 * kPi);
      }
    }
  }
  return poses;
}

}  // namespace vfh_astar

#endif  // VFH_ASTAR_TEST_BUILDING_H_
