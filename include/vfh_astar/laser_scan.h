#ifndef VFH_ASTAR_LASER_SCAN_H_
#define VFH_ASTAR_LASER_SCAN_H_

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "vfh_astar/geometry.h"

namespace vfh_astar {

/// One sweep of a planar laser, as sensor_msgs/LaserScan has it. Ranges follow
/// REP-117: only `range_min <= r <= range_max` is a hit, +inf is 'nothing out
/// to range_max', NaN is no measurement, -inf is too close to measure.
struct LaserScan {
  double stamp = 0.0;            ///< s, when the sweep was taken.
  double angle_min = 0.0;        ///< rad, of beam 0 in the laser's frame.
  double angle_increment = 0.0;  ///< rad between beams; negative if clockwise.
  double range_min = 0.0;        ///< m
  double range_max = 0.0;        ///< m
  std::vector<float> ranges;     ///< m

  double Angle(std::size_t beam) const {
    return angle_min + angle_increment * static_cast<double>(beam);
  }

  bool IsHit(float range) const {
    return range_min <= range && range <= range_max;
  }

  /// True when the beam saw nothing out to range_max.
  bool IsFree(float range) const { return range > range_max; }
};

/// Says what makes a scan unusable (no beams, zero increment, limits that are
/// not finite or out of order, no single usable range: a laser that is blind
/// must not pass for an empty room), or nothing when it can be used.
std::optional<std::string> DescribeDefect(const LaserScan& scan);

/// The scan with NaN where one or two beams saw nothing between neighbours that
/// hit something. Lasers lose a beam now and then, and what is lost looks like
/// open space; a real opening is seen by more beams, or not worth a look.
LaserScan WithoutLostBeams(LaserScan scan);

/// The hits of a scan as points.
/// @param[in] laser_pose the laser in the frame the points are wanted in. A
///   laser mounted upside down is handled where the scan comes in, by turning
///   the sign of its angles.
/// @param[in] max_range m, farther hits are left out.
std::vector<Eigen::Vector2d> HitPoints(const LaserScan& scan,
                                       const Pose2D& laser_pose,
                                       double max_range);

}  // namespace vfh_astar

#endif  // VFH_ASTAR_LASER_SCAN_H_
