#include "vfh_astar/ros/navigation_display.h"

#include "vfh_astar/control/safety_limiter.h"
#include "vfh_astar/ros/navigation_messages.h"

namespace vfh_astar {

MarkerTopic::MarkerTopic(ros::NodeHandle node, const std::string& name)
    : publisher_(node.advertise<visualization_msgs::MarkerArray>(name, 1)) {}

void MarkerTopic::Publish(const visualization_msgs::MarkerArray& markers) {
  publisher_.publish(markers);
  is_shown_ = true;
}

void MarkerTopic::Clear(const std_msgs::Header& header) {
  if (is_shown_) publisher_.publish(ClearedMarkers(header));
  is_shown_ = false;
}

NavigationDisplay::NavigationDisplay(ros::NodeHandle node,
                                     const FrameNames& frames)
    : footprint_(node.advertise<geometry_msgs::PolygonStamped>("footprint", 1)),
      histogram_(node, "vfh_histogram"),
      tracks_(node, "tracks"),
      stopping_zone_(node, "stopping_zone") {
  in_base_.frame_id = frames.base_frame;
  in_map_.frame_id = frames.map_frame;
}

void NavigationDisplay::Show(const NavigatorOutput& output,
                             const NavigatorParameters& parameters,
                             const ros::Time& stamp) {
  in_base_.stamp = in_map_.stamp = stamp;
  if (footprint_.getNumSubscribers() > 0) {
    footprint_.publish(ToPolygonMessage(parameters.footprint, in_base_));
  }
  if (histogram_.HasSubscriber()) ShowHistogram(output.status);
  if (tracks_.HasSubscriber()) ShowTracks(output.status);
  if (stopping_zone_.HasSubscriber()) ShowStoppingZone(output, parameters);
}

void NavigationDisplay::ShowHistogram(const NavigatorStatus& status) {
  if (status.vfh_histogram.empty()) {
    histogram_.Clear(in_base_);
  } else {
    histogram_.Publish(ToHistogramMarkers(status, in_base_));
  }
}

void NavigationDisplay::ShowTracks(const NavigatorStatus& status) {
  if (status.movers.empty()) {
    tracks_.Clear(in_map_);
  } else {
    tracks_.Publish(ToTrackMarkers(status.movers, in_map_));
  }
}

void NavigationDisplay::ShowStoppingZone(
    const NavigatorOutput& output, const NavigatorParameters& parameters) {
  if (!output.command) {
    stopping_zone_.Clear(in_base_);
    return;
  }
  const SafetyLimiter limiter(parameters.safety, parameters.footprint);
  stopping_zone_.Publish(ToStoppingZoneMarkers(
      limiter.StoppingMotion(*output.command),
      parameters.footprint.Grown(parameters.safety.margin),
      output.status.limited, in_base_));
}

}  // namespace vfh_astar
