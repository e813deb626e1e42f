#ifndef VFH_ASTAR_BEAM_DIRECTIONS_H_
#define VFH_ASTAR_BEAM_DIRECTIONS_H_

#include <cmath>

#include "vfh_astar/laser_scan.h"

namespace vfh_astar {

/// The directions of a scan's beams as unit vectors, one beam after the other.
/// Each is the one before turned by the increment, which over a thousand beams
/// loses 1e-13 rad, at a tenth of the cost of a sine and a cosine each.
class BeamDirections {
 public:
  /// Stands at beam 0.
  /// @param[in] theta rad, of the laser in the frame the directions are wanted
  ///   in.
  BeamDirections(const LaserScan& scan, double theta)
      : cos_(std::cos(theta + scan.angle_min)),
        sin_(std::sin(theta + scan.angle_min)),
        cos_turn_(std::cos(scan.angle_increment)),
        sin_turn_(std::sin(scan.angle_increment)) {}

  double x() const { return cos_; }
  double y() const { return sin_; }

  /// Goes on to the next beam.
  void Next() {
    const double c = cos_ * cos_turn_ - sin_ * sin_turn_;
    sin_ = cos_ * sin_turn_ + sin_ * cos_turn_;
    cos_ = c;
  }

 private:
  double cos_;
  double sin_;
  double cos_turn_;
  double sin_turn_;
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_BEAM_DIRECTIONS_H_
