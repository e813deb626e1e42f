#include "vfh_astar/simulation/beam_fan.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "simulation/ray_distance.h"

namespace vfh_astar {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A disc or a box somewhere within 8 m, now and then around the origin.
Shape RandomShape(std::mt19937* random) {
  std::uniform_real_distribution<double> place(-8.0, 8.0);
  std::uniform_real_distribution<double> size(0.02, 2.0);
  const Eigen::Vector2d center(place(*random), place(*random));
  if (std::bernoulli_distribution(0.5)(*random)) {
    return MakeDisc(center, 0.5 * size(*random));
  }
  // Thin ones too, as walls are.
  return MakeBox(Pose2D(center, place(*random)),
                 {4.0 * size(*random), size(*random)});
}

/// Whether anything in a box may be seen.
bool MaySee(const BeamFan& fan, const Eigen::Vector2d& min,
            const Eigen::Vector2d& max) {
  BoxLanes boxes;
  boxes.min_x.fill(min.x());
  boxes.min_y.fill(min.y());
  boxes.max_x.fill(max.x());
  boxes.max_y.fill(max.y());
  return fan.MaySee(fan.ViewOf(boxes).At(kFanLanes - 1, 0.0));
}

/// Distances of the beams, where it counts whether they are within the range.
void ExpectRanges(const BeamFan& fan, const Pose2D& pose, double first_angle,
                  double increment, double range,
                  const std::vector<Shape>& shapes) {
  for (std::size_t beam = 0; beam < fan.ranges().size(); ++beam) {
    const double angle = pose.theta + first_angle + beam * increment;
    const double expected = RayDistance(
        shapes, pose.position(), {std::cos(angle), std::sin(angle)}, range);
    const double seen = fan.ranges()[beam];
    if (std::isfinite(expected)) {
      EXPECT_NEAR(seen, expected, 1e-6) << "beam " << beam;
    } else {
      EXPECT_GT(seen, range) << "beam " << beam;
    }
  }
}

TEST(BeamFanTest, RangesByHand) {
  // To the right, ahead, to the left.
  BeamFan fan(3, -0.5 * kPi, 0.5 * kPi);
  fan.Aim({1.0, 2.0, 0.0}, 10.0);
  for (const double range : fan.ranges()) EXPECT_EQ(range, kInfinity);
  fan.LookAt(MakeBox({4.0, 2.0, 0.0}, {2.0, 1.0}));
  fan.LookAt(MakeDisc({1.0, 6.0}, 0.5));
  EXPECT_EQ(fan.ranges()[0], kInfinity);
  EXPECT_DOUBLE_EQ(fan.ranges()[1], 2.0);
  EXPECT_DOUBLE_EQ(fan.ranges()[2], 3.5);
  fan.LookAt(MakeDisc({5.0, 2.0}, 0.2));
  EXPECT_DOUBLE_EQ(fan.ranges()[1], 2.0) << "it is behind the box";
  fan.Aim({1.0, 2.0, 0.5 * kPi}, 10.0);
  EXPECT_EQ(fan.ranges()[1], kInfinity) << "as new";
  fan.LookAt(MakeDisc({1.0, 6.0}, 0.5));
  EXPECT_DOUBLE_EQ(fan.ranges()[1], 3.5);
}

TEST(BeamFanTest, InsideOfSomethingEverythingIsAtHand) {
  for (const Shape& shape :
       {MakeDisc({1.0, 0.2}, 2.0), MakeBox({0.5, 0.0, 0.3}, {2.0, 2.0})}) {
    BeamFan fan(100, -1.0, 0.05);
    fan.Aim({0.0, 0.0, 1.0}, 10.0);
    fan.LookAt(shape);
    for (const double range : fan.ranges()) EXPECT_EQ(range, 0.0);
  }
}

TEST(BeamFanTest, AgreesWithEveryBeamAskedForEveryShape) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(-6.0, 6.0);
  constexpr double kRange = 9.0;
  // Narrow, as a laser sees, all around, and more than that.
  for (const double span : {0.5, 1.5 * kPi, 2.0 * kPi, 2.5 * kPi, 4.5 * kPi}) {
    for (const int beams : {2, 37, 1080}) {
      const double increment = span / (beams - 1);
      for (int scene = 0; scene < 20; ++scene) {
        const Pose2D pose(place(random), place(random), place(random));
        BeamFan fan(beams, -0.5 * span, increment);
        fan.Aim(pose, kRange);
        std::vector<Shape> shapes;
        for (int i = 0; i < 15; ++i) {
          shapes.push_back(RandomShape(&random));
          fan.LookAt(shapes.back());
        }
        ExpectRanges(fan, pose, -0.5 * span, increment, kRange, shapes);
      }
    }
  }
}

TEST(BeamFanTest, SeesWhatIsFarAndSmallAndWhatIsCloseAndLarge) {
  constexpr double kIncrement = 0.0005;
  constexpr int kBeams = 12000;
  std::mt19937 random(2);
  std::uniform_real_distribution<double> angle(-kPi, kPi);
  for (int scene = 0; scene < 60; ++scene) {
    const double a = angle(random);
    const Eigen::Vector2d way(std::cos(a), std::sin(a));
    const std::vector<Shape> shapes = {
        MakeDisc(28.0 * way, 0.02),
        MakeDisc(-10.001 * way, 10.0),
        MakeBox(Pose2D(0.0501 * Eigen::Vector2d(-way.y(), way.x()), a),
                {200.0, 0.1}),
    };
    const Pose2D pose(0.0, 0.0, angle(random));
    BeamFan fan(kBeams, 0.0, kIncrement);
    fan.Aim(pose, 30.0);
    for (const Shape& shape : shapes) fan.LookAt(shape);
    ExpectRanges(fan, pose, 0.0, kIncrement, 30.0, shapes);
  }
}

