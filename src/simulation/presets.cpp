#include <stdexcept>

#include "vfh_astar/simulation/laser_model.h"
#include "vfh_astar/simulation/noise_model.h"

namespace vfh_astar {

const std::vector<std::string>& LaserPresetNames() {
  static const std::vector<std::string> kNames = {"paper", "barn"};
  return kNames;
}

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

NoiseModel DrawErrors(const NoiseModel& noise, std::mt19937* random) {
  const auto draw = [random](double error) {
    const double size = std::uniform_real_distribution<>(0.8, 1.25)(*random);
    return std::bernoulli_distribution(0.5)(*random) ? size * error
                                                     : -size * error;
  };
  NoiseModel drawn = noise;
  drawn.wheel_scale_error = draw(noise.wheel_scale_error);
  drawn.wheel_difference = draw(noise.wheel_difference);
  drawn.gyro_bias = draw(noise.gyro_bias);
  drawn.gyro_scale_error = draw(noise.gyro_scale_error);
  drawn.acceleration_bias = draw(noise.acceleration_bias);
  return drawn;
}

NoiseModel NoisePreset(const std::string& name) {
  NoiseModel noise;
  if (name == "clean") return noise;
  if (name == "experiment") {
    noise.range_sigma = 0.01;
    noise.dropout = 0.005;
    noise.wheel_scale_error = 0.028;
    noise.wheel_difference = 0.01;
    noise.encoder_sigma = 0.02;
    noise.gyro_bias = 0.0008;
    noise.gyro_scale_error = 0.025;
    noise.gyro_sigma = 0.005;
    noise.acceleration_bias = 0.04;
    noise.acceleration_sigma = 0.05;
    return noise;
  }
  throw std::invalid_argument("noise '" + name +
                              "' is unknown; expected clean or experiment");
}

}  // namespace vfh_astar
