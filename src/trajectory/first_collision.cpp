#include "vfh_astar/trajectory/first_collision.h"

#include <algorithm>
#include <cmath>

namespace vfh_astar {
namespace {

constexpr double kStep = 0.015;    // m, of any point of the footprint.
constexpr double kMaxStep = 0.02;  // s, in which speed hardly changes.

}  // namespace

std::optional<double> FirstCollision(const Trajectory& trajectory,
                                     const Footprint& footprint,
                                     const ClearanceMap& clearance,
                                     double margin, double from, double to) {
  if (trajectory.empty()) return std::nullopt;
  const double end = std::min(to, trajectory.duration());
  const double radius = footprint.Grown(margin).CircumscribedRadius();
  // The clearance at a point is that of its cell's centre.
  const double off_centre = std::sqrt(0.5) * clearance.geometry().resolution;

  double t = std::max(from, 0.0);
  while (t <= end) {
    const Reference at = trajectory.Sample(t);
    const double room = clearance.At(at.pose.position()) - radius - off_centre;
    if (room <= 0.0 && !clearance.IsFree(footprint, at.pose, margin)) return t;
    if (t == end) break;

    const double pace = std::abs(at.twist.v) + std::abs(at.twist.w) * radius;
    double next = t + std::min(kMaxStep, kStep / std::max(pace, 1e-9));
    if (room > kStep) {
      next =
          std::max(next, trajectory.TimeAtLength(trajectory.Length(t) + room));
    }
    t = std::min(next, end);
  }
  return std::nullopt;
}

}  // namespace vfh_astar