TEST(BeamFanTest, NoBeamSlipsBetweenShapesThatTouch) {
  // A room of 6 m x 6 m, its walls of cells of 0.1 m as a map's are.
  std::vector<Shape> cells;
  for (int i = -31; i <= 30; ++i) {
    for (const int side : {-31, 30}) {
      for (const auto& [x, y] : {std::pair(i, side), std::pair(side, i)}) {
        cells.push_back(MakeConvexPolygon({{0.1 * x, 0.1 * y},
                                           {0.1 * (x + 1), 0.1 * y},
                                           {0.1 * (x + 1), 0.1 * (y + 1)},
                                           {0.1 * x, 0.1 * (y + 1)}}));
      }
    }
  }
  const Shape room = MakeBox({0.0, 0.0, 0.0}, {6.0 - 1e-9, 6.0 - 1e-9});
  std::mt19937 random(3);
  std::uniform_int_distribution<int> cell(-29, 29);
  for (int place = 0; place < 200; ++place) {
    // Where many beams meet corners exactly, or as exactly as can be.
    const Pose2D pose(0.1 * cell(random), 0.1 * cell(random),
                      0.25 * kPi * cell(random));
    BeamFan fan(721, 0.0, kPi / 360.0);
    fan.Aim(pose, 30.0);
    for (const Shape& shape : cells) fan.LookAt(shape);
    for (int beam = 0; beam < 721; ++beam) {
      const double angle = pose.theta + beam * kPi / 360.0;
      const Eigen::Vector2d end =
          pose.position() +
          fan.ranges()[beam] *
              Eigen::Vector2d(std::cos(angle), std::sin(angle));
      EXPECT_NEAR(end.lpNorm<Eigen::Infinity>(), 3.0, 1e-6);
    }
  }
}

TEST(BeamFanTest, DiscsBesideEachOtherAreAsOneAfterTheOther) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(-8.0, 8.0);
  std::uniform_real_distribution<double> size(0.02, 1.0);
  for (int scene = 0; scene < 500; ++scene) {
    // Not in whole blocks of beams either, and more than all around.
    const int beams = scene % 2 == 0 ? 720 : 541;
    const double increment = scene % 3 == 0 ? 0.0131 : 0.0065;
    const Pose2D pose(place(random), place(random), place(random));
    BeamFan at_once(beams, 0.3, increment);
    BeamFan in_turn(beams, 0.3, increment);
    at_once.Aim(pose, 30.0);
    in_turn.Aim(pose, 30.0);
    const int count = 1 + scene % kFanLanes;
    DiscLanes discs = {};
    for (int i = 0; i < count; ++i) {
      discs.x[i] = place(random);
      discs.y[i] = place(random);
      discs.radius[i] = size(random);
      in_turn.LookAtDisc({discs.x[i], discs.y[i]}, discs.radius[i]);
    }
    at_once.LookAtDiscs(discs, count);
    EXPECT_EQ(at_once.ranges(), in_turn.ranges());
  }
}

TEST(BeamFanTest, WhatIsHiddenByHand) {
  BeamFan fan(181, -0.5 * kPi, kPi / 180.0);
  fan.Aim({0.0, 0.0, 0.0}, 10.0);
  EXPECT_TRUE(MaySee(fan, {4.0, -0.5}, {5.0, 0.5}));
  EXPECT_FALSE(MaySee(fan, {-5.0, -0.5}, {-4.0, 0.5})) << "behind its back";
  EXPECT_FALSE(MaySee(fan, {11.0, -0.5}, {12.0, 0.5})) << "out of range";
  fan.LookAt(MakeBox({3.0, 0.0, 0.0}, {0.1, 4.0}));
  EXPECT_FALSE(MaySee(fan, {4.0, -0.5}, {5.0, 0.5}));
  EXPECT_TRUE(MaySee(fan, {4.0, -0.5}, {5.0, 4.0})) << "it looks out";
  EXPECT_TRUE(MaySee(fan, {2.0, -0.5}, {5.0, 0.5})) << "it begins before it";
  EXPECT_TRUE(MaySee(fan, {-1.0, -1.0}, {5.0, 1.0})) << "around the origin";
}

TEST(BeamFanTest, HidesNothingThatWouldBeSeen) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> place(-9.0, 9.0);
  std::uniform_real_distribution<double> size(0.02, 3.0);
  int hidden = 0;
  for (int scene = 0; scene < 400; ++scene) {
    const double span = scene % 2 == 0 ? 1.5 * kPi : 2.3 * kPi;
    BeamFan fan(540, -0.5 * span, span / 539);
    const Pose2D pose(place(random), place(random), place(random));
    fan.Aim(pose, 8.0);
    for (int i = 0; i < 12; ++i) fan.LookAt(RandomShape(&random));
    for (int i = 0; i < 20; ++i) {
      const Eigen::Vector2d min(place(random), place(random));
      const Eigen::Vector2d max =
          min + Eigen::Vector2d(size(random), size(random));
      if (MaySee(fan, min, max)) continue;
      ++hidden;
      BeamFan looks_anyway = fan;
      looks_anyway.LookAt(MakeBox(Pose2D(0.5 * (min + max), 0.0), max - min));
      for (std::size_t beam = 0; beam < fan.ranges().size(); ++beam) {
        if (looks_anyway.ranges()[beam] > 8.0) continue;
        EXPECT_NEAR(looks_anyway.ranges()[beam], fan.ranges()[beam], 1e-9);
      }
    }
  }
  EXPECT_GT(hidden, 1000);
}

}  // namespace
}  // namespace vfh_astar
