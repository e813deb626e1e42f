#ifndef VFH_ASTAR_ROS_NAVIGATION_DISPLAY_H_
#define VFH_ASTAR_ROS_NAVIGATION_DISPLAY_H_

#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <visualization_msgs/MarkerArray.h>

#include <string>

#include "vfh_astar/navigation/navigator.h"
#include "vfh_astar/ros/frame_names.h"

namespace vfh_astar {

/// A topic of markers that are taken away once when there are none to show.
class MarkerTopic {
 public:
  MarkerTopic(ros::NodeHandle node, const std::string& name);

  bool HasSubscriber() const { return publisher_.getNumSubscribers() > 0; }

  void Publish(const visualization_msgs::MarkerArray& markers);
  void Clear(const std_msgs::Header& header);

 private:
  ros::Publisher publisher_;
  bool is_shown_ = false;
};

/// What RViz shows of the navigator: `footprint`, `vfh_histogram`, `tracks` and
/// `stopping_zone`. Nothing is made or published for which nobody has
/// subscribed.
class NavigationDisplay {
 public:
  NavigationDisplay(ros::NodeHandle node, const FrameNames& frames);

  /// After every cycle.
  /// @param[in] stamp of the cycle.
  void Show(const NavigatorOutput& output,
            const NavigatorParameters& parameters, const ros::Time& stamp);

 private:
  void ShowHistogram(const NavigatorStatus& status);
  void ShowTracks(const NavigatorStatus& status);
  void ShowStoppingZone(const NavigatorOutput& output,
                        const NavigatorParameters& parameters);

  std_msgs::Header in_base_;  ///< of this cycle.
  std_msgs::Header in_map_;
  ros::Publisher footprint_;
  MarkerTopic histogram_;
  MarkerTopic tracks_;
  MarkerTopic stopping_zone_;
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_ROS_NAVIGATION_DISPLAY_H_
