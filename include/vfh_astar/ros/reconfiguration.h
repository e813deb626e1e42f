#ifndef VFH_ASTAR_ROS_RECONFIGURATION_H_
#define VFH_ASTAR_ROS_RECONFIGURATION_H_

#include <dynamic_reconfigure/server.h>
#include <ros/node_handle.h>
#include <vfh_astar/GoalConfig.h>
#include <vfh_astar/LimitsConfig.h>
#include <vfh_astar/SafetyConfig.h>

#include <boost/thread/recursive_mutex.hpp>
#include <cstdint>
#include <functional>

#include "vfh_astar/control/safety_limiter.h"
#include "vfh_astar/navigation/navigator_parameters.h"
#include "vfh_astar/robot_limits.h"

namespace vfh_astar {

/// A dynamic_reconfigure server for one group of parameters. It stands at the
/// group's own place on the parameter server, so that a value has one name,
/// whoever sets it.
template <typename Config>
class Reconfiguration {
 public:
  /// @param[in] node of the group, e.g. ~limits.
  /// @param[in] initial the values as they were read.
  /// @param[in] changed called with the values on every change, and once now.
  Reconfiguration(const ros::NodeHandle& node, const Config& initial,
                  std::function<void(const Config&)> changed)
      : server_(mutex_, node) {
    // Without it the server would begin with the defaults of its .cfg file.
    server_.updateConfig(initial);
    server_.setCallback(
        [changed](Config& config, std::uint32_t) { changed(config); });
  }

 private:
  boost::recursive_mutex mutex_;
  dynamic_reconfigure::Server<Config> server_;
};

/// The values that may change while driving, out of their structs,
LimitsConfig ToConfig(const RobotLimits& limits);
GoalConfig ToConfig(const GoalParameters& goal);
SafetyConfig ToConfig(const SafetyLimiterParameters& safety);

/// and back into them.
void Apply(const LimitsConfig& config, RobotLimits& limits);
void Apply(const GoalConfig& config, GoalParameters& goal);
void Apply(const SafetyConfig& config, SafetyLimiterParameters& safety);

}  // namespace vfh_astar

#endif  // VFH_ASTAR_ROS_RECONFIGURATION_H_
