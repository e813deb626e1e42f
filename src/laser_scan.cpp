#include "vfh_astar/laser_scan.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "vfh_astar/beam_directions.h"

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
  BeamDirections direction(scan, laser_pose.theta);
  for (const float range : scan.ranges) {
    if (scan.IsHit(range) && range <= max_range) {
      points.emplace_back(laser_pose.x + range * direction.x(),
                          laser_pose.y + range * direction.y());
    }
    direction.Next();
  }
  return points;
}

}  // namespace vfh_astar
