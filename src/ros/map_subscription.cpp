#include "vfh_astar/ros/map_subscription.h"

#include <ros/console.h>

#include <utility>

#include "vfh_astar/ros/message_error.h"

namespace vfh_astar {

MapSubscription::MapSubscription(ros::NodeHandle node,
                                 const std::string& map_frame,
                                 MapReceiver::TakeMap take_map,
                                 MapReceiver::TakeWindow take_window)
    : receiver_(map_frame, std::move(take_map), std::move(take_window)),
      map_subscriber_(Subscribe<nav_msgs::OccupancyGrid>(node, "map", 1)),
      update_subscriber_(
          Subscribe<map_msgs::OccupancyGridUpdate>(node, "map_updates", 100)) {}

template <typename Message>
ros::Subscriber MapSubscription::Subscribe(ros::NodeHandle& node,
                                           const std::string& topic,
                                           int queue_size) {
  const std::string name = node.resolveName(topic);
  return node.subscribe<Message>(
      topic, queue_size,
      [this, name](const boost::shared_ptr<const Message>& message) {
        try {
          receiver_.Receive(*message);
        } catch (const MessageError& error) {
          ROS_ERROR_THROTTLE(10.0, "a message on %s is dropped: %s",
                             name.c_str(), error.what());
        }
      });
}

}  // namespace vfh_astar
