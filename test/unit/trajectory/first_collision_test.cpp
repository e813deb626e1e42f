#include "vfh_astar/trajectory/first_collision.h"

#include <gtest/gtest.h>

#include "trajectory/test_maps.h"
#include "vfh_astar/trajectory/timing.h"

namespace vfh_astar {
namespace {

const Footprint kJackal;

// 1 m/s along x from x = 1 on, for `duration` seconds.
Trajectory Straight(double y, double duration) {
  TrajectoryPiece piece;
  piece.duration = duration;
  piece.x[0] = 1.0;
  piece.x[1] = duration;
  piece.y[0] = y;
  return Trajectory({piece});
}

TEST(FirstCollision, NoneInTheOpen) {
  const ClearanceMap clearance = ClearanceOf(FreeMap(10, 10));
  EXPECT_FALSE(
      FirstCollision(Straight(5, 8), kJackal, clearance, 0.02, 0, 100));
  EXPECT_FALSE(FirstCollision(Trajectory(), kJackal, clearance, 0.02, 0, 100));
}

TEST(FirstCollision, TimeByHand) {
  OccupancyGrid map = FreeMap(10, 10);
  AddBox(map, 6.0, 0.0, 6.1, 10.0);
  const ClearanceMap clearance = ClearanceOf(map);
  const Trajectory trajectory = Straight(5, 8);
  // The front edge, grown by 5 cm, meets the first centre, at 6.025.
  const double expected = 6.025 - 0.229 - 0.05 - 1.0;
  const std::optional<double> t =
      FirstCollision(trajectory, kJackal, clearance, 0.05, 0, 100);
  ASSERT_TRUE(t);
  EXPECT_GE(*t, expected - 1e-9);
  EXPECT_LE(*t, expected + 0.016);
  EXPECT_FALSE(FirstCollision(trajectory, kJackal, clearance, 0.05, 0, 4.5));
  EXPECT_EQ(FirstCollision(trajectory, kJackal, clearance, 0.05, 5.0, 100),
            5.0);
}

TEST(FirstCollision, SeesATurn) {
  OccupancyGrid map = FreeMap(4, 4);
  AddBox(map, 2.0, 2.25, 2.1, 2.3);
  const ClearanceMap clearance = ClearanceOf(map);
  const Trajectory trajectory(TimeTurn({2.0, 2.0, 0.0}, kPi / 2, 0.0, {}));
  EXPECT_TRUE(FirstCollision(trajectory, kJackal, clearance, 0.0, 0, 100));
}

// Against looks every millisecond.
TEST(FirstCollision, AgreesWithDenseSampling) {
  std::mt19937 random(7);
  std::uniform_real_distribution<> place(0.5, 9.5);
  int collisions = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const ClearanceMap clearance = ClearanceOf(PillarField(10, 10, 12, random));
    TrajectoryPiece piece;
    piece.duration = 5.0;
    const auto jet = [&] {
      return Jet{place(random), place(random) / 5 - 1, 0.0, 0.0};
    };
    piece.x = HermiteQuintic(jet(), jet(), 5.0);
    piece.y = HermiteQuintic(jet(), jet(), 5.0);
    const Trajectory trajectory({piece});
    std::optional<double> expected;
    for (int i = 0; i <= 5000 && !expected; ++i) {
      if (!clearance.IsFree(kJackal, trajectory.Sample(1e-3 * i).pose, 0.0)) {
        expected = 1e-3 * i;
      }
    }
    const std::optional<double> found =
        FirstCollision(trajectory, kJackal, clearance, 0.0, 0.0, 5.0);
    // What is grazed for less than a step may be missed, and is no collision
    // any more with a margin of that step.
    if (found) {
      ++collisions;
      ASSERT_TRUE(expected);
      EXPECT_GE(*found, *expected - 1e-3);
    }
    if (expected) {
      const std::optional<double> grown =
          FirstCollision(trajectory, kJackal, clearance, 0.015, 0.0, 5.0);
      ASSERT_TRUE(grown);
      EXPECT_LE(*grown, *expected + 0.021);
    }
  }
  EXPECT_GT(collisions, 50);
}

}  // namespace
}  // namespace vfh_astar
