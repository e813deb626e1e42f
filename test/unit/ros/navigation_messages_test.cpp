#include "vfh_astar/ros/navigation_messages.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

namespace vfh_astar {
namespace {

NavigatorStatus AvoidingStatus() {
  NavigatorStatus status;
  status.state = State::kAvoiding;
  status.reason = "obstacle ahead";
  status.goal_id = "goal";
  status.error = {0.1, -0.2, 0.3};
  status.clearance = 0.5;
  status.speed = 0.25;
  status.distance_to_goal = 7.0;
  status.replans = 3;
  status.limited = true;
  status.vfh_histogram = {0.0, 0.5, 1.0, 4.0};
  status.vfh_blocked = {false, false, true, true};
  status.vfh_direction = 1.25;
  return status;
}

std_msgs::Header MakeHeader(const std::string& frame) {
  std_msgs::Header header;
  header.frame_id = frame;
  header.stamp = ros::Time(3);
  return header;
}

TEST(NavigationMessagesTest, TheStateSaysItAll) {
  const NavigationState message =
      ToStateMessage(AvoidingStatus(), MakeHeader("map"), ros::Time(2));
  EXPECT_EQ(message.header.stamp, ros::Time(3));
  EXPECT_EQ(message.scan_stamp, ros::Time(2));
  EXPECT_EQ(message.state, "AVOIDING");
  EXPECT_EQ(message.reason, "obstacle ahead");
  EXPECT_EQ(message.goal_id, "goal");
  EXPECT_EQ(message.error_x, 0.1);
  EXPECT_EQ(message.error_y, -0.2);
  EXPECT_EQ(message.error_theta, 0.3);
  EXPECT_EQ(message.clearance, 0.5);
  EXPECT_EQ(message.speed, 0.25);
  EXPECT_EQ(message.distance_to_goal, 7.0);
  EXPECT_EQ(message.replans, 3);
  EXPECT_TRUE(message.limited);
}

TEST(NavigationMessagesTest, TheFootprintHasItsFourCorners) {
  const auto polygon =
      ToPolygonMessage({0.4, 0.3, 0.2}, MakeHeader("base_link"));
  ASSERT_EQ(polygon.polygon.points.size(), 4u);
  EXPECT_FLOAT_EQ(polygon.polygon.points[0].x, 0.4f);
  EXPECT_FLOAT_EQ(polygon.polygon.points[0].y, 0.2f);
  EXPECT_FLOAT_EQ(polygon.polygon.points[2].x, -0.3f);
}

TEST(NavigationMessagesTest, TheHistogramPointsWhereItsSectorsDo) {
  const auto markers =
      ToHistogramMarkers(AvoidingStatus(), MakeHeader("base_link")).markers;
  ASSERT_EQ(markers.size(), 2u);
  const visualization_msgs::Marker& bars = markers[0];
  ASSERT_EQ(bars.points.size(), 8u);
  ASSERT_EQ(bars.colors.size(), 8u);
  // Four sectors from -pi on: their middles are at -135, -45, 45, 135 degrees.
  const double expected[] = {-0.75 * kPi, -0.25 * kPi, 0.25 * kPi, 0.75 * kPi};
  double last_length = 0.0;
  for (int i = 0; i < 4; ++i) {
    const geometry_msgs::Point& from = bars.points[2 * i];
    const geometry_msgs::Point& to = bars.points[2 * i + 1];
    EXPECT_NEAR(std::atan2(to.y, to.x), expected[i], 1e-12);
    const double length = std::hypot(to.x - from.x, to.y - from.y);
    // Denser is longer, and 1 is the most.
    EXPECT_GE(length, last_length - 1e-12);
    last_length = length;
    const bool is_red = bars.colors[2 * i].r > bars.colors[2 * i].g;
    EXPECT_EQ(is_red, i >= 2);
  }
  EXPECT_NEAR(last_length, 1.0, 0.05);
  EXPECT_NEAR(markers[1].pose.orientation.z, std::sin(0.625), 1e-12);
}

TEST(NavigationMessagesTest, ATrackIsADiscAndItsWayOfASecond) {
  MovingObstacle mover;
  mover.position = {2.0, -1.0};
  mover.velocity = {-0.5, 1.5};
  mover.radius = 0.4;
  const auto markers =
      ToTrackMarkers({MovingObstacle(), mover}, MakeHeader("map")).markers;
  ASSERT_EQ(markers.size(), 5u);
  EXPECT_EQ(markers[0].action, visualization_msgs::Marker::DELETEALL)
      << "what is gone must not stay in sight";
  const visualization_msgs::Marker& disc = markers[3];
  EXPECT_EQ(disc.type, visualization_msgs::Marker::CYLINDER);
  EXPECT_EQ(disc.header.frame_id, "map");
  EXPECT_EQ(disc.pose.position.x, 2.0);
  EXPECT_EQ(disc.pose.position.y, -1.0);
  EXPECT_DOUBLE_EQ(disc.scale.x, 0.8);
  const visualization_msgs::Marker& arrow = markers[4];
  ASSERT_EQ(arrow.points.size(), 2u);
  EXPECT_EQ(arrow.points[0].x, 2.0);
  EXPECT_EQ(arrow.points[1].x, 1.5);
  EXPECT_EQ(arrow.points[1].y, 0.5);
  EXPECT_NE(std::make_pair(disc.ns, disc.id),
            std::make_pair(markers[1].ns, markers[1].id));
}

TEST(NavigationMessagesTest, TheStoppingZoneIsTheFootprintAlongTheMotion) {
  const Footprint footprint{0.4, 0.3, 0.2};
  const std::vector<Pose2D> motion = {{}, {1.0, 0.0, 0.5 * kPi}};
  const auto free =
      ToStoppingZoneMarkers(motion, footprint, false, MakeHeader("base_link"))
          .markers;
  ASSERT_EQ(free.size(), 1u);
  EXPECT_EQ(free[0].type, visualization_msgs::Marker::LINE_LIST);
  ASSERT_EQ(free[0].points.size(), 16u) << "two outlines of four edges";
  EXPECT_NEAR(free[0].points[0].x, 0.4, 1e-12);
  EXPECT_NEAR(free[0].points[0].y, 0.2, 1e-12);
  // The same corner (0.4, 0.2), turned by 90 degrees and moved 1 m ahead.
  EXPECT_NEAR(free[0].points[8].x, 0.8, 1e-12);
  EXPECT_NEAR(free[0].points[8].y, 0.4, 1e-12);
  for (int edge = 0; edge < 4; ++edge) {
    const auto& end = free[0].points[2 * edge + 1];
    const auto& next = free[0].points[(2 * edge + 2) % 8];
    EXPECT_EQ(end.x, next.x);
    EXPECT_EQ(end.y, next.y);
  }
  EXPECT_GT(free[0].color.g, free[0].color.r);
  const auto limited =
      ToStoppingZoneMarkers(motion, footprint, true, MakeHeader("base_link"))
          .markers;
  EXPECT_GT(limited[0].color.r, limited[0].color.g);
}

TEST(NavigationMessagesTest, ClearingTakesAllMarkersAway) {
  const auto markers = ClearedMarkers(MakeHeader("base_link")).markers;
  ASSERT_EQ(markers.size(), 1u);
  EXPECT_EQ(markers[0].action, visualization_msgs::Marker::DELETEALL);
}

}  // namespace
}  // namespace vfh_astar
