#include "vfh_astar/mapping/map_agreement.h"

#include <gtest/gtest.h>

namespace vfh_astar {
namespace {

constexpr double kReach = 0.2;  // m

/// 10 by 10 m of cells of 0.1 m: a wall from x = 5.0 to 5.1, free from 0.5 to
/// there, and unexplored beyond and before.
LogOddsGrid WallMap() {
  GridGeometry geometry;
  geometry.resolution = 0.1;
  geometry.width = 100;
  geometry.height = 100;
  LogOddsGrid map(geometry);
  for (int y = 0; y < 100; ++y) {
    for (int x = 5; x < 50; ++x) map.Set({x, y}, kEvenOdds - 40);
    map.Set({50, y}, kEvenOdds + 40);
  }
  return map;
}

/// What is said of one hit at a place of the map, seen from (1.55, 5.05).
MapAgreement Compare(const Eigen::Vector2d& hit) {
  const Pose2D pose(1.55, 4.55, 0.5 * kPi);
  return CompareWithMap(WallMap(), {pose.Inverse() * hit}, {0.5, 0.0}, pose,
                        kReach);
}

struct Case {
  const char* what;
  Eigen::Vector2d hit;
  int known, near, pierced;
};

TEST(MapAgreement, CountsEachHitAsWhatItIs) {
  const Case cases[] = {
      {"on the wall", {5.05, 5.05}, 1, 1, 0},
      {"two cells before it", {4.85, 5.05}, 1, 1, 0},
      {"two cells behind it, unexplored", {5.25, 5.05}, 1, 1, 0},
      {"three cells before it", {4.75, 5.05}, 1, 0, 0},
      {"new, in the open", {3.05, 5.05}, 1, 0, 0},
      {"three cells behind it", {5.35, 5.05}, 1, 0, 1},
      {"far behind it", {8.05, 8.05}, 1, 0, 1},
      {"behind it and beyond the map", {12.05, 5.05}, 1, 0, 1},
      {"unexplored", {0.25, 5.05}, 0, 0, 0},
      {"beyond the map", {-3.05, 5.05}, 0, 0, 0}};
  for (const Case& expected : cases) {
    const MapAgreement agreement = Compare(expected.hit);
    EXPECT_EQ(agreement.known, expected.known) << expected.what;
    EXPECT_EQ(agreement.near, expected.near) << expected.what;
    EXPECT_EQ(agreement.pierced, expected.pierced) << expected.what;
  }
}

TEST(MapAgreement, AHitAtTheLaserPiercesNothing) {
  const Pose2D pose(5.05, 4.55, 0.5 * kPi);
  const MapAgreement agreement =
      CompareWithMap(WallMap(), {{0.4, 0.0}}, {0.5, 0.0}, pose, kReach);
  EXPECT_EQ(agreement.near, 1);
  EXPECT_EQ(agreement.pierced, 0);
}

TEST(MapAgreement, SharesAreOfTheHitsThatTheMapKnows) {
  const Pose2D pose(1.55, 5.05, 0.0);
  const MapAgreement agreement = CompareWithMap(
      WallMap(), {{3.5, 0.0}, {3.5, 1.0}, {2.0, 0.0}, {4.5, 0.0}, {-5.0, 0.0}},
      {0.0, 0.0}, pose, kReach);
  EXPECT_EQ(agreement.known, 4);
  EXPECT_DOUBLE_EQ(agreement.near_share(), 0.5);
  EXPECT_DOUBLE_EQ(agreement.pierced_share(), 0.25);
}

TEST(MapAgreement, NothingKnownIsNoShare) {
  EXPECT_EQ(MapAgreement().near_share(), 0.0);
  EXPECT_EQ(MapAgreement().pierced_share(), 0.0);
}

}  // namespace
}  // namespace vfh_astar
