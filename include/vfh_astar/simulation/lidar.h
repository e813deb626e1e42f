#ifndef VFH_ASTAR_SIMULATION_LIDAR_H_
#define VFH_ASTAR_SIMULATION_LIDAR_H_

#include <random>
#include <vector>

#include "vfh_astar/geometry.h"
#include "vfh_astar/laser_scan.h"
#include "vfh_astar/simulation/beam_fan.h"
#include "vfh_astar/simulation/laser_model.h"
#include "vfh_astar/simulation/noise_model.h"
#include "vfh_astar/simulation/shape.h"
#include "vfh_astar/simulation/shape_index.h"

namespace vfh_astar {

/// A planar laser that looks at shapes. A sweep is taken at one instant.
class Lidar {
 public:
  Lidar(const LaserModel& laser, const NoiseModel& noise);

  /// Takes a sweep.
  /// @param[in] base the robot's pose in the world.
  /// @param[in] still what does not move.
  /// @param[in] moving whatever else there is to see; not the robot itself.
  /// @param[in] random the simulation's only source of chance; not asked where
  ///   there is no noise.
  void Sweep(double stamp, const Pose2D& base, const ShapeIndex& still,
             const std::vector<const Shape*>& moving, std::mt19937* random);

  /// The newest sweep; all ranges are NaN before the first one.
  const LaserScan& scan() const { return scan_; }

 private:
  void AddNoise(std::mt19937* random);
  void ApplyLimits();

  LaserModel laser_;
  NoiseModel noise_;
  BeamFan fan_;
  std::vector<double> ranges_;  ///< m, of the sweep being taken.
  LaserScan scan_;
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_SIMULATION_LIDAR_H_
