#ifndef VFH_ASTAR_ROS_NAVIGATION_MESSAGES_H_
#define VFH_ASTAR_ROS_NAVIGATION_MESSAGES_H_

#include <geometry_msgs/PolygonStamped.h>
#include <std_msgs/Header.h>
#include <vfh_astar/NavigationState.h>
#include <visualization_msgs/MarkerArray.h>

#include <string>
#include <vector>

#include "vfh_astar/footprint.h"
#include "vfh_astar/navigation/navigator.h"

namespace vfh_astar {

/// @param[in] header the cycle's time, and the map frame.
/// @param[in] scan_stamp of the newest scan used, 0 before the first.
NavigationState ToStateMessage(const NavigatorStatus& status,
                               const std_msgs::Header& header,
                               const ros::Time& scan_stamp);

/// The footprint in the robot's frame.
geometry_msgs::PolygonStamped ToPolygonMessage(const Footprint& footprint,
                                               const std_msgs::Header& header);

/// The histogram as bars around the robot, as long as its sectors are dense,
/// red where blocked and green where open, and an arrow along the chosen
/// direction.
/// @param[in] header the cycle's time, and the robot's frame.
/// @pre status.vfh_histogram is not empty.
visualization_msgs::MarkerArray ToHistogramMarkers(
    const NavigatorStatus& status, const std_msgs::Header& header);

/// What moves: a disc as large as each is, and an arrow as long as its way in
/// one second. The markers of an earlier message are taken away.
/// @param[in] movers in the frame of the header.
visualization_msgs::MarkerArray ToTrackMarkers(
    const std::vector<MovingObstacle>& movers, const std_msgs::Header& header);

/// The zone that must be free for a command: the outline of a footprint at each
/// pose of a motion, green, or red when the safety limiter had to change what
/// was wanted.
/// @param[in] motion in the robot's frame, which is the header's.
visualization_msgs::MarkerArray ToStoppingZoneMarkers(
    const std::vector<Pose2D>& motion, const Footprint& footprint, bool limited,
    const std_msgs::Header& header);

/// Takes all markers of the topic away.
visualization_msgs::MarkerArray ClearedMarkers(const std_msgs::Header& header);

}  // namespace vfh_astar

#endif  // VFH_ASTAR_ROS_NAVIGATION_MESSAGES_H_
