#include "vfh_astar/tracking/scan_clusters.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "vfh_astar/beam_directions.h"

namespace vfh_astar {
namespace {

constexpr double kLeastGap = 0.15;  ///< m between two things at least.
/// Beam spacings that a surface seen at a flat angle may leave between hits.
constexpr double kGapInSpacings = 4.0;
constexpr std::size_t kFewest = 5;  ///< points for a circle.

}  // namespace

std::vector<ScanCluster> FindClusters(const LaserScan& scan,
                                      const Pose2D& laser_pose,
                                      double max_range) {
  std::vector<ScanCluster> clusters;
  BeamDirections direction(scan, laser_pose.theta);
  const double widening = kGapInSpacings * std::abs(scan.angle_increment);
  for (std::size_t beam = 0; beam < scan.ranges.size();
       ++beam, direction.Next()) {
    const double range = scan.ranges[beam];
    if (!scan.IsHit(scan.ranges[beam]) || range > max_range) continue;
    const Eigen::Vector2d point(laser_pose.x + range * direction.x(),
                                laser_pose.y + range * direction.y());
    const double gap = std::max(kLeastGap, widening * range);
    if (clusters.empty() ||
        (clusters.back().points.back() - point).squaredNorm() > gap * gap) {
      clusters.emplace_back();
    }
    clusters.back().points.push_back(point);
    clusters.back().beams.push_back(beam);
  }
  for (ScanCluster& cluster : clusters) {
    cluster.extent = (cluster.points.front() - cluster.points.back()).norm();
  }
  return clusters;
}

std::optional<Circle> FitCircle(const std::vector<Eigen::Vector2d>& points) {
  if (points.size() < kFewest) return std::nullopt;
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2d& point : points) mean += point;
  mean /= static_cast<double>(points.size());
  // x^2 + y^2 = 2 a x + 2 b y + c, about the mean so that no digits are lost.
  Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
  Eigen::Vector2d right = Eigen::Vector2d::Zero();
  double squares = 0.0;
  for (const Eigen::Vector2d& point : points) {
    const Eigen::Vector2d offset = point - mean;
    normal += offset * offset.transpose();
    right += 0.5 * offset.squaredNorm() * offset;
    squares += offset.squaredNorm();
  }
  const double determinant = normal.determinant();
  if (determinant < 1e-6 * squares * squares) return std::nullopt;
  const Eigen::Vector2d centre = normal.inverse() * right;
  Circle circle;
  circle.centre = mean + centre;
  circle.radius = std::sqrt(centre.squaredNorm() + squares / points.size());
  double errors = 0.0;
  for (const Eigen::Vector2d& point : points) {
    const double error = (point - circle.centre).norm() - circle.radius;
    errors += error * error;
  }
  circle.error = std::sqrt(errors / points.size());
  return circle;
}

}  // namespace vfh_astar
