#ifndef VFH_ASTAR_TRACKING_SCAN_MEMORY_H_
#define VFH_ASTAR_TRACKING_SCAN_MEMORY_H_

#include <Eigen/Core>
#include <deque>

#include "vfh_astar/geometry.h"
#include "vfh_astar/laser_scan.h"

namespace vfh_astar {

/// A scan and where it was taken.
class PlacedScan {
 public:
  PlacedScan() = default;
  PlacedScan(const LaserScan& scan, const Pose2D& laser_pose)
      : scan_(scan),
        pose_(laser_pose),
        laser_from_frame_(PointTransform::Into(pose_)) {}

  const LaserScan& scan() const { return scan_; }
  const Pose2D& pose() const { return pose_; }  ///< of the laser.

  /// True when the beams around the point's direction all reached beyond it by
  /// more than `margin` (m): the place was free. What the scan could not see,
  /// behind something or beside its field of view, is not.
  /// @param[in] heading rad, of the laser when it saw the point. The farther it
  ///   has turned between, the more the two may be off to one another, and
  ///   along a wall seen aslant a beam a little beside reaches much farther.
  bool SawThrough(const Eigen::Vector2d& point, double margin,
                  double heading) const;

 private:
  LaserScan scan_;
  Pose2D pose_;
  PointTransform laser_from_frame_{Pose2D()};
};

/// Keeps the scans of the last second or so, thinned, to be asked whether a
/// place was free. What appears where an earlier scan saw through has moved
/// there; what merely comes into view was hidden before.
class ScanMemory {
 public:
  /// @param[in] length s that scans are kept.
  explicit ScanMemory(double length) : length_(length) {}

  void Add(const LaserScan& scan, const Pose2D& pose);
  void Clear() { scans_.clear(); }

  /// True when the scan taken half the memory's length ago, or the oldest, saw
  /// through the place. See PlacedScan::SawThrough.
  bool WasFree(const Eigen::Vector2d& point, double margin,
               double heading) const;

 private:
  double length_;
  std::deque<PlacedScan> scans_;
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_TRACKING_SCAN_MEMORY_H_
