#include "vfh_astar/simulation/lidar.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "vfh_astar/simulation/normal_noise.h"

namespace vfh_astar {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// rad from beam to beam.
double IncrementOf(const LaserModel& laser) {
  return laser.beams > 1
             ? (laser.angle_max - laser.angle_min) / (laser.beams - 1)
             : 2.0 * kPi;
}

}  // namespace

Lidar::Lidar(const LaserModel& laser, const NoiseModel& noise)
    : laser_(laser),
      noise_(noise),
      fan_(laser.beams, laser.angle_min, IncrementOf(laser)) {
  scan_.angle_min = laser.angle_min;
  scan_.angle_increment = IncrementOf(laser);
  scan_.range_min = laser.range_min;
  scan_.range_max = laser.range_max;
  scan_.ranges.assign(laser.beams, std::numeric_limits<float>::quiet_NaN());
}

void Lidar::Sweep(double stamp, const Pose2D& base, const ShapeIndex& still,
                  const std::vector<const Shape*>& moving,
                  std::mt19937* random) {
  scan_.stamp = stamp;
  fan_.Aim(base * laser_.mount, laser_.range_max);
  for (const Shape* shape : moving) fan_.LookAt(*shape);
  still.CastRays(&fan_);
  ranges_ = fan_.ranges();
  AddNoise(random);
  ApplyLimits();
}

void Lidar::AddNoise(std::mt19937* random) {
  const double sigma = std::hypot(laser_.sigma, noise_.range_sigma);
  if (sigma > 0.0) {
    for (double& range : ranges_) {
      if (range <= laser_.range_max) range += sigma * DrawNormal(random);
    }
  }
  if (noise_.dropout > 0.0) {
    std::bernoulli_distribution is_lost(noise_.dropout);
    for (double& range : ranges_) {
      if (is_lost(*random)) range = kInfinity;
    }
  }
}

void Lidar::ApplyLimits() {
  for (std::size_t i = 0; i < ranges_.size(); ++i) {
    double range = ranges_[i];
    if (range > laser_.range_max) range = kInfinity;
    if (range < laser_.range_min) range = -kInfinity;
    scan_.ranges[i] = static_cast<float>(range);
  }
}

}  // namespace vfh_astar
