#include "vfh_astar/ros/scan_messages.h"

#include <gtest/gtest.h>

#include <cmath>

#include "vfh_astar/ros/message_error.h"

namespace vfh_astar {
namespace {

// A turn by yaw about z after one by roll about x.
geometry_msgs::Transform MakeTransform(double yaw, double roll) {
  geometry_msgs::Transform transform;
  transform.translation.x = 0.2;
  transform.rotation.x = std::cos(0.5 * yaw) * std::sin(0.5 * roll);
  transform.rotation.y = std::sin(0.5 * yaw) * std::sin(0.5 * roll);
  transform.rotation.z = std::sin(0.5 * yaw) * std::cos(0.5 * roll);
  transform.rotation.w = std::cos(0.5 * yaw) * std::cos(0.5 * roll);
  return transform;
}

sensor_msgs::LaserScan MakeScan() {
  sensor_msgs::LaserScan scan;
  scan.header.stamp = ros::Time(12, 500000000);
  scan.angle_min = -0.5f;
  scan.angle_increment = 0.25f;
  scan.range_min = 0.125f;
  scan.range_max = 30.0f;
  scan.ranges = {1.0f, 2.0f};
  return scan;
}

TEST(ScanMessagesTest, UprightLaser) {
  const LaserMount mount = ToLaserMount(MakeTransform(0.3, 0.0));
  EXPECT_FALSE(mount.upside_down);
  EXPECT_EQ(mount.pose.x, 0.2);
  EXPECT_NEAR(mount.pose.theta, 0.3, 1e-12);

  const LaserScan scan = ToLaserScan(MakeScan(), false);
  EXPECT_EQ(scan.stamp, 12.5);
  EXPECT_EQ(scan.angle_min, -0.5);
  EXPECT_EQ(scan.angle_increment, 0.25);
  EXPECT_EQ(scan.range_min, 0.125);
  EXPECT_EQ(scan.range_max, 30.0);
  EXPECT_EQ(scan.ranges, MakeScan().ranges);
}

TEST(ScanMessagesTest, LaserUpsideDownSeesLeftWhereItSaysRight) {
  const LaserMount mount = ToLaserMount(MakeTransform(0.0, kPi));
  EXPECT_TRUE(mount.upside_down);
  // Beam 0 points to the laser's right at -0.5 rad, and that is the robot's
  // left.
  const LaserScan scan = ToLaserScan(MakeScan(), mount.upside_down);
  const Eigen::Vector2d hit = HitPoints(scan, mount.pose, 30.0).at(0);
  EXPECT_NEAR(hit.x(), 0.2 + std::cos(0.5), 1e-6);
  EXPECT_NEAR(hit.y(), std::sin(0.5), 1e-6);
}

TEST(ScanMessagesTest, UpsideDownAndTurned) {
  // The rotation itself takes the beam to the same place.
  for (double yaw = -3.0; yaw < 3.1; yaw += 0.5) {
    const LaserMount mount = ToLaserMount(MakeTransform(yaw, kPi));
    ASSERT_TRUE(mount.upside_down);
    const LaserScan scan = ToLaserScan(MakeScan(), true);
    const Eigen::Vector2d hit = HitPoints(scan, mount.pose, 30.0).at(1);
    // Beam 1: 2 m at -0.25 rad; mirrored by the roll, then turned.
    EXPECT_NEAR(hit.x(), 0.2 + 2.0 * std::cos(yaw + 0.25), 1e-6);
    EXPECT_NEAR(hit.y(), 2.0 * std::sin(yaw + 0.25), 1e-6);
  }
}

TEST(ScanMessagesTest, TiltedLaserIsRefused) {
  EXPECT_NO_THROW(ToLaserMount(MakeTransform(1.0, 0.2)));
  EXPECT_NO_THROW(ToLaserMount(MakeTransform(1.0, kPi - 0.2)));
  EXPECT_THROW(ToLaserMount(MakeTransform(1.0, 0.5)), MessageError);
  EXPECT_THROW(ToLaserMount(MakeTransform(1.0, 0.5 * kPi)), MessageError);
  geometry_msgs::Transform broken = MakeTransform(0.0, 0.0);
  broken.rotation.x = std::nan("");
  EXPECT_THROW(ToLaserMount(broken), MessageError);
}

}  // namespace
}  // namespace vfh_astar
