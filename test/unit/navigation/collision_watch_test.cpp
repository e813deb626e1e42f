#include "vfh_astar/navigation/collision_watch.h"

#include <gtest/gtest.h>

namespace vfh_astar {
namespace {

/// Along x at a constant 1 m/s from 0.
Trajectory Steady(double duration) {
  TrajectoryPiece piece;
  piece.duration = duration;
  piece.x[1] = duration;
  return Trajectory({piece});
}

TEST(TimeToScanCollisionTest, ByHand) {
  const Footprint footprint{0.5, 0.5, 0.2};
  Observation observation;
  observation.obstacles = {{3.0, 0.1}};
  // The nose is at the post after 2.5 s; looked at every 0.05 s.
  EXPECT_NEAR(
      TimeToScanCollision(Steady(5.0), 0.0, 4.0, footprint, 0.0, observation),
      2.5, 0.051);
  EXPECT_NEAR(
      TimeToScanCollision(Steady(5.0), 1.0, 4.0, footprint, 0.0, observation),
      1.5, 0.051);
  EXPECT_EQ(
      TimeToScanCollision(Steady(5.0), 0.0, 2.0, footprint, 0.0, observation),
      kNever)
      << "beyond the horizon";
  EXPECT_EQ(
      TimeToScanCollision(Steady(2.0), 0.0, 4.0, footprint, 0.0, observation),
      kNever)
      << "beyond the end";
}

TEST(TimeToScanCollisionTest, TheMarginCounts) {
  const Footprint footprint{0.5, 0.5, 0.2};
  Observation observation;
  observation.obstacles = {{3.0, 0.25}};
  EXPECT_EQ(
      TimeToScanCollision(Steady(5.0), 0.0, 4.0, footprint, 0.0, observation),
      kNever);
  EXPECT_NE(
      TimeToScanCollision(Steady(5.0), 0.0, 4.0, footprint, 0.1, observation),
      kNever);
}

TEST(TimeToScanCollisionTest, HitsAreSeenFromTheRobot) {
  const Footprint footprint{0.5, 0.5, 0.2};
  Observation observation;
  observation.pose = {1.0, 1.0, -0.5 * kPi};
  // 1 m ahead of a robot that looks along -y from (1, 1): at (1, 0).
  observation.obstacles = {{1.0, 0.0}};
  EXPECT_NEAR(
      TimeToScanCollision(Steady(5.0), 0.0, 4.0, footprint, 0.0, observation),
      0.5, 0.051);
}

TEST(TimeToMapCollisionTest, ByHand) {
  GridGeometry geometry;
  geometry.resolution = 0.05;
  geometry.origin = {-2.0, -2.0};
  geometry.width = geometry.height = 160;
  OccupancyGrid map(geometry, 0);
  map[geometry.ToCell({3.0, 0.0})] = 100;
  ClearanceMap clearance(65, 1.0);
  clearance.SetMap(map);
  const Footprint footprint{0.5, 0.5, 0.2};
  Observation observation;
  EXPECT_EQ(
      TimeToMapCollision(Steady(5.0), 0.0, 4.0, footprint, 0.0, observation),
      kNever)
      << "no map";
  observation.map = &clearance;
  EXPECT_NEAR(
      TimeToMapCollision(Steady(5.0), 0.0, 4.0, footprint, 0.0, observation),
      2.5, 0.12);
  EXPECT_EQ(
      TimeToMapCollision(Steady(5.0), 0.0, 1.0, footprint, 0.0, observation),
      kNever);
}

}  // namespace
}  // namespace vfh_astar
