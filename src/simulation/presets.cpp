#include <stdexcept>

#include "vfh_astar/simulation/laser_model.h"
#include "vfh_astar/simulation/noise_model.h"

namespace vfh_astar {

LaserModel LaserPreset(const std::string& name) {
  LaserModel laser;
  if (name == "paper") return laser;
  if (name == "barn") {
    laser.beams = 720;
    laser.angle_min = -2.35619;
    laser.angle_max = 2.35619;
    laser.rate = 50.0;
    laser.sigma = 0.001;
    return laser;
  }
  throw std::invalid_argument("laser '" + name +
                              "' is unknown; expected paper or barn");
}

NoiseModel NoisePreset(const std::string& name) {
  NoiseModel noise;
  if (name == "clean") return noise;
  if (name == "experiment") {
    noise.range_sigma = 0.01;
    noise.dropout = 0.005;
    noise.wheel_scale_error = 0.02;
    noise.wheel_difference = 0.01;
    noise.encoder_sigma = 0.02;
    noise.gyro_bias = 0.003;
    noise.gyro_sigma = 0.005;
    noise.acceleration_sigma = 0.05;
    return noise;
  }
  throw std::invalid_argument("noise '" + name +
                              "' is unknown; expected clean or experiment");
}

}  // namespace vfh_astar
