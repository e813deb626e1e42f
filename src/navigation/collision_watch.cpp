#include "vfh_astar/navigation/collision_watch.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "vfh_astar/trajectory/trajectory_fitter.h"

namespace vfh_astar {
namespace {

constexpr double kMoverStep = 0.05;  ///< s between two looks at what moves.

}  // namespace

double TimeToScanCollision(const Trajectory& trajectory, double from,
                           double horizon, const Footprint& footprint,
                           double margin, const Observation& observation) {
  constexpr double kStep = 0.05;
  const double end = std::min(from + horizon, trajectory.duration());
  const Footprint grown = footprint.Grown(margin);
  const double reach = grown.CircumscribedRadius();
  const double farthest =
      trajectory.Length(end) - trajectory.Length(from) + reach;
  // The robot may be off the trajectory, so distances count from its start.
  const Pose2D start = trajectory.Sample(from).pose;
  const PointTransform map_from_robot(observation.pose);
  std::vector<Eigen::Vector2d> near;
  near.reserve(observation.obstacles.size());
  for (const Eigen::Vector2d& point : observation.obstacles) {
    const Eigen::Vector2d in_map = map_from_robot * point;
    if ((in_map - start.position()).squaredNorm() <= farthest * farthest) {
      near.push_back(in_map);
    }
  }
  if (near.empty()) return kNever;
  // Around a place that has been looked at nothing is in the way until the
  // robot's centre has moved by the room there was.
  Eigen::Vector2d looked_at = start.position();
  double room = 0.0;
  for (double time = from; time <= end; time += kStep) {
    const Pose2D pose = trajectory.Sample(time).pose;
    if ((pose.position() - looked_at).norm() < room) continue;
    const PointTransform robot_from_map(pose.Inverse());
    double nearest = kNever;
    for (const Eigen::Vector2d& point : near) {
      const double distance = (point - pose.position()).squaredNorm();
      nearest = std::min(nearest, distance);
      if (distance > reach * reach) continue;
      if (grown.Contains(robot_from_map * point)) return time - from;
    }
    looked_at = pose.position();
    room = std::sqrt(nearest) - reach;
  }
  return kNever;
}

double TimeToMapCollision(const Trajectory& trajectory, double from,
                          double horizon, const Footprint& footprint,
                          double margin, const Observation& observation) {
  if (observation.map == nullptr) return kNever;
  const double end = std::min(from + horizon, trajectory.duration());
  const std::optional<double> collision =
      FirstCollision(trajectory, footprint, *observation.map, margin,
                     std::min(from, end), end);
  return collision ? *collision - from : kNever;
}

double TimeToMoverCollision(const Trajectory& trajectory, double from,
                            double horizon, double rate,
                            const Footprint& footprint, double margin,
                            double growth, const Observation& observation) {
  if (observation.movers.empty()) return kNever;
  std::vector<MovingObstacle> movers;
  for (const MovingObstacle& mover : observation.movers) {
    movers.push_back(Transform(observation.pose, mover));
  }
  for (double time = 0.0; time <= horizon; time += kMoverStep) {
    const Pose2D robot_from_map =
        trajectory.Sample(from + rate * time).pose.Inverse();
    for (const MovingObstacle& mover : movers) {
      const double distance =
          footprint.SignedDistance(robot_from_map * mover.At(time));
      if (distance < mover.radius + margin + growth * time) return time;
    }
  }
  return kNever;
}

double TimeToMoverContact(double horizon, const Footprint& footprint,
                          double margin, double growth,
                          const Observation& observation) {
  for (double time = 0.0; time <= horizon; time += kMoverStep) {
    for (const MovingObstacle& mover : observation.movers) {
      const double distance = footprint.SignedDistance(mover.At(time));
      if (distance < mover.radius + margin + growth * time) return time;
    }
  }
  return kNever;
}

}  // namespace vfh_astar
