#ifndef VFH_ASTAR_ROS_MOTION_MESSAGES_H_
#define VFH_ASTAR_ROS_MOTION_MESSAGES_H_

#include <nav_msgs/Path.h>
#include <ros/time.h>
#include <vfh_astar/MotionFailure.h>
#include <vfh_astar/MotionQuery.h>
#include <vfh_astar/QuinticTrajectory.h>

#include <Eigen/Core>
#include <string>
#include <vector>

#include "vfh_astar/geometry.h"
#include "vfh_astar/navigation/motion_request.h"
#include "vfh_astar/outcome.h"
#include "vfh_astar/planning/path_planner.h"
#include "vfh_astar/trajectory/trajectory.h"
#include "vfh_astar/trajectory/trajectory_fitter.h"

namespace vfh_astar {

/// @param[in] identity becomes the query's stamp.
MotionQuery ToQueryMessage(const MotionRequest& request,
                           const ros::Time& identity,
                           const std::string& frame_id);

/// @throws MessageError for poses in another frame than `frame_id`.
PlanRequest ToPlanRequest(const MotionQuery& query,
                          const std::string& frame_id);

/// @param[in] query may be null: the trajectory then starts at rest at the
///   path's first pose. The goal is the path's last pose either way, as the
///   planner may have moved it.
/// @throws MessageError for a path without poses and for numbers that are not
///   finite.
FitRequest ToFitRequest(const nav_msgs::Path& path, const MotionQuery* query);

/// A path in which every pose looks along it, and the last one as `goal` does.
/// @param[in] points not empty.
nav_msgs::Path ToPathMessage(const std::vector<Eigen::Vector2d>& points,
                             const Pose2D& goal, const std::string& frame_id,
                             const ros::Time& stamp);

/// The poses of a trajectory at equal times apart, for display; the stamp of
/// each is when the robot is to be there.
nav_msgs::Path ToPathMessage(const Trajectory& trajectory,
                             const std::string& frame_id,
                             const ros::Time& start);

QuinticTrajectory ToTrajectoryMessage(const Trajectory& trajectory,
                                      const std::string& frame_id,
                                      const ros::Time& start);

/// @throws MessageError for a trajectory without pieces and for a piece with an
///   unknown kind, a duration that is not positive or a coefficient that is not
///   finite.
Trajectory ToTrajectory(const QuinticTrajectory& message);

MotionFailure ToFailureMessage(const MotionQuery& query,
                               const std::string& stage, Outcome outcome,
                               const std::string& message);

/// The failure as an answer to its question. An outcome that is none counts as
/// a failure of unknown kind.
MotionAnswer ToAnswer(const MotionFailure& failure);

}  // namespace vfh_astar

#endif  // VFH_ASTAR_ROS_MOTION_MESSAGES_H_
