#ifndef VFH_ASTAR_ROS_SCAN_MESSAGES_H_
#define VFH_ASTAR_ROS_SCAN_MESSAGES_H_

#include <geometry_msgs/Transform.h>
#include <sensor_msgs/LaserScan.h>

#include "vfh_astar/geometry.h"
#include "vfh_astar/laser_scan.h"

namespace vfh_astar {

/// A laser in the plane of another frame.
struct LaserMount {
  Pose2D pose;
  bool upside_down = false;  ///< seen from the other frame its angles run
                             ///< clockwise.
};

/// @param[in] transform of the laser's frame in the other one.
/// @throws MessageError when the laser's plane is neither the other frame's nor
///   that one turned over, within 20 degrees.
LaserMount ToLaserMount(const geometry_msgs::Transform& transform);

/// The scan in the laser's plane; the angles of one that is mounted upside down
/// change their sign, so that LaserMount::pose places its beams.
LaserScan ToLaserScan(const sensor_msgs::LaserScan& message, bool upside_down);

}  // namespace vfh_astar

#endif  // VFH_ASTAR_ROS_SCAN_MESSAGES_H_
