#include "vfh_astar/laser_scan.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <set>

namespace vfh_astar {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

LaserScan Usable() {
  LaserScan scan;
  scan.angle_min = -1.0;
  scan.angle_increment = 0.5;
  scan.range_min = 0.1;
  scan.range_max = 5.0;
  scan.ranges = {1.0f, kInfinity, -kInfinity, std::nanf(""), 2.0f};
  return scan;
}

TEST(LaserScanTest, ReadsRangesByRep117) {
  const LaserScan scan = Usable();
  EXPECT_TRUE(scan.IsHit(0.1f + 1e-6f));
  EXPECT_TRUE(scan.IsHit(5.0f));
  EXPECT_FALSE(scan.IsHit(0.05f));
  EXPECT_FALSE(scan.IsHit(5.1f));
  EXPECT_FALSE(scan.IsHit(std::nanf("")));
  EXPECT_FALSE(scan.IsHit(-kInfinity));
  EXPECT_TRUE(scan.IsFree(kInfinity));
  EXPECT_FALSE(scan.IsFree(std::nanf("")));
  EXPECT_FALSE(scan.IsFree(-kInfinity));
}

TEST(LaserScanTest, HitsBecomePointsWhereTheyAre) {
  LaserScan scan = Usable();
  scan.angle_min = 0.0;
  scan.angle_increment = 0.5 * kPi;
  scan.ranges = {1.0f, 2.0f, kInfinity, 4.0f};
  const auto points = HitPoints(scan, Pose2D(10.0, 0.0, 0.5 * kPi), 3.0);
  ASSERT_EQ(points.size(), 2u) << "4 m is farther than wanted";
  EXPECT_NEAR(points[0].x(), 10.0, 1e-6);
  EXPECT_NEAR(points[0].y(), 1.0, 1e-6);
  EXPECT_NEAR(points[1].x(), 8.0, 1e-6);
  EXPECT_NEAR(points[1].y(), 0.0, 1e-6);
}

TEST(HitPointsTest, EveryBeamLiesInItsDirection) {
  LaserScan scan;
  scan.angle_min = -2.35619;
  scan.angle_increment = 2.0 * 2.35619 / 1079.0;
  scan.range_min = 0.1;
  scan.range_max = 30.0;
  scan.ranges.assign(1080, 30.0f);
  const Pose2D laser(1.0, -2.0, 2.5);
  const auto points = HitPoints(scan, laser, 30.0);
  ASSERT_EQ(points.size(), 1080u);
  for (std::size_t beam = 0; beam < points.size(); ++beam) {
    const double angle = laser.theta + scan.Angle(beam);
    EXPECT_NEAR(points[beam].x(), laser.x + 30.0 * std::cos(angle), 1e-10);
    EXPECT_NEAR(points[beam].y(), laser.y + 30.0 * std::sin(angle), 1e-10);
  }
}

TEST(WithoutLostBeamsTest, TakesOneOrTwoBetweenHitsForLost) {
  LaserScan scan = Usable();
  const float nan = std::nanf("");
  // Lost: 1 and 3 to 4. Kept: three side by side, those at either end, and one
  // beside a beam that measured nothing.
  scan.ranges = {1.0f, kInfinity, 1.0f,      kInfinity, kInfinity,
                 1.0f, kInfinity, kInfinity, kInfinity, 1.0f,
                 nan,  kInfinity, 1.0f,      kInfinity};
  const LaserScan seen = WithoutLostBeams(scan);
  const std::set<std::size_t> lost = {1, 3, 4};
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    if (lost.count(i) != 0 || std::isnan(scan.ranges[i])) {
      EXPECT_TRUE(std::isnan(seen.ranges[i])) << i;
    } else {
      EXPECT_EQ(seen.ranges[i], scan.ranges[i]) << i;
    }
  }
  scan.ranges = {kInfinity, 1.0f};
  EXPECT_EQ(WithoutLostBeams(scan).ranges, scan.ranges);
}

TEST(DescribeDefectTest, NamesEachDefect) {
  EXPECT_FALSE(DescribeDefect(Usable()).has_value());
  LaserScan scan = Usable();
  scan.ranges.clear();
  EXPECT_NE(DescribeDefect(scan)->find("no beams"), std::string::npos);
  scan = Usable();
  scan.angle_increment = 0.0;
  EXPECT_NE(DescribeDefect(scan)->find("angle_increment"), std::string::npos);
  scan = Usable();
  scan.range_max = 0.05;
  EXPECT_NE(DescribeDefect(scan)->find("range_max"), std::string::npos);
}

TEST(DescribeDefectTest, ABlindLaserIsNoEmptyRoom) {
  LaserScan scan = Usable();
  scan.ranges = {std::nanf(""), -kInfinity, 0.0f};
  ASSERT_TRUE(DescribeDefect(scan).has_value());
  EXPECT_NE(DescribeDefect(scan)->find("3 ranges"), std::string::npos);
  scan.ranges.push_back(kInfinity);
  EXPECT_FALSE(DescribeDefect(scan).has_value());
}

}  // namespace
}  // namespace vfh_astar
