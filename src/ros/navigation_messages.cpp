#include "vfh_astar/ros/navigation_messages.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "vfh_astar/ros/geometry_messages.h"

namespace vfh_astar {
namespace {

constexpr double kInnerRadius = 0.5;  // m, where the bars begin.
constexpr double kBarLength = 1.0;    // m, of a sector with density 1.
constexpr double kBarWidth = 0.03;    // m
constexpr double kDiscHeight = 0.02;  // m, of what moves.
constexpr double kLineWidth = 0.015;  // m, of the stopping zone's outlines.
constexpr double kLift = 0.05;        // m above the ground.

visualization_msgs::Marker NewMarker(const std_msgs::Header& header,
                                     const char* name, int id, int type) {
  visualization_msgs::Marker marker;
  marker.header = header;
  marker.ns = name;
  marker.id = id;
  marker.type = type;
  marker.action = visualization_msgs::Marker::ADD;
  marker.pose.position.z = kLift;
  marker.pose.orientation.w = 1.0;
  return marker;
}

std_msgs::ColorRGBA Colour(float r, float g, float b) {
  std_msgs::ColorRGBA colour;
  colour.r = r;
  colour.g = g;
  colour.b = b;
  colour.a = 0.8f;
  return colour;
}

visualization_msgs::Marker Bars(const NavigatorStatus& status,
                                const std_msgs::Header& header) {
  visualization_msgs::Marker bars =
      NewMarker(header, "vfh", 0, visualization_msgs::Marker::LINE_LIST);
  bars.scale.x = kBarWidth;
  const std::size_t sectors = status.vfh_histogram.size();
  for (std::size_t i = 0; i < sectors; ++i) {
    const double angle = 2.0 * kPi * (i + 0.5) / sectors - kPi;
    const Eigen::Vector2d along(std::cos(angle), std::sin(angle));
    // A sector without density still shows as a short bar.
    const double length =
        kBarWidth + kBarLength * std::min(1.0, status.vfh_histogram[i]);
    bars.points.push_back(ToPointMessage(kInnerRadius * along));
    bars.points.push_back(ToPointMessage((kInnerRadius + length) * along));
    const std_msgs::ColorRGBA colour = status.vfh_blocked[i]
                                           ? Colour(0.9f, 0.1f, 0.1f)
                                           : Colour(0.1f, 0.8f, 0.2f);
    bars.colors.insert(bars.colors.end(), 2, colour);
  }
  return bars;
}

visualization_msgs::Marker DirectionArrow(const NavigatorStatus& status,
                                          const std_msgs::Header& header) {
  visualization_msgs::Marker arrow =
      NewMarker(header, "vfh", 1, visualization_msgs::Marker::ARROW);
  arrow.pose = ToPoseMessage({0.0, 0.0, status.vfh_direction});
  arrow.pose.position.z = kLift;
  arrow.scale.x = kInnerRadius + kBarLength;
  arrow.scale.y = 0.05;
  arrow.scale.z = 0.05;
  arrow.color = Colour(1.0f, 0.8f, 0.0f);
  return arrow;
}

visualization_msgs::Marker Disc(const MovingObstacle& mover,
                                const std_msgs::Header& header, int id) {
  visualization_msgs::Marker disc =
      NewMarker(header, "disc", id, visualization_msgs::Marker::CYLINDER);
  disc.pose.position = ToPointMessage(mover.position);
  disc.pose.position.z = kLift;
  disc.scale.x = disc.scale.y = 2.0 * mover.radius;
  disc.scale.z = kDiscHeight;
  disc.color = Colour(0.9f, 0.4f, 0.9f);
  return disc;
}

visualization_msgs::Marker WayArrow(const MovingObstacle& mover,
                                    const std_msgs::Header& header, int id) {
  visualization_msgs::Marker arrow =
      NewMarker(header, "velocity", id, visualization_msgs::Marker::ARROW);
  arrow.points = {ToPointMessage(mover.position),
                  ToPointMessage(mover.At(1.0))};
  arrow.scale.x = 0.05;  // of the shaft,
  arrow.scale.y = 0.12;  // and of the head
  arrow.color = Colour(0.9f, 0.1f, 0.9f);
  return arrow;
}

}  // namespace

NavigationState ToStateMessage(const NavigatorStatus& status,
                               const std_msgs::Header& header,
                               const ros::Time& scan_stamp) {
  NavigationState message;
  message.header = header;
  message.scan_stamp = scan_stamp;
  message.state = ToString(status.state);
  message.reason = status.reason;
  message.goal_id = status.goal_id;
  message.error_x = status.error.x();
  message.error_y = status.error.y();
  message.error_theta = status.error.z();
  message.clearance = status.clearance;
  message.speed = status.speed;
  message.distance_to_goal = status.distance_to_goal;
  message.replans = status.replans;
  message.limited = status.limited;
  return message;
}

geometry_msgs::PolygonStamped ToPolygonMessage(const Footprint& footprint,
                                               const std_msgs::Header& header) {
  geometry_msgs::PolygonStamped polygon;
  polygon.header = header;
  for (const Eigen::Vector2d& corner : footprint.Corners()) {
    geometry_msgs::Point32 point;
    point.x = static_cast<float>(corner.x());
    point.y = static_cast<float>(corner.y());
    polygon.polygon.points.push_back(point);
  }
  return polygon;
}

visualization_msgs::MarkerArray ToHistogramMarkers(
    const NavigatorStatus& status, const std_msgs::Header& header) {
  assert(!status.vfh_histogram.empty());
  assert(status.vfh_blocked.size() == status.vfh_histogram.size());
  visualization_msgs::MarkerArray markers;
  markers.markers = {Bars(status, header), DirectionArrow(status, header)};
  return markers;
}

visualization_msgs::MarkerArray ToTrackMarkers(
    const std::vector<MovingObstacle>& movers, const std_msgs::Header& header) {
  visualization_msgs::MarkerArray markers = ClearedMarkers(header);
  for (std::size_t i = 0; i < movers.size(); ++i) {
    const int id = static_cast<int>(i);
    markers.markers.push_back(Disc(movers[i], header, id));
    markers.markers.push_back(WayArrow(movers[i], header, id));
  }
  return markers;
}

visualization_msgs::MarkerArray ToStoppingZoneMarkers(
    const std::vector<Pose2D>& motion, const Footprint& footprint, bool limited,
    const std_msgs::Header& header) {
  visualization_msgs::Marker zone = NewMarker(
      header, "stopping_zone", 0, visualization_msgs::Marker::LINE_LIST);
  zone.scale.x = kLineWidth;
  zone.color = limited ? Colour(0.9f, 0.1f, 0.1f) : Colour(0.1f, 0.8f, 0.2f);
  const auto corners = footprint.Corners();
  for (const Pose2D& pose : motion) {
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const std::size_t next = (i + 1) % corners.size();
      zone.points.push_back(ToPointMessage(pose * corners[i]));
      zone.points.push_back(ToPointMessage(pose * corners[next]));
    }
  }
  visualization_msgs::MarkerArray markers;
  markers.markers.push_back(std::move(zone));
  return markers;
}

visualization_msgs::MarkerArray ClearedMarkers(const std_msgs::Header& header) {
  visualization_msgs::MarkerArray markers;
  markers.markers.push_back(
      NewMarker(header, "", 0, visualization_msgs::Marker::ARROW));
  markers.markers.back().action = visualization_msgs::Marker::DELETEALL;
  return markers;
}

}  // namespace vfh_astar
