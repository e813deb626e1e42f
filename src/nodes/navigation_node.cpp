#include <nodelet/loader.h>
#include <ros/console.h>
#include <ros/init.h>
#include <ros/names.h>

#include <opencv2/core/utility.hpp>
#include <string>

namespace {

/// A section of the configuration has the nodelet's name.
struct HostedNodelet {
  const char* name;
  const char* type;
};

constexpr HostedNodelet kNodelets[] = {
    {"grid_mapper", "vfh_astar/GridMapper"},
    {"path_planner", "vfh_astar/PathPlanner"},
    {"trajectory_fitter", "vfh_astar/TrajectoryFitter"},
    {"navigator", "vfh_astar/Navigator"}};

}  // namespace

/// The navigation in one process: a nodelet manager that has the four nodelets
/// from the start. Others (a laser's driver) may be loaded into it.
int main(int argc, char** argv) {
  ros::init(argc, argv, "navigation_manager");
  // The windows that change are so small that to wake another thread takes
  // longer than to wait for it saves.
  cv::setNumThreads(1);
  nodelet::Loader loader;
  for (const HostedNodelet& nodelet : kNodelets) {
    const std::string name = ros::names::resolve(nodelet.name);
    if (!loader.load(name, nodelet.type, ros::names::getRemappings(), {})) {
      // Without one of them the others are of no use.
      ROS_FATAL("%s (%s) does not start", name.c_str(), nodelet.type);
      return 1;
    }
  }
  ros::spin();
  return 0;
}
