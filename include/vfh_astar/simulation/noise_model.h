#ifndef VFH_ASTAR_SIMULATION_NOISE_MODEL_H_
#define VFH_ASTAR_SIMULATION_NOISE_MODEL_H_

#include <random>
#include <string>

namespace vfh_astar {

/// What is wrong with a robot's sensors and wheels. All zero is perfect.
struct NoiseModel {
  double range_sigma = 0.0;        ///< m, added to the laser's own.
  double dropout = 0.0;            ///< probability that a beam returns nothing.
  double wheel_scale_error = 0.0;  ///< relative error of wheel radius, by which
                                   ///< all wheels are measured wrong,
  double wheel_difference = 0.0;   ///< and by which left and right differ.
  double encoder_sigma = 0.0;  ///< relative, of each wheel's turn per reading.
  double gyro_bias = 0.0;      ///< rad/s
  double gyro_scale_error = 0.0;    ///< relative error of the measured rate.
  double gyro_sigma = 0.0;          ///< rad/s per reading.
  double acceleration_bias = 0.0;   ///< m/s^2, forward and to the left.
  double acceleration_sigma = 0.0;  ///< m/s^2 per reading.
};

/// One robot's share of what is systematically wrong: errors of scale,
/// difference and bias, each 0.8 to 1.25 times as large as the model says and
/// of either sign. What is wrong by chance, reading for reading, stays as it
/// is.
NoiseModel DrawErrors(const NoiseModel& noise, std::mt19937* random);

/// `clean`: nothing wrong but the laser's own noise. `experiment`: as bad as a
/// worn robot on a bad floor; odometry drifts by 2 to 5 % of the distance
/// driven (less where a way leads back to its start).
/// @throws std::invalid_argument naming the presets for any other name.
NoiseModel NoisePreset(const std::string& name);

}  // namespace vfh_astar

#endif  // VFH_ASTAR_SIMULATION_NOISE_MODEL_H_
