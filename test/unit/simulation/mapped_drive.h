#ifndef VFH_ASTAR_TEST_MAPPED_DRIVE_H_
#define VFH_ASTAR_TEST_MAPPED_DRIVE_H_

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "vfh_astar/mapping/slam_mapper.h"
#include "vfh_astar/simulation/simulation.h"

namespace vfh_astar {

/// 360 beams over 270 degrees, 20 times a second.
inline SimulationParameters FewBeams(const std::string& noise,
                                     std::uint32_t seed) {
  SimulationParameters parameters;
  parameters.laser.beams = 360;
  parameters.laser.rate = 20.0;
  parameters.noise = NoisePreset(noise);
  parameters.seed = seed;
  return parameters;
}

/// A robot in the simulator that maps with what it senses, and is driven by
/// somebody who knows where it truly is.
class MappedDrive {
 public:
  MappedDrive(const World& world, const SimulationParameters& simulation,
              const SlamMapperParameters& mapper, const Pose2D& start)
      : simulation(world, simulation), mapper(mapper, start) {}

  /// Stands.
  void Wait(double seconds) {
    const double end = simulation.time() + seconds;
    while (simulation.time() < end) Step({});
  }

  /// Drives along straight lines through points, in the world's frame.
  void Follow(const std::vector<Eigen::Vector2d>& points, double speed) {
    for (std::size_t i = 0; i < points.size();) {
      const Pose2D pose = simulation.TruePose(0);
      const Eigen::Vector2d way = points[i] - pose.position();
      constexpr double kAhead = 0.6;  // m
      if (way.norm() < kAhead) {
        ++i;
        continue;
      }
      const double off =
          NormalizeAngle(std::atan2(way.y(), way.x()) - pose.theta);
      Step({speed * std::max(0.0, std::cos(off)),
            std::clamp(3.0 * off, -2.0, 2.0)});
    }
  }

  /// A step of physics, and the scan it may bring.
  void Step(const Twist2D& command) {
    simulation.SetCommand(0, command);
    simulation.Step();
    if (!simulation.HasNewScan(0)) return;
    const OdometryReading& odometry = simulation.filtered_odometry(0);
    const LaserScan& scan = simulation.scan(0);
    const Pose2D odom_from_base =
        Integrate(odometry.pose, odometry.twist, scan.stamp - odometry.stamp);
    mapper.AddScan(scan, simulation.laser(0).mount, odom_from_base);
    believed = mapper.map_from_odom() * odom_from_base;
    max_error = std::max(max_error, Error());
    was_lost = was_lost || mapper.localization().is_lost;
    if (on_scan) on_scan();
  }

  /// m between where the robot is and where it believes to be.
  double Error() const {
    return (believed.position() - simulation.TruePose(0).position()).norm();
  }

  Simulation simulation;
  SlamMapper mapper;
  Pose2D believed;         ///< at the newest scan.
  double max_error = 0.0;  ///< m, of all scans.
  bool was_lost = false;   ///< at any scan.
  std::function<void()> on_scan;
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_TEST_MAPPED_DRIVE_H_
