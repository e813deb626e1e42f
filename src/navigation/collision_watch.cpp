#include "vfh_astar/navigation/collision_watch.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "vfh_astar/trajectory/trajectory_fitter.h"

namespace vfh_astar {
namespace {

constexpr double kMoverStep = 0.05;  ///< s between two looks at what moves.
constexpr double kScanStep = 0.05;   ///< s between two looks at the scan.

/// A trajectory at the times at which it is looked at.
class Looks {
 public:
  /// @param[in] reach m from the robot's centre to the farthest point that may
  ///   be in its way.
  Looks(const Trajectory& trajectory, double from, double end, double reach)
      : squared_reach_(reach * reach) {
    for (double time = from; time <= end; time += kScanStep) {
      looks_.push_back({time, trajectory.Sample(time).pose, {}});
    }
    for (std::size_t begin = 0; begin < size(); begin += kStretch) {
      stretches_.push_back(StretchFrom(begin, reach));
      everything_.extend(stretches_.back().box);
    }
  }

  std::size_t size() const { return looks_.size(); }
  double TimeOf(std::size_t look) const { return looks_[look].time; }

  /// The first look at which the footprint holds the point, of those before
  /// `end`; `end` when there is none.
  std::size_t FirstHit(const Footprint& footprint, const Eigen::Vector2d& point,
                       std::size_t end) {
    if (!everything_.contains(point)) return end;
    for (const Stretch& stretch : stretches_) {
      if (stretch.begin >= end) break;
      if (!stretch.box.contains(point)) continue;
      const std::size_t stop = std::min(stretch.end, end);
      for (std::size_t i = stretch.begin; i < stop; ++i) {
        const Eigen::Vector2d offset = point - looks_[i].pose.position();
        if (offset.squaredNorm() > squared_reach_) continue;
        if (footprint.Contains(RobotFromMap(i) * point)) return i;
      }
    }
    return end;
  }

 private:
  static constexpr std::size_t kStretch = 8;

  struct Look {
    double time;                                   ///< s
    Pose2D pose;                                   ///< map frame
    std::optional<PointTransform> robot_from_map;  ///< once it was needed.
  };
  /// Looks in a row, and a box around all that can be in their way.
  struct Stretch {
    std::size_t begin;
    std::size_t end;
    Eigen::AlignedBox2d box;  ///< map frame
  };

  Stretch StretchFrom(std::size_t begin, double reach) const {
    const std::size_t end = std::min(begin + kStretch, size());
    Eigen::AlignedBox2d box;
    for (std::size_t i = begin; i < end; ++i) {
      box.extend(looks_[i].pose.position());
    }
    // A little more, so that rounding leaves out nothing at the reach's end.
    const Eigen::Vector2d grown = Eigen::Vector2d::Constant(reach + 1e-9);
    return {begin, end, {box.min() - grown, box.max() + grown}};
  }

  const PointTransform& RobotFromMap(std::size_t i) {
    std::optional<PointTransform>& transform = looks_[i].robot_from_map;
    if (!transform) transform = PointTransform::Into(looks_[i].pose);
    return *transform;
  }

  double squared_reach_;
  std::vector<Look> looks_;
  std::vector<Stretch> stretches_;
  Eigen::AlignedBox2d everything_;  ///< empty without looks.
};

/// The first time (s) at which something that moves is nearer to the footprint
/// than margin and growth allow.
/// @param[in] robot_from_movers the transform at a time, from the frame that
///   they are given in.
template <typename Function>
double TimeToContact(const std::vector<MovingObstacle>& movers, double horizon,
                     const Footprint& footprint, double margin, double growth,
                     const Function& robot_from_movers) {
  for (double time = 0.0; time <= horizon; time += kMoverStep) {
    const PointTransform transform = robot_from_movers(time);
    for (const MovingObstacle& mover : movers) {
      const double distance =
          footprint.SignedDistance(transform * mover.At(time));
      if (distance < mover.radius + margin + growth * time) return time;
    }
  }
  return kNever;
}

}  // namespace

double TimeToScanCollision(const Trajectory& trajectory, double from,
                           double horizon, const Footprint& footprint,
                           double margin, const Observation& observation) {
  const double end = std::min(from + horizon, trajectory.duration());
  const Footprint grown = footprint.Grown(margin);
  const PointTransform map_from_robot(observation.pose);
  Looks looks(trajectory, from, end, grown.CircumscribedRadius());
  std::size_t first = looks.size();
  for (const Eigen::Vector2d& point : observation.obstacles) {
    first = looks.FirstHit(grown, map_from_robot * point, first);
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
  if (observation.movers.empty()) return kNever;
  std::vector<MovingObstacle> movers;
  for (const MovingObstacle& mover : observation.movers) {
    movers.push_back(Transform(observation.pose, mover));
  }
  return TimeToContact(
      movers, horizon, footprint, margin, growth, [&](double time) {
        return PointTransform::Into(trajectory.Sample(from + rate * time).pose);
      });
}

double TimeToMoverContact(double horizon, const Footprint& footprint,
                          double margin, double growth,
                          const Observation& observation) {
  const PointTransform here{Pose2D()};
  return TimeToContact(observation.movers, horizon, footprint, margin, growth,
                       [&](double) { return here; });
}

}  // namespace vfh_astar
