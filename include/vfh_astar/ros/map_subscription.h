#ifndef VFH_ASTAR_ROS_MAP_SUBSCRIPTION_H_
#define VFH_ASTAR_ROS_MAP_SUBSCRIPTION_H_

#include <ros/node_handle.h>
#include <ros/subscriber.h>

#include <string>

#include "vfh_astar/ros/map_messages.h"

namespace vfh_astar {

/// A MapReceiver over the topics `map` and `map_updates`. Messages that cannot
/// be used are dropped, and an error says why.
class MapSubscription {
 public:
  /// @param[in] node whose callback queue calls the two functions.
  /// @param[in] map_frame the frame that the messages have to be in.
  MapSubscription(ros::NodeHandle node, const std::string& map_frame,
                  MapReceiver::TakeMap take_map,
                  MapReceiver::TakeWindow take_window);
  MapSubscription(const MapSubscription&) = delete;
  MapSubscription& operator=(const MapSubscription&) = delete;

 private:
  template <typename Message>
  ros::Subscriber Subscribe(ros::NodeHandle& node, const std::string& topic,
                            int queue_size);

  MapReceiver receiver_;
  ros::Subscriber map_subscriber_;
  ros::Subscriber update_subscriber_;
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_ROS_MAP_SUBSCRIPTION_H_
