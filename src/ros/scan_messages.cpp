#include "vfh_astar/ros/scan_messages.h"

#include <cmath>
#include <string>

#include "vfh_astar/ros/geometry_messages.h"
#include "vfh_astar/ros/message_error.h"

namespace vfh_astar {

LaserMount ToLaserMount(const geometry_msgs::Transform& transform) {
  constexpr double kLevelCosine = 0.94;  // of 20 degrees.
  const geometry_msgs::Quaternion& q = transform.rotation;
  // The z component of where the rotation takes the laser's z axis.
  const double up = 1.0 - 2.0 * (q.x * q.x + q.y * q.y);
  // Written so that NaN fails.
  if (!(std::abs(up) >= kLevelCosine)) {
    throw MessageError("the laser is tilted by " +
                       std::to_string(std::acos(up)) +
                       " rad; expected it level, upright or upside down");
  }
  LaserMount mount;
  // Where the rotation takes the laser's x axis is its heading either way.
  mount.pose = ToPose2D(transform);
  mount.upside_down = up < 0.0;
  return mount;
}

LaserScan ToLaserScan(const sensor_msgs::LaserScan& message, bool upside_down) {
  const double sign = upside_down ? -1.0 : 1.0;
  LaserScan scan;
  scan.stamp = message.header.stamp.toSec();
  scan.angle_min = sign * message.angle_min;
  scan.angle_increment = sign * message.angle_increment;
  scan.range_min = message.range_min;
  scan.range_max = message.range_max;
  scan.ranges = message.ranges;
  return scan;
}

}  // namespace vfh_astar
