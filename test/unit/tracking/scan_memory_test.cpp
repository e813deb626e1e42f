#include "vfh_astar/tracking/scan_memory.h"

#include <gtest/gtest.h>

namespace vfh_astar {
namespace {

LaserScan Scan(double stamp, float range) {
  LaserScan scan;
  scan.stamp = stamp;
  scan.angle_min = -1.0;
  scan.angle_increment = 0.1;
  scan.range_min = 0.1;
  scan.range_max = 10.0;
  scan.ranges.assign(21, range);
  return scan;
}

TEST(PlacedScanTest, SeesThroughWhatAllBeamsAroundPass) {
  LaserScan scan = Scan(0.0, 3.0F);
  const Pose2D pose(1.0, 0.0, 0.0);
  const PlacedScan placed(scan, pose);
  EXPECT_TRUE(placed.SawThrough({3.8, 0.0}, 0.1, 0.0));    // 2.8 m away
  EXPECT_FALSE(placed.SawThrough({3.95, 0.0}, 0.1, 0.0));  // 0.05 m before
  EXPECT_FALSE(placed.SawThrough({5.0, 0.0}, 0.1, 0.0));   // hidden
  EXPECT_FALSE(placed.SawThrough({-1.0, 0.0}, 0.1, 0.0));  // out of its view
  scan.ranges[11] = 1.0F;                                  // the beam beside
  EXPECT_FALSE(PlacedScan(scan, pose).SawThrough({3.8, 0.0}, 0.1, 0.0));
}

TEST(PlacedScanTest, AsksMoreBeamsTheFartherTheLaserHasTurned) {
  LaserScan scan = Scan(0.0, 3.0F);
  scan.ranges[13] = 1.0F;
  const PlacedScan placed(scan, {});
  EXPECT_TRUE(placed.SawThrough({2.8, 0.0}, 0.1, 0.0));
  // 0.03 of the turn is half the angle between two beams and more.
  EXPECT_FALSE(placed.SawThrough({2.8, 0.0}, 0.1, 2.0));
  EXPECT_FALSE(placed.SawThrough({2.8, 0.0}, 0.1, -2.0));
}

TEST(ScanMemoryTest, RemembersForItsLength) {
  ScanMemory memory(0.8);
  for (int i = 0; i < 20; ++i) memory.Add(Scan(0.05 * i, 5.0F), {});
  EXPECT_TRUE(memory.WasFree({4.0, 0.0}, 0.1, 0.0));
  for (int i = 20; i < 60; ++i) memory.Add(Scan(0.05 * i, 3.0F), {});
  EXPECT_FALSE(memory.WasFree({4.0, 0.0}, 0.1, 0.0));
  memory.Clear();
  EXPECT_FALSE(memory.WasFree({2.0, 0.0}, 0.1, 0.0));
}

}  // namespace
}  // namespace vfh_astar
