#include "vfh_astar/simulation/lidar.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "simulation/ray_distance.h"

namespace vfh_astar {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// Beams at -90, -45, 0, 45 and 90 degrees from the middle of the robot.
LaserModel FiveBeams() {
  LaserModel laser;
  laser.beams = 5;
  laser.angle_min = -0.5 * kPi;
  laser.angle_max = 0.5 * kPi;
  laser.range_min = 0.5;
  laser.range_max = 10.0;
  laser.mount = Pose2D();
  return laser;
}

TEST(LidarTest, RangesByHand) {
  Lidar lidar(FiveBeams(), {});
  EXPECT_TRUE(std::isnan(lidar.scan().ranges[0])) << "no sweep yet";
  const ShapeIndex still({MakeDisc({1.0, 5.0}, 1.0)});
  const Shape post = MakeDisc({3.0, 2.0}, 0.25);
  const Shape close = MakeDisc({1.0, 1.7}, 0.4);
  const Shape far = MakeDisc({20.0, 2.0}, 1.0);
  // Looking along y of the world from (1, 2): beam 2 is straight ahead.
  lidar.Sweep(1.5, {1.0, 2.0, 0.5 * kPi}, still, {&post}, nullptr);
  EXPECT_EQ(lidar.scan().stamp, 1.5);
  EXPECT_FLOAT_EQ(lidar.scan().ranges[2], 2.0f);
  EXPECT_FLOAT_EQ(lidar.scan().ranges[0], 1.75f);
  EXPECT_EQ(lidar.scan().ranges[1], kInfinity);
  EXPECT_EQ(lidar.scan().ranges[4], kInfinity);
  lidar.Sweep(1.6, {1.0, 2.0, 0.5 * kPi}, still, {&far}, nullptr);
  EXPECT_EQ(lidar.scan().ranges[0], kInfinity) << "beyond range_max";
  lidar.Sweep(1.7, {1.0, 2.0, 0.5 * kPi}, still, {&close}, nullptr);
  EXPECT_EQ(lidar.scan().ranges[2], -kInfinity) << "inside of something";
}

TEST(LidarTest, WhatMovesIsSeenAsIfItStoodStill) {
  for (const double span : {1.0, 1.5 * kPi, 2.0 * kPi, 2.5 * kPi}) {
    LaserModel laser;
    laser.angle_min = -0.5 * span;
    laser.angle_max = 0.5 * span;
    Lidar sees_still(laser, {});
    Lidar sees_moving(laser, {});
    for (int i = 0; i < 60; ++i) {
      // All around the robot, near and far.
      const double bearing = 0.37 * i;
      const Pose2D place(
          Eigen::Vector2d(2.0 + 0.2 * i, -1.0) +
              (0.9 + 0.1 * i) *
                  Eigen::Vector2d(std::cos(bearing), std::sin(bearing)),
          0.2 * i);
      const Shape shape = i % 2 == 0 ? MakeBox(place, {1.0, 0.3})
                                     : MakeDisc(place.position(), 0.4);
      const Pose2D base(2.0 + 0.2 * i, -1.0, 0.5 * i);
      sees_still.Sweep(0.0, base, ShapeIndex({shape}), {}, nullptr);
      sees_moving.Sweep(0.0, base, ShapeIndex(), {&shape}, nullptr);
      for (int beam = 0; beam < laser.beams; ++beam) {
        const float expected = sees_still.scan().ranges[beam];
        const float seen = sees_moving.scan().ranges[beam];
        if (std::isfinite(expected)) {
          EXPECT_NEAR(seen, expected, 1e-5);
        } else {
          EXPECT_EQ(seen, expected);
        }
      }
    }
  }
}

TEST(LidarTest, NoiseHasItsSpreadAndDropoutsTheirShare) {
  LaserModel laser;
  laser.sigma = 0.03;
  NoiseModel noise;
  noise.range_sigma = 0.04;
  noise.dropout = 0.1;
  Lidar lidar(laser, noise);
  const Shape pillar = MakeDisc({5.0, 0.0}, 4.0);
  std::mt19937 random(1);
  double sum = 0.0;
  double squares = 0.0;
  int seen = 0;
  int lost = 0;
  for (int sweep = 0; sweep < 50; ++sweep) {
    lidar.Sweep(0.0, {-0.055, 0.0, 0.0}, ShapeIndex({pillar}), {}, &random);
    for (int beam = 500; beam < 580; ++beam) {
      const double angle = lidar.scan().Angle(beam);
      const double truth =
          RayDistance(pillar, {0.0, 0.0}, {std::cos(angle), std::sin(angle)});
      if (std::isinf(lidar.scan().ranges[beam])) {
        ++lost;
        continue;
      }
      ++seen;
      const double error = lidar.scan().ranges[beam] - truth;
      sum += error;
      squares += error * error;
    }
  }
  EXPECT_NEAR(sum / seen, 0.0, 0.004);
  EXPECT_NEAR(std::sqrt(squares / seen), 0.05, 0.003);
  EXPECT_NEAR(static_cast<double>(lost) / (lost + seen), 0.1, 0.02);
}

}  // namespace
}  // namespace vfh_astar
