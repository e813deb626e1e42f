#include "vfh_astar/tracking/scan_memory.h"

#include <algorithm>
#include <cmath>

namespace vfh_astar {
namespace {

constexpr double kSpacing = 0.1;  ///< s between two kept scans.
/// To each side so many beams must agree,
constexpr int kNeighbours = 2;
/// and more by this part of the turn: the scale of a gyro may be so far off.
constexpr double kTurnError = 0.03;

}  // namespace

bool PlacedScan::SawThrough(const Eigen::Vector2d& point, double margin,
                            double heading) const {
  const Eigen::Vector2d seen = laser_from_frame_ * point;
  const double distance = seen.norm();
  const double angle = std::atan2(seen.y(), seen.x());
  const int beam = static_cast<int>(
      std::lround((angle - scan_.angle_min) / scan_.angle_increment));
  const double turn = NormalizeAngle(heading - pose_.theta);
  const int around =
      kNeighbours + static_cast<int>(std::lround(
                        std::abs(kTurnError * turn / scan_.angle_increment)));
  if (beam < around || beam + around >= static_cast<int>(scan_.ranges.size())) {
    return false;
  }
  for (int i = beam - around; i <= beam + around; ++i) {
    const float range = scan_.ranges[i];
    if (!scan_.IsHit(range) && !scan_.IsFree(range)) return false;
    if (range < distance + margin) return false;
  }
  return true;
}

void ScanMemory::Add(const LaserScan& scan, const Pose2D& pose) {
  if (!scans_.empty() && scan.stamp < scans_.back().scan().stamp + kSpacing) {
    return;
  }
  scans_.emplace_back(scan, pose);
  while (scans_.front().scan().stamp < scan.stamp - length_) scans_.pop_front();
}

bool ScanMemory::WasFree(const Eigen::Vector2d& point, double margin,
                         double heading) const {
  if (scans_.size() < 2) return false;
  return scans_.front().SawThrough(point, margin, heading) ||
         scans_[scans_.size() / 2].SawThrough(point, margin, heading);
}

}  // namespace vfh_astar
