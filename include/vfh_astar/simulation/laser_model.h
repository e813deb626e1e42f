#ifndef VFH_ASTAR_SIMULATION_LASER_MODEL_H_
#define VFH_ASTAR_SIMULATION_LASER_MODEL_H_

#include <string>
#include <vector>

#include "vfh_astar/geometry.h"

namespace vfh_astar {

/// A planar laser on a robot.
struct LaserModel {
  int beams = 1080;
  double angle_min = -2.35619449;  ///< rad
  double angle_max = 2.35619449;   ///< rad, of the last beam.
  double range_min = 0.1;          ///< m
  double range_max = 30.0;         ///< m
  double rate = 40.0;              ///< Hz
  double sigma = 0.0;              ///< m, of Gaussian noise on each range.
  Pose2D mount{0.055, 0.0, 0.0};   ///< the laser in base_link.
};

/// `paper`: 1080 beams, 270 degrees, 40 Hz. `barn`: 720 beams, +-2.35619 rad,
/// 0.1 to 30 m, 50 Hz, sigma 1 mm, as the BARN benchmark's Jackal has it.
/// @throws std::invalid_argument naming the presets for any other name.
LaserModel LaserPreset(const std::string& name);

const std::vector<std::string>& LaserPresetNames();

}  // namespace vfh_astar

#endif  // VFH_ASTAR_SIMULATION_LASER_MODEL_H_
