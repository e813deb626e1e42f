#include "vfh_astar/mapping/scan_matcher.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "vfh_astar/mapping/correlative_search.h"

namespace vfh_astar {

void ScanMatcherParameters::Read(ParameterReader& reader) {
  reader.Number("max_range", max_range, 1.0, 200.0);
  reader.Number("point_spacing", point_spacing, 0.0, 1.0);
  reader.Number("resolution", resolution, 0.01, 0.5);
  reader.Number("sigma", sigma, 0.01, 0.5);
  reader.Number("gain", gain, 0.05, 1.0);
  reader.Number("point_weight", point_weight, 0.01, 10.0);
  reader.Number("linear_window", linear_window, 0.05, 5.0);
  reader.Number("angular_window", angular_window, 0.01, kPi);
  reader.Number("angular_step", angular_step, 0.001, 0.1);
}

std::vector<Eigen::Vector2d> ScanMatcher::Points(
    const LaserScan& scan, const Pose2D& base_from_laser) const {
  const std::vector<Eigen::Vector2d> hits =
      HitPoints(scan, base_from_laser, parameters_.max_range);
  std::vector<Eigen::Vector2d> points;
  for (const Eigen::Vector2d& hit : hits) {
    if (points.empty() ||
        (hit - points.back()).norm() >= parameters_.point_spacing) {
      points.push_back(hit);
    }
  }
  return points;
}

Pose2D ScanMatcher::FindCoarse(const HitField& field,
                               const std::vector<Eigen::Vector2d>& points,
                               const PoseBelief& prior) const {
  SearchWindow window;
  window.linear = parameters_.linear_window;
  window.angular = parameters_.angular_window;
  window.angular_step = parameters_.angular_step;
  // In the units of a score, which is a mean over the points. The motion
  // model's information is the same along all directions of the plane.
  const double nats = parameters_.point_weight * points.size();
  window.linear_penalty = 0.5 * prior.information(0, 0) / nats;
  window.angular_penalty = 0.5 * prior.information(2, 2) / nats;
  constexpr double kLeastScore = 0.05;
  const std::optional<SearchResult> found =
      SearchPose(field, points, prior.mean, window, kLeastScore);
  return found ? found->pose : prior.mean;
}

}  // namespace vfh_astar
