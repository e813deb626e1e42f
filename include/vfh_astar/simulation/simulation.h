#ifndef VFH_ASTAR_SIMULATION_SIMULATION_H_
#define VFH_ASTAR_SIMULATION_SIMULATION_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "vfh_astar/geometry.h"
#include "vfh_astar/laser_scan.h"
#include "vfh_astar/simulation/laser_model.h"
#include "vfh_astar/simulation/noise_model.h"
#include "vfh_astar/simulation/robot_sensors.h"
#include "vfh_astar/simulation/world.h"

namespace vfh_astar {

struct SimulationParameters {
  double step = 0.002;            ///< s of physics.
  double odometry_rate = 50.0;    ///< Hz, also of IMU, EKF and ground truth.
  double command_timeout = 0.25;  ///< s after which a command counts as rest.
  LaserModel laser;               ///< of robots that have none of their own.
  NoiseModel noise;
  std::uint32_t seed = 1;
};

/// The first contact of a robot since its last reset.
struct Collision {
  double time = 0.0;         ///< s
  std::string with;          ///< name of what was touched.
  double robot_speed = 0.0;  ///< m/s of the robot at that moment.
};

/// What became new in a step.
struct StepEvents {
  bool scan = false;      ///< of one robot or more: see HasNewScan().
  bool odometry = false;  ///< of every robot.
};

/// Robots, world and sensors, stepped by whoever owns it; no clock of its own.
/// Runs with the same seed and commands are the same bit by bit on the same
/// machine.
class Simulation {
 public:
  Simulation(const World& world, const SimulationParameters& parameters);
  ~Simulation();

  const World& world() const;
  const SimulationParameters& parameters() const;

  /// s since the start or the last reset.
  double time() const;

  std::size_t robot_count() const;
  const std::string& robot_name(std::size_t robot) const;
  const LaserModel& laser(std::size_t robot) const;

  /// Takes a command as the robot's own controller would: held for
  /// command_timeout, within its limits of speed and acceleration.
  void SetCommand(std::size_t robot, const Twist2D& command);

  /// One step of physics.
  StepEvents Step();

  /// True when the last step has brought a scan; robots whose lasers differ
  /// have scans at different times.
  bool HasNewScan(std::size_t robot) const;

  /// The newest of each.
  const LaserScan& scan(std::size_t robot) const;
  const OdometryReading& wheel_odometry(std::size_t robot) const;
  const OdometryReading& filtered_odometry(std::size_t robot) const;
  const ImuReading& imu(std::size_t robot) const;

  /// Where the robot really is, in the world's frame, and how it moves.
  Pose2D TruePose(std::size_t robot) const;
  Twist2D TrueTwist(std::size_t robot) const;

  /// rad, of the wheels front left, rear left, front right, rear right.
  std::array<double, 4> WheelAngles(std::size_t robot) const;

  /// m from the footprint to the nearest solid thing at this moment; +inf when
  /// there is none within 5 m.
  double Clearance(std::size_t robot) const;

  const std::optional<Collision>& collision(std::size_t robot) const;

  /// Back to the start at time 0.
  void Reset(std::uint32_t seed);

  /// Puts a robot at rest somewhere else.
  /// @return false, and nothing is changed, when its footprint would not be
  ///   free there.
  bool SetPose(std::size_t robot, const Pose2D& pose);

  /// Adds something solid that does not move.
  /// @return false when the name is taken or a robot stands there.
  bool Spawn(const StaticObstacle& obstacle);

  /// Takes away an obstacle, mover, walker or pop-up by its name.
  /// @return false when there is none of this name.
  bool Delete(const std::string& name);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_SIMULATION_SIMULATION_H_
