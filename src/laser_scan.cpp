#include "vfh_astar/laser_scan.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>

namespace vfh_astar {

std::optional<std::string> DescribeDefect(const LaserScan& scan) {
  if (scan.ranges.empty()) {
    return "the scan has no beams; expected at least one range";
  }
  if (!std::isfinite(scan.angle_min) || !std::isfinite(scan.angle_increment) ||
      scan.angle_increment == 0.0) {
    return "the scan has angle_min " + std::to_string(scan.angle_min) +
           " and angle_increment " + std::to_string(scan.angle_increment) +
           "; expected finite angles and an increment other than 0";
  }
  if (!std::isfinite(scan.range_min) || !std::isfinite(scan.range_max) ||
      scan.range_min < 0.0 || scan.range_max <= scan.range_min) {
    return "the scan has range_min " + std::to_string(scan.range_min) +
           " and range_max " + std::to_string(scan.range_max) +
           "; expected 0 <= range_min < range_max";
  }
  const bool is_blind = std::none_of(
      scan.ranges.begin(), scan.ranges.end(),
      [&](float range) { return scan.IsHit(range) || scan.IsFree(range); });
  if (is_blind) {
    return "none of the scan's " + std::to_string(scan.ranges.size()) +
           " ranges is usable; expected hits within range_min and range_max, "
           "or "
           "+inf";
  }
  return std::nullopt;
}

LaserScan WithoutLostBeams(LaserScan scan) {
  constexpr std::size_t kMostLost = 2;  // side by side
  std::vector<float>& ranges = scan.ranges;
  for (std::size_t first = 1; first < ranges.size();) {
    if (!scan.IsFree(ranges[first]) || !scan.IsHit(ranges[first - 1])) {
      ++first;
      continue;
    }
    std::size_t end = first;
    while (end < ranges.size() && scan.IsFree(ranges[end])) ++end;
    if (end - first <= kMostLost && end < ranges.size() &&
        scan.IsHit(ranges[end])) {
      std::fill(ranges.begin() + first, ranges.begin() + end,
                std::numeric_limits<float>::quiet_NaN());
    }
    first = end;
  }
  return scan;
}

std::vector<Eigen::Vector2d> HitPoints(const LaserScan& scan,
                                       const Pose2D& laser_pose,
                                       double max_range) {
  std::vector<Eigen::Vector2d> points;
  points.reserve(scan.ranges.size());
  // Each beam's direction is the one before turned by the increment: over a
  // thousand beams that loses 1e-13 rad.
  const std::complex<double> turn = std::polar(1.0, scan.angle_increment);
  std::complex<double> direction =
      std::polar(1.0, laser_pose.theta + scan.angle_min);
  for (const float range : scan.ranges) {
    if (scan.IsHit(range) && range <= max_range) {
      points.emplace_back(laser_pose.x + range * direction.real(),
                          laser_pose.y + range * direction.imag());
    }
    direction = {
        direction.real() * turn.real() - direction.imag() * turn.imag(),
        direction.real() * turn.imag() + direction.imag() * turn.real()};
  }
  return points;
}

}  // namespace vfh_astar
