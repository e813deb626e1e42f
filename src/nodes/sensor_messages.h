#ifndef VFH_ASTAR_NODES_SENSOR_MESSAGES_H_
#define VFH_ASTAR_NODES_SENSOR_MESSAGES_H_

#include <nav_msgs/Odometry.h>
#include <sensor_msgs/Imu.h>
#include <sensor_msgs/JointState.h>
#include <sensor_msgs/LaserScan.h>
#include <vfh_astar/CollisionReport.h>

#include <array>
#include <optional>
#include <string>

#include "vfh_astar/laser_scan.h"
#include "vfh_astar/simulation/noise_model.h"
#include "vfh_astar/simulation/simulation.h"

namespace vfh_astar {

/// @param[in] period s between two scans; all beams of one are taken at once.
sensor_msgs::LaserScan ToScanMessage(const LaserScan& scan, double period,
                                     const std::string& frame_id);

/// What a planar robot cannot do (rise, tilt, slide) has next to no variance.
/// @param[in] frame_id in which the pose is given.
/// @param[in] child_frame_id of the robot, in which the twist is given.
nav_msgs::Odometry ToOdometryMessage(const OdometryReading& reading,
                                     const std::string& frame_id,
                                     const std::string& child_frame_id);

/// By REP-145: at rest the acceleration is gravity's reaction, upwards. A
/// covariance of zeros means unknown: that of the yaw, which drifts, and every
/// one of a sensor without noise.
sensor_msgs::Imu ToImuMessage(const ImuReading& reading,
                              const NoiseModel& noise,
                              const std::string& frame_id);

/// @param[in] wheel_angles as Simulation gives them.
sensor_msgs::JointState ToJointMessage(
    const std::array<double, 4>& wheel_angles, double stamp);

/// @param[in] stamp of a report without a collision.
CollisionReport ToCollisionMessage(const std::optional<Collision>& collision,
                                   double stamp, const std::string& frame_id);

}  // namespace vfh_astar

#endif  // VFH_ASTAR_NODES_SENSOR_MESSAGES_H_
