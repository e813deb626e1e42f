#include "vfh_astar/control/vfh.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vfh_astar {
namespace {

using Points = std::vector<Eigen::Vector2d>;

VfhParameters Parameters() {
  VfhParameters parameters;
  parameters.sector_angle = kPi / 36;  // 72 sectors
  parameters.window = 2.0;
  parameters.robot_radius = 0.0;
  parameters.smoothing = 0;
  parameters.threshold_low = 0.15;
  parameters.threshold_high = 0.25;
  parameters.speed = 0.5;
  parameters.look_ahead = 1.0;
  parameters.slow_angle = kPi;
  parameters.low_pass = 1.0;
  return parameters;
}

/// A wall of points at x from y to y.
Points Wall(double x, double from, double to) {
  Points points;
  for (double y = from; y <= to + 1e-9; y += 0.01) points.emplace_back(x, y);
  return points;
}

TEST(FindValleysTest, TheWholeCircle) {
  const std::vector<Valley> valleys = FindValleys(std::vector<bool>(8, false));
  ASSERT_EQ(valleys.size(), 1u);
  EXPECT_DOUBLE_EQ(valleys[0].width, 2.0 * kPi);
}

TEST(FindValleysTest, NoneWhenAllIsBlocked) {
  EXPECT_TRUE(FindValleys(std::vector<bool>(8, true)).empty());
}

TEST(FindValleysTest, OneThatCrossesTheSeamIsNotCut) {
  // Sectors of 45 degrees from -180: blocked are 2 and 5.
  std::vector<bool> blocked(8, false);
  blocked[2] = blocked[5] = true;
  const std::vector<Valley> valleys = FindValleys(blocked);
  ASSERT_EQ(valleys.size(), 2u);
  EXPECT_NEAR(valleys[0].from, -kPi + 3 * kPi / 4, 1e-12);
  EXPECT_NEAR(valleys[0].width, 2 * kPi / 4, 1e-12);
  EXPECT_NEAR(valleys[1].from, -kPi + 6 * kPi / 4, 1e-12);
  EXPECT_NEAR(valleys[1].width, 4 * kPi / 4, 1e-12);
}

TEST(SmoothCircleTest, TriangularWeightsAroundTheSeam) {
  const std::vector<double> smoothed = SmoothCircle({4.0, 0.0, 0.0, 0.0}, 1);
  EXPECT_DOUBLE_EQ(smoothed[0], 2.0);
  EXPECT_DOUBLE_EQ(smoothed[1], 1.0);
  EXPECT_DOUBLE_EQ(smoothed[2], 0.0);
  EXPECT_DOUBLE_EQ(smoothed[3], 1.0);
}

TEST(VfhTest, DensityFallsWithDistance) {
  Vfh vfh(Parameters());
  // 0.5 m ahead: 1 - 0.5 / 2 = 0.75 in the sector that begins at 0 rad.
  const VfhResult result = vfh.Update({{0.5, 0.01}, {3.0, -1.0}}, 0.0);
  EXPECT_NEAR(result.histogram[36], 1.0 - std::hypot(0.5, 0.01) / 2.0, 1e-12);
  for (int sector = 0; sector < 72; ++sector) {
    if (sector == 36) continue;
    EXPECT_EQ(result.histogram[sector], 0.0) << sector;
  }
}

TEST(VfhTest, EnlargementBlocksTheArcsine) {
  VfhParameters parameters = Parameters();
  parameters.robot_radius = 0.5;
  Vfh vfh(parameters);
  // At 1 m, 0.5 m of radius cover 30 degrees to each side.
  const VfhResult result = vfh.Update({{1.0, 0.001}}, kPi);
  int blocked = 0;
  for (const bool sector : result.blocked) blocked += sector ? 1 : 0;
  EXPECT_NEAR(blocked * 5.0, 60.0, 5.0);
}

TEST(VfhTest, GoesStraightToAnOpenTarget) {
  Vfh vfh(Parameters());
  const VfhResult result = vfh.Update({}, 0.4);
  EXPECT_TRUE(result.open);
  EXPECT_DOUBLE_EQ(result.direction, 0.4);
  EXPECT_DOUBLE_EQ(result.command.v, 0.5);
  // w = 2 v sin(theta) / L
  EXPECT_DOUBLE_EQ(result.command.w, 2.0 * 0.5 * std::sin(0.4));
}

TEST(VfhTest, PassesAWallOnTheTargetsSide) {
  VfhParameters parameters = Parameters();
  parameters.robot_radius = 0.3;
  for (const double side : {-1.0, 1.0}) {
    Vfh vfh(parameters);
    const VfhResult result = vfh.Update(Wall(1.0, -0.5, 0.5), 0.3 * side);
    ASSERT_TRUE(result.open);
    EXPECT_GT(result.direction * side, 0.5);
    EXPECT_LT(result.direction * side, 1.6);
    EXPECT_GT(result.command.w * side, 0.0);
  }
}

TEST(VfhTest, TurnsOnTheSpotToWhatLiesBehind) {
  Vfh vfh(Parameters());
  const VfhResult beside = vfh.Update({}, 1.5);
  EXPECT_DOUBLE_EQ(beside.command.v, 0.5);
  for (const double target : {1.7, -2.9}) {
    vfh.Reset();
    const VfhResult behind = vfh.Update({}, target);
    EXPECT_DOUBLE_EQ(behind.direction, target);
    EXPECT_EQ(behind.command.v, 0.0);
    // As fast as at a right angle, 2 v / L.
    EXPECT_DOUBLE_EQ(behind.command.w, std::copysign(1.0, target));
  }
}

TEST(VfhTest, StopsWhenNothingIsOpen) {
  Points ring;
  for (double angle = -kPi; angle < kPi; angle += 0.01) {
    ring.emplace_back(0.6 * std::cos(angle), 0.6 * std::sin(angle));
  }
  Vfh vfh(Parameters());
  const VfhResult result = vfh.Update(ring, 0.0);
  EXPECT_FALSE(result.open);
  EXPECT_EQ(result.command.v, 0.0);
  EXPECT_EQ(result.command.w, 0.0);
}

TEST(VfhTest, HysteresisKeepsASectorBetweenTheThresholds) {
  VfhParameters parameters = Parameters();
  parameters.threshold_low = 0.2;
  parameters.threshold_high = 0.6;
  Vfh vfh(parameters);
  const Points near = {{0.5, 0.01}};     // 0.75
  const Points between = {{1.2, 0.02}};  // 0.4
  EXPECT_FALSE(vfh.Update(between, kPi).blocked[36]);
  EXPECT_TRUE(vfh.Update(near, kPi).blocked[36]);
  EXPECT_TRUE(vfh.Update(between, kPi).blocked[36]);
  EXPECT_FALSE(vfh.Update({}, kPi).blocked[36]);
}

TEST(VfhTest, TheLowPassHasUnitGain) {
  VfhParameters parameters = Parameters();
  parameters.low_pass = 0.3;
  Vfh vfh(parameters);
  const double turn = 2.0 * 0.5 * std::sin(0.5);
  EXPECT_NEAR(vfh.Update({}, 0.5).command.w, 0.3 * turn, 1e-12);
  EXPECT_NEAR(vfh.Update({}, 0.5).command.w, (0.3 + 0.7 * 0.3) * turn, 1e-12);
  double w = 0.0;
  for (int i = 0; i < 100; ++i) w = vfh.Update({}, 0.5).command.w;
  EXPECT_NEAR(w, turn, 1e-9);
}

TEST(VfhTest, KeepsToItsChoice) {
  VfhParameters parameters = Parameters();
  parameters.robot_radius = 0.3;
  Vfh vfh(parameters);
  const Points wall = Wall(1.0, -0.5, 0.5);
  EXPECT_GT(vfh.Update(wall, 0.05).direction, 0.0);
  // The target wanders a little to the other side; the choice must not.
  EXPECT_GT(vfh.Update(wall, -0.05).direction, 0.0);
}

}  // namespace
}  // namespace vfh_astar
