#include "vfh_astar/mapping/scan_matcher.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>

#include "vfh_astar/mapping/correlative_search.h"
#include "vfh_astar/mapping/scan_inserter.h"

namespace vfh_astar {
namespace {

// Closer than two sigmas of a field, so that a wall has an even crest.
constexpr double kWallSpacing = 0.075;  // m
constexpr double kWidestGap = 1.0;      // m between two hits on one surface

struct BeamHit {
  std::size_t beam;
  Eigen::Vector2d point;
};

std::vector<BeamHit> FindHits(const LaserScan& scan, const Pose2D& laser_pose,
                              double max_range) {
  std::vector<BeamHit> hits;
  hits.reserve(scan.ranges.size());
  const Eigen::Matrix2d turn =
      Eigen::Rotation2Dd(laser_pose.theta).toRotationMatrix();
  for (std::size_t beam = 0; beam < scan.ranges.size(); ++beam) {
    const double range = scan.ranges[beam];
    if (!scan.IsHit(scan.ranges[beam]) || range > max_range) continue;
    const double angle = scan.Angle(beam);
    hits.push_back(
        {beam, laser_pose.position() +
                   turn * (range *
                           Eigen::Vector2d(std::cos(angle), std::sin(angle)))});
  }
  return hits;
}

void AddApart(const Eigen::Vector2d& point, double spacing,
              std::vector<Eigen::Vector2d>& points) {
  if (points.empty() || (point - points.back()).norm() >= spacing) {
    points.push_back(point);
  }
}

/// Adds the way to a hit from the one before it, where both lie on one surface.
/// @return whether they do; then the hit itself is added too.
bool AddSurface(const std::vector<BeamHit>& hits, std::size_t to,
                std::vector<Eigen::Vector2d>& points) {
  const std::size_t from = to - 1;
  if (hits[from].beam + 1 != hits[to].beam) return false;
  const Eigen::Vector2d gap = hits[to].point - hits[from].point;
  const double length = gap.norm();
  if (length < 1.5 * kWallSpacing || length > kWidestGap) return false;
  const bool has_before =
      from > 0 && hits[from - 1].beam + 1 == hits[from].beam;
  const bool has_after =
      to + 1 < hits.size() && hits[to].beam + 1 == hits[to + 1].beam;
  if (!IsOneSurface(has_before ? &hits[from - 1].point : nullptr,
                    hits[from].point, hits[to].point,
                    has_after ? &hits[to + 1].point : nullptr)) {
    return false;
  }
  const int parts = static_cast<int>(std::ceil(length / kWallSpacing));
  for (int i = 1; i <= parts; ++i) {
    points.push_back(hits[from].point + gap * i / parts);
  }
  return true;
}

}  // namespace

void ScanMatcherParameters::Read(ParameterReader& reader) {
  reader.Number("max_range", max_range, 1.0, 200.0);
  reader.Number("resolution", resolution, 0.01, 0.5);
  reader.Number("sigma", sigma, 0.01, 0.5);
  reader.Number("linear_window", linear_window, 0.05, 5.0);
  reader.Number("angular_window", angular_window, 0.01, kPi);
}

ScanShape ScanMatcher::Shape(const LaserScan& scan,
                             const Pose2D& base_from_laser) const {
  const std::vector<BeamHit> hits =
      FindHits(scan, base_from_laser, parameters_.max_range);
  ScanShape shape;
  for (std::size_t i = 0; i < hits.size(); ++i) {
    AddApart(hits[i].point, parameters_.point_spacing, shape.probes);
    if (i == 0 || !AddSurface(hits, i, shape.walls)) {
      AddApart(hits[i].point, kWallSpacing, shape.walls);
    }
  }
  return shape;
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
