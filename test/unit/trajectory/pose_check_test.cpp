#include "vfh_astar/trajectory/pose_check.h"

#include <gtest/gtest.h>

#include "trajectory/test_maps.h"

namespace vfh_astar {
namespace {

const Footprint kJackal;

// A wall whose cells' centres begin at y = 2.025.
ClearanceMap WallAbove() {
  OccupancyGrid map = FreeMap(10, 10);
  AddBox(map, 0.0, 2.0, 10.0, 2.2);
  return ClearanceOf(map);
}

TEST(PoseCheck, KeepsTheMarginToTheCellsEdge) {
  const ClearanceMap clearance = WallAbove();
  const PoseCheck check(kJackal, clearance, 0.02, {5, 1, 0});
  EXPECT_DOUBLE_EQ(check.margin(), 0.045);
  EXPECT_TRUE(check.IsFree({5, 2.0 - 0.208 - 0.025, 0}));
  EXPECT_FALSE(check.IsFree({5, 2.0 - 0.208 - 0.015, 0}));
}

TEST(PoseCheck, AStartInsideTheMarginMayLeave) {
  const ClearanceMap clearance = WallAbove();
  const Pose2D start(5, 2.0 - 0.208 - 0.005, 0);
  const PoseCheck check(kJackal, clearance, 0.02, start);
  EXPECT_TRUE(check.IsFree(start));
  EXPECT_TRUE(check.IsFree({start.x + 0.1, start.y, 0}));
  EXPECT_TRUE(check.IsFree({start.x + 0.1, start.y + 0.008, 0}));
  EXPECT_FALSE(check.IsFree({start.x, start.y + 0.012, 0}));
  // Beyond kLeavingDistance the whole margin is kept again.
  EXPECT_FALSE(check.IsFree({start.x + 1.1, start.y, 0}));
  EXPECT_FALSE(check.IsTurnFree(start, 0.5));
}

TEST(PoseCheck, TurnsWhereTheCircleFits) {
  const ClearanceMap clearance = WallAbove();
  const PoseCheck check(kJackal, clearance, 0.02, {5, 1, 0});
  EXPECT_TRUE(check.IsTurnFree({5, 1.6, 0}, 2 * kPi));
  EXPECT_FALSE(check.IsTurnFree({5, 1.7, 0}, kPi / 2));
  // A corner does not reach the wall in the first few degrees.
  EXPECT_TRUE(check.IsTurnFree({5, 1.7, 0}, 0.1));
}

TEST(PoseCheck, StaysOnTheMap) {
  const ClearanceMap clearance = ClearanceOf(FreeMap(4, 4));
  const PoseCheck check(kJackal, clearance, 0.02, {2, 2, 0});
  EXPECT_TRUE(check.IsFree({3.99, 2, 0}));
  EXPECT_FALSE(check.IsFree({4.01, 2, 0}));
}

TEST(PoseCheck, RoomByHand) {
  const ClearanceMap clearance = WallAbove();
  const PoseCheck check(kJackal, clearance, 0.02, {5, 1, 0});
  EXPECT_NEAR(check.Room({5, 1.5, 0}), 0.5 - 0.208, 0.01);
  EXPECT_NEAR(check.Room({5, 1.5, kPi / 2}), 0.5 - 0.229, 0.01);
  EXPECT_DOUBLE_EQ(check.RoomAt({5, 9}), 1.0 - 0.025);
}

TEST(PoseCheck, RoomAgreesWithTheDistanceToEveryCell) {
  std::mt19937 random(2);
  std::uniform_real_distribution<> place(1.0, 4.0);
  std::uniform_real_distribution<> angle(-kPi, kPi);
  const OccupancyGrid map = PillarField(5, 5, 12, random);
  const ClearanceMap clearance = ClearanceOf(map);
  const PoseCheck check(kJackal, clearance, 0.02, {2, 2, 0});
  for (int i = 0; i < 500; ++i) {
    const double x = place(random);
    const double y = place(random);
    const Pose2D pose(x, y, angle(random));
    double room = 0.975;
    for (int cy = 0; cy < map.geometry().height; ++cy) {
      for (int cx = 0; cx < map.geometry().width; ++cx) {
        if (map[{cx, cy}] == 0) continue;
        const Eigen::Vector2d cell =
            pose.Inverse() * map.geometry().ToWorld({cx, cy});
        room = std::min(room, kJackal.SignedDistance(cell) - 0.025);
      }
    }
    // Probes lie 0.12 m apart: a pillar between two is seen a little late.
    if (room > 0.05) {
      EXPECT_NEAR(check.Room(pose), room, 0.04);
    }
  }
}

}  // namespace
}  // namespace vfh_astar
