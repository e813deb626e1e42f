#ifndef VFH_ASTAR_NAVIGATION_ARRIVAL_H_
#define VFH_ASTAR_NAVIGATION_ARRIVAL_H_

#include <string>

#include "vfh_astar/geometry.h"
#include "vfh_astar/navigation/navigator_parameters.h"

namespace vfh_astar {

/// The last metre: latches the position once it is within tolerance, so that
/// turning to the goal's heading is not undone by chasing the position again,
/// and reports arrival only when the robot stands.
class Arrival {
 public:
  /// @param[in] parameters kept by reference: changes count at once.
  explicit Arrival(const GoalParameters& parameters)
      : parameters_(parameters) {}

  void Reset() { latched_ = false; }

  /// True once the position has been within tolerance of the end since the last
  /// Reset.
  bool latched() const { return latched_; }

  /// @return true when position is latched, heading within tolerance and the
  ///   robot standing.
  bool Update(const Pose2D& pose, const Twist2D& twist, const Pose2D& end);

 private:
  const GoalParameters& parameters_;
  bool latched_ = false;
};

/// True when the robot stands, as far as its odometry can tell.
bool IsStanding(const Twist2D& twist, const GoalParameters& parameters);

/// Says how near to the goal the robot was brought.
/// @param[in] end of the trajectory that was followed, map frame.
/// @param[in] goal that was asked for, map frame.
std::string ArrivalMessage(const Pose2D& end, const Pose2D& goal,
                           const GoalParameters& parameters);

}  // namespace vfh_astar

#endif  // VFH_ASTAR_NAVIGATION_ARRIVAL_H_
