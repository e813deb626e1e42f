#include "vfh_astar/simulation/lidar.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vfh_astar {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

Lidar::Lidar(const LaserModel& laser, const NoiseModel& noise)
    : laser_(laser),
      noise_(noise),
      directions_(laser.beams),
      ranges_(laser.beams) {
  scan_.angle_min = laser.angle_min;
  scan_.angle_increment =
      laser.beams > 1 ? (laser.angle_max - laser.angle_min) / (laser.beams - 1)
                      : laser.angle_max - laser.angle_min;
  scan_.range_min = laser.range_min;
  scan_.range_max = laser.range_max;
  scan_.ranges.assign(laser.beams, std::numeric_limits<float>::quiet_NaN());
  for (int beam = 0; beam < laser.beams; ++beam) {
    const double angle = scan_.Angle(beam);
    beams_.emplace_back(std::cos(angle), std::sin(angle));
  }
}

void Lidar::Sweep(double stamp, const Pose2D& base, const ShapeIndex& still,
                  const std::vector<const Shape*>& moving,
                  std::mt19937* random) {
  scan_.stamp = stamp;
  const Pose2D pose = base * laser_.mount;
  const Eigen::Vector2d origin = pose.position();
  const Eigen::Vector2d heading = pose.heading();
  for (std::size_t i = 0; i < beams_.size(); ++i) {
    const Eigen::Vector2d& beam = beams_[i];
    directions_[i] = {heading.x() * beam.x() - heading.y() * beam.y(),
                      heading.y() * beam.x() + heading.x() * beam.y()};
  }
  still.CastRays(origin, directions_.data(), directions_.size(),
                 laser_.range_max, ranges_.data());
  for (const Shape* shape : moving) LookAt(*shape, pose);
  AddNoise(random);
  ApplyLimits();
}

void Lidar::LookAt(const Shape& shape, const Pose2D& pose) {
  const Eigen::Vector2d to_center = shape.center - pose.position();
  const double distance = to_center.norm();
  if (distance - shape.radius > laser_.range_max) return;
  const int last = laser_.beams - 1;
  if (distance <= shape.radius || scan_.angle_increment <= 0.0) {
    LookAt(shape, pose.position(), 0, last);
    return;
  }
  // Only the beams between the two tangents to its circle can meet it.
  const double bearing = NormalizeAngle(
      std::atan2(to_center.y(), to_center.x()) - pose.theta - laser_.angle_min);
  const double half_angle = std::asin(shape.radius / distance);
  for (const double turn : {-2.0 * kPi, 0.0, 2.0 * kPi, 4.0 * kPi}) {
    const double middle = (bearing + turn) / scan_.angle_increment;
    const double half = half_angle / scan_.angle_increment;
    LookAt(shape, pose.position(),
           static_cast<int>(std::max(0.0, std::floor(middle - half))),
           static_cast<int>(
               std::clamp(std::ceil(middle + half), -1.0, last + 0.0)));
  }
}

void Lidar::LookAt(const Shape& shape, const Eigen::Vector2d& origin,
                   int first_beam, int last_beam) {
  for (int beam = first_beam; beam <= last_beam; ++beam) {
    ranges_[beam] =
        std::min(ranges_[beam], RayDistance(shape, origin, directions_[beam]));
  }
}

void Lidar::AddNoise(std::mt19937* random) {
  const double sigma = std::hypot(laser_.sigma, noise_.range_sigma);
  if (sigma > 0.0) {
    std::normal_distribution<double> error(0.0, sigma);
    for (double& range : ranges_) {
      if (std::isfinite(range)) range += error(*random);
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
