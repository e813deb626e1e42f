#include <ros/init.h>
#include <ros/node_handle.h>

#include <exception>
#include <string>

#include "simulator_node.h"
#include "vfh_astar/ros/ros_parameter_reader.h"

namespace {

/// An override of the start that is empty is none: a launch file cannot leave a
/// parameter out as easily as it can leave it empty.
void DropEmptyOverrides(ros::NodeHandle node) {
  for (const char* name : {"x", "y", "yaw", "solid_below"}) {
    std::string text;
    if (node.getParam(name, text) && text.empty()) node.deleteParam(name);
  }
}

void WarnOfWallClock() {
  bool is_time_simulated = false;
  ros::param::get("/use_sim_time", is_time_simulated);
  if (!is_time_simulated) {
    ROS_WARN("/use_sim_time is not set: other nodes will not use /clock");
  }
}

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "simulator");
  // With its last handle ROS ends, and with ROS the log.
  const ros::NodeHandle private_node("~");
  try {
    DropEmptyOverrides(private_node);
    WarnOfWallClock();
    vfh_astar::SimulatorNode node(
        vfh_astar::ReadParameters<vfh_astar::SimulatorParameters>(
            private_node));
    node.Run();
  } catch (const vfh_astar::ParameterError&) {
    return 1;  // Logged where it was read.
  } catch (const std::exception& error) {
    ROS_FATAL("%s", error.what());
    return 1;
  }
  return 0;
}
