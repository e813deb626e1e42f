#include "vfh_astar/ros/geometry_messages.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "vfh_astar/ros/message_error.h"

namespace vfh_astar {
namespace {

geometry_msgs::Pose MakePose(double x, double qx, double qy, double qz,
                             double qw) {
  geometry_msgs::Pose pose;
  pose.position.x = x;
  pose.orientation.x = qx;
  pose.orientation.y = qy;
  pose.orientation.z = qz;
  pose.orientation.w = qw;
  return pose;
}

TEST(GeometryMessagesTest, PosesSurviveTheWayThereAndBack) {
  for (double theta = -3.1; theta < 3.14; theta += 0.1) {
    const Pose2D pose(1.5, -2.5, theta);
    const Pose2D there = ToPose2D(ToPoseMessage(pose));
    EXPECT_EQ(there.x, 1.5);
    EXPECT_EQ(there.y, -2.5);
    EXPECT_NEAR(there.theta, theta, 1e-12);
    EXPECT_NEAR(ToPose2D(ToTransformMessage(pose)).theta, theta, 1e-12);
  }
}

TEST(GeometryMessagesTest, YawDoesNotDependOnTheQuaternionsLength) {
  geometry_msgs::Quaternion rotation;
  rotation.z = 3.0 * std::sin(0.25);
  rotation.w = 3.0 * std::cos(0.25);
  EXPECT_NEAR(Yaw(rotation), 0.5, 1e-12);
}

TEST(GeometryMessagesTest, TwistsKeepTheirTwoParts) {
  const geometry_msgs::Twist message = ToTwistMessage({0.5, -1.5});
  EXPECT_EQ(message.linear.x, 0.5);
  EXPECT_EQ(message.linear.y, 0.0);
  EXPECT_EQ(message.angular.z, -1.5);
  EXPECT_EQ(ToTwist2D(message).v, 0.5);
  EXPECT_EQ(ToTwist2D(message).w, -1.5);
}

TEST(GeometryMessagesTest, NamesWhatIsWrongWithAPose) {
  EXPECT_FALSE(DescribeDefect(MakePose(1.0, 0.0, 0.0, 0.6, 0.8)));
  EXPECT_FALSE(DescribeDefect(MakePose(1.0, 0.0, 0.0, 0.0, -2.0)));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(DescribeDefect(MakePose(nan, 0.0, 0.0, 0.0, 1.0))->find("finite"),
            std::string::npos);
  EXPECT_TRUE(DescribeDefect(MakePose(HUGE_VAL, 0.0, 0.0, 0.0, 1.0)));
  EXPECT_NE(
      DescribeDefect(MakePose(1.0, 0.0, 0.0, 0.0, 0.0))->find("quaternion"),
      std::string::npos);
  EXPECT_TRUE(DescribeDefect(MakePose(1.0, nan, 0.0, 0.0, 1.0)));
  // Lying on its side, and upside down.
  const double half = std::sqrt(0.5);
  EXPECT_NE(DescribeDefect(MakePose(1.0, half, 0.0, 0.0, half))->find("tilt"),
            std::string::npos);
  EXPECT_TRUE(DescribeDefect(MakePose(1.0, 1.0, 0.0, 0.0, 0.0)));
}

TEST(GeometryMessagesTest, OneSlashIsTakenAway) {
  EXPECT_EQ(WithoutSlash("/front_laser"), "front_laser");
  EXPECT_EQ(WithoutSlash("robot/front_laser"), "robot/front_laser");
  EXPECT_EQ(WithoutSlash(""), "");
}

TEST(GeometryMessagesTest, AFrameIsTheOneExpectedOrRefused) {
  EXPECT_NO_THROW(CheckFrame("map", "map"));
  EXPECT_NO_THROW(CheckFrame("/map", "map"));
  EXPECT_THROW(CheckFrame("", "map"), MessageError);
  try {
    CheckFrame("odom", "map");
    FAIL() << "odom is not map";
  } catch (const MessageError& error) {
    EXPECT_STREQ(error.what(), "its frame is 'odom'; expected 'map'");
  }
}

}  // namespace
}  // namespace vfh_astar
