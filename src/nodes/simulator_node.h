#ifndef VFH_ASTAR_NODES_SIMULATOR_NODE_H_
#define VFH_ASTAR_NODES_SIMULATOR_NODE_H_

#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <std_srvs/SetBool.h>
#include <tf2_ros/static_transform_broadcaster.h>
#include <vfh_astar/Delete.h>
#include <vfh_astar/Reset.h>
#include <vfh_astar/SetPose.h>
#include <vfh_astar/Spawn.h>
#include <vfh_astar/Step.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "pace.h"
#include "robot_topics.h"
#include "simulator_parameters.h"
#include "vfh_astar/simulation/simulation.h"

namespace vfh_astar {

/// A Simulation under ROS: gives it the time, hands it the commands, publishes
/// what becomes of them and /clock. With one robot its topics are in the node's
/// own namespace and its frames have no prefix; of several each has a namespace
/// and a tf prefix by its name.
///
/// Everything runs in the thread that calls Run().
class SimulatorNode {
 public:
  /// @throws WorldFileError, MapFileError, ParameterError or
  ///   std::invalid_argument with a sentence for the user.
  explicit SimulatorNode(const SimulatorParameters& parameters);

  /// Returns when ROS shuts down.
  void Run();

 private:
  void AddRobots();
  void AdvertiseServices();

  /// Handles what has come in, after waiting for it at most so long.
  /// @param[in] patience s of the wall clock.
  void Serve(double patience);

  /// Seconds of the wall clock, at most, until the simulation may go on.
  double WaitTime();

  /// As WaitTime, for the answers to the last scans alone.
  double HoldTime();

  /// Handles commands and answers until the last scans are answered, or given
  /// up.
  void AwaitAnswers();

  void PublishClock();

  /// Steps on to where something new is to be published, and publishes it.
  /// @return the number of steps, `max_steps` at most.
  int Advance(int max_steps);

  /// The number of a robot; an empty name is the first.
  std::optional<std::size_t> FindRobot(const std::string& name) const;

  bool OnReset(Reset::Request& request, Reset::Response& response);
  bool OnPause(std_srvs::SetBool::Request& request,
               std_srvs::SetBool::Response& response);
  bool OnStep(Step::Request& request, Step::Response& response);
  bool OnSetPose(SetPose::Request& request, SetPose::Response& response);
  bool OnSpawn(Spawn::Request& request, Spawn::Response& response);
  bool OnDelete(Delete::Request& request, Delete::Response& response);

  SimulatorParameters parameters_;
  Simulation simulation_;
  std::uint32_t seed_;
  int steps_per_tick_;  ///< of the clock, at most.
  Pace pace_;
  bool is_paused_ = false;
  bool is_held_ = false;        ///< for the answers to the last scan,
  double hold_deadline_ = 0.0;  ///< s of the wall clock, at most until then.

  // Two queues: commands and answers also come in while `step` is served.
  ros::CallbackQueue topic_queue_;
  ros::CallbackQueue service_queue_;
  std::vector<std::unique_ptr<RobotTopics>> robots_;
  tf2_ros::StaticTransformBroadcaster static_broadcaster_;
  ros::Publisher clock_publisher_;
  std::vector<ros::ServiceServer> services_;
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_NODES_SIMULATOR_NODE_H_
