#ifndef VFH_ASTAR_SIMULATION_ROBOT_SENSORS_H_
#define VFH_ASTAR_SIMULATION_ROBOT_SENSORS_H_

#include <Eigen/Core>
#include <array>
#include <random>

#include "vfh_astar/geometry.h"
#include "vfh_astar/simulation/jackal.h"
#include "vfh_astar/simulation/noise_model.h"
#include "vfh_astar/simulation/odometry_filter.h"

namespace vfh_astar {

/// Pose and twist at a time.
struct OdometryReading {
  double stamp = 0.0;  ///< s
  Pose2D pose;  ///< base_link in the frame odom, which is where the robot
                ///< started.
  Twist2D twist;
  Eigen::Vector3d pose_variance = Eigen::Vector3d::Zero();   ///< x, y, theta.
  Eigen::Vector2d twist_variance = Eigen::Vector2d::Zero();  ///< v, w.
};

struct ImuReading {
  double stamp = 0.0;                 ///< s
  double yaw = 0.0;                   ///< rad, integrated from the rate, so
                                      ///< that it is wrong as the gyro is.
  double yaw_rate = 0.0;              ///< rad/s
  double forward_acceleration = 0.0;  ///< m/s^2
  double left_acceleration = 0.0;     ///< m/s^2
};

/// What a robot knows of its own motion: encoders, gyro, and the filter over
/// both.
class RobotSensors {
 public:
  RobotSensors(const NoiseModel& noise, const JackalModel& model)
      : noise_(noise), model_(model) {}

  /// Reads encoders and IMU, `duration` seconds after the last reading.
  /// @param[in] random the simulation's only source of chance.
  void Read(double stamp, double duration, const Jackal& robot,
            std::mt19937* random);

  const OdometryReading& wheels() const { return wheels_; }
  const OdometryReading& filtered() const { return filtered_; }
  const ImuReading& imu() const { return imu_; }

 private:
  Twist2D ReadWheels(double duration, const Jackal& robot,
                     std::mt19937* random);
  void ReadImu(double duration, const Jackal& robot, std::mt19937* random);

  NoiseModel noise_;
  JackalModel model_;
  std::array<double, 4> last_angles_{};
  Eigen::Vector2d last_velocity_ = Eigen::Vector2d::Zero();
  OdometryFilter filter_;
  OdometryReading wheels_;
  OdometryReading filtered_;
  ImuReading imu_;
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_SIMULATION_ROBOT_SENSORS_H_
