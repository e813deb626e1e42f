#include "vfh_astar/navigation/collision_watch.h"

#include <gtest/gtest.h>

#include <random>

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

// Against every hit at every step, as the header has it.
TEST(TimeToScanCollisionTest, SkipsNothingThatMatters) {
  std::mt19937 random(1);
  std::uniform_real_distribution<> place(-4.0, 4.0);
  std::uniform_real_distribution<> speed(-2.0, 2.0);
  const Footprint footprint;
  int collisions = 0;
  for (int trial = 0; trial < 300; ++trial) {
    TrajectoryPiece piece;
    piece.duration = 3.0;
    piece.x = HermiteQuintic({0.0, speed(random), speed(random), 0.0},
                             {place(random), speed(random), 0.0, 0.0}, 3.0);
    piece.y = HermiteQuintic({0.0, speed(random), speed(random), 0.0},
                             {place(random), speed(random), 0.0, 0.0}, 3.0);
    const Trajectory trajectory({piece});
    Observation observation;
    observation.pose = trajectory.Sample(0.0).pose;
    for (int i = 0; i < 20; ++i) {
      observation.obstacles.emplace_back(place(random), place(random));
    }
    double expected = kNever;
    for (double time = 0.0; time <= 2.0 && expected == kNever; time += 0.05) {
      const Pose2D robot_from_map = trajectory.Sample(time).pose.Inverse();
      for (const Eigen::Vector2d& point : observation.obstacles) {
        if (footprint.Contains(robot_from_map * (observation.pose * point))) {
          expected = time;
        }
      }
    }
    collisions += expected == kNever ? 0 : 1;
    EXPECT_EQ(
        TimeToScanCollision(trajectory, 0.0, 2.0, footprint, 0.0, observation),
        expected)
        << trial;
  }
  EXPECT_GT(collisions, 50);
  EXPECT_LT(collisions, 250);
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

TEST(TimeToMoverContactTest, ByHand) {
  const Footprint footprint{0.5, 0.5, 0.2};
  Observation observation;
  EXPECT_EQ(TimeToMoverContact(5.0, footprint, 0.1, 0.0, observation), kNever);
  MovingObstacle mover;
  mover.position = {4.0, 0.0};
  mover.velocity = {-1.0, 0.0};
  mover.radius = 0.4;
  observation.movers = {mover};
  // From 4 m to 0.5 + 0.4 + 0.1 m at 1 m/s.
  EXPECT_NEAR(TimeToMoverContact(5.0, footprint, 0.1, 0.0, observation), 3.0,
              0.051);
  // With growth g: 4 - t = 1 + 0.2 t.
  EXPECT_NEAR(TimeToMoverContact(5.0, footprint, 0.1, 0.2, observation), 2.5,
              0.051);
  EXPECT_EQ(TimeToMoverContact(2.0, footprint, 0.1, 0.0, observation), kNever);
  observation.movers[0].position.y() = 1.0;
  EXPECT_EQ(TimeToMoverContact(5.0, footprint, 0.1, 0.0, observation), kNever)
      << "it passes";
}

}  // namespace
}  // namespace vfh_astar
