#include "vfh_astar/navigation/collision_watch.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "vfh_astar/trajectory/trajectory_fitter.h"

namespace vfh_astar {

namespace {

constexpr double kScanStep = 0.05;  ///< s between two looks at the scan.

/// A trajectory at the times at which it is looked at.
class Looks {
 public:
  Looks(const Trajectory& trajectory, double from, double end) {
    for (double time = from; time <= end; time += kScanStep) {
      looks_.push_back({time, trajectory.Sample(time).pose, {}});
    }
    for (std::size_t i = 1; i < looks_.size(); ++i) {
      const Eigen::Vector2d way =
          looks_[i].pose.position() - looks_[i - 1].pose.position();
      longest_step_ = std::max(longest_step_, way.norm());
    }
  }

  std::size_t size() const { return looks_.size(); }
  double TimeOf(std::size_t look) const { return looks_[look].time; }

  /// The first look at which the footprint holds the point, of those before
  /// `end`; `end` when there is none.
  std::size_t FirstHit(const Footprint& footprint, double reach,
                       const Eigen::Vector2d& point, std::size_t end) {
    for (std::size_t i = 0; i < end;) {
      const double distance = (point - looks_[i].pose.position()).norm();
      if (distance <= reach && footprint.Contains(RobotFromMap(i) * point)) {
        return i;
      }
      // Nothing is in the way until the robot's centre has moved by the room
      // there is.
      const double steps = (distance - reach) / longest_step_;
      i += steps > 1.0 ? static_cast<std::size_t>(
                             std::min(steps, static_cast<double>(end)))
                       : 1;
    }
    return end;
  }

 private:
  struct Look {
    double time;                                   ///< s
    Pose2D pose;                                   ///< map frame
    std::optional<PointTransform> robot_from_map;  ///< once it was needed.
  };

  const PointTransform& RobotFromMap(std::size_t i) {
    std::optional<PointTransform>& transform = looks_[i].robot_from_map;
    if (!transform) transform.emplace(looks_[i].pose.Inverse());
    return *transform;
  }

  std::vector<Look> looks_;
  double longest_step_ = 1e-9;  ///< m, not 0, for a trajectory that stands.
};

}  // namespace

double TimeToScanCollision(const Trajectory& trajectory, double from,
                           double horizon, const Footprint& footprint,
                           double margin, const Observation& observation) {
  const double end = std::min(from + horizon, trajectory.duration());
  const Footprint grown = footprint.Grown(margin);
  const double reach = grown.CircumscribedRadius();
  const double farthest =
      trajectory.Length(end) - trajectory.Length(from) + reach;
  // The robot may be off the trajectory, so distances count from its start.
  const Eigen::Vector2d start = trajectory.Sample(from).pose.position();
  const PointTransform map_from_robot(observation.pose);
  Looks looks(trajectory, from, end);
  std::size_t first = looks.size();
  for (const Eigen::Vector2d& point : observation.obstacles) {
    const Eigen::Vector2d in_map = map_from_robot * point;
    if ((in_map - start).squaredNorm() > farthest * farthest) continue;
    first = looks.FirstHit(grown, reach, in_map, first);
  }
  return first < looks.size() ? looks.TimeOf(first) - from : kNever;
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
  constexpr double kStep = 0.05;
  if (observation.movers.empty()) return kNever;
  std::vector<MovingObstacle> movers;
  for (const MovingObstacle& mover : observation.movers) {
    movers.push_back(Transform(observation.pose, mover));
  }
  for (double time = 0.0; time <= horizon; time += kStep) {
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

}  // namespace vfh_astar
