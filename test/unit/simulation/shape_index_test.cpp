#include "vfh_astar/simulation/shape_index.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "simulation/ray_distance.h"

namespace vfh_astar {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::vector<Shape> RandomShapes(std::mt19937* random) {
  std::uniform_real_distribution<double> place(-6.0, 6.0);
  std::uniform_real_distribution<double> size(0.05, 1.2);
  std::vector<Shape> shapes;
  for (int i = 0; i < 20; ++i) {
    const Eigen::Vector2d center(place(*random), place(*random));
    if (i % 2 == 0) {
      shapes.push_back(MakeDisc(center, 0.5 * size(*random)));
    } else {
      shapes.push_back(MakeBox(Pose2D(center, place(*random)),
                               {size(*random), size(*random)}));
    }
  }
  return shapes;
}

/// What one beam meets.
double CastRay(const ShapeIndex& index, const Eigen::Vector2d& origin,
               const Eigen::Vector2d& direction, double range) {
  BeamFan fan(1, 0.0, 1.0);
  fan.Aim(Pose2D(origin, std::atan2(direction.y(), direction.x())), range);
  index.CastRays(&fan);
  return fan.ranges()[0] <= range ? fan.ranges()[0] : kInfinity;
}

/// Walks along the ray in small steps until it is inside of something.
double SampledDistance(const std::vector<Shape>& shapes,
                       const Eigen::Vector2d& origin,
                       const Eigen::Vector2d& direction, double range,
                       double step) {
  for (double along = 0.0; along <= range; along += step) {
    for (const Shape& shape : shapes) {
      if (Contains(shape, origin + along * direction)) return along;
    }
  }
  return kInfinity;
}

TEST(ShapeIndexTest, RaysByHand) {
  const ShapeIndex index(
      {MakeDisc({3.0, 0.0}, 0.5), MakeBox({0.0, 4.0, 0.0}, {2.0, 1.0})});
  EXPECT_DOUBLE_EQ(CastRay(index, {0, 0}, {1, 0}, 10.0), 2.5);
  EXPECT_DOUBLE_EQ(CastRay(index, {0, 0}, {0, 1}, 10.0), 3.5);
  EXPECT_EQ(CastRay(index, {0, 0}, {-1, 0}, 10.0), kInfinity);
  EXPECT_EQ(CastRay(index, {0, 0}, {1, 0}, 2.4), kInfinity);
  EXPECT_DOUBLE_EQ(CastRay(index, {-20, 0}, {1, 0}, 30.0), 22.5);
  EXPECT_EQ(CastRay(index, {3, 0}, {1, 0}, 10.0), 0.0) << "from inside";
}

TEST(ShapeIndexTest, NothingToMeet) {
  EXPECT_EQ(CastRay(ShapeIndex(), {0, 0}, {1, 0}, 10.0), kInfinity);
  EXPECT_TRUE(ShapeIndex().Near({0, 0}, 5.0).empty());
}

TEST(ShapeIndexTest, RaysAgreeWithDenseSampling) {
  constexpr double kStep = 0.002;
  std::mt19937 random(11);
  std::uniform_real_distribution<double> place(-8.0, 8.0);
  std::uniform_real_distribution<double> angle(-kPi, kPi);
  int hits = 0;
  for (int scene = 0; scene < 10; ++scene) {
    const std::vector<Shape> shapes = RandomShapes(&random);
    const ShapeIndex index(shapes);
    for (int ray = 0; ray < 30; ++ray) {
      const Eigen::Vector2d origin(place(random), place(random));
      const double a = angle(random);
      const Eigen::Vector2d direction(std::cos(a), std::sin(a));
      const double cast = CastRay(index, origin, direction, 10.0);
      const double sampled =
          SampledDistance(shapes, origin, direction, 10.0, kStep);
      if (std::isfinite(sampled)) {
        ++hits;
        // Samples may step over the sliver that a grazing ray cuts off.
        EXPECT_LE(cast, sampled + 1e-9);
        EXPECT_TRUE(cast > sampled - kStep - 1e-9 ||
                    !Contains(shapes[0], origin + cast * direction));
      }
      if (std::isfinite(cast)) {
        bool touches = false;
        for (const Shape& shape : shapes) {
          touches |= Distance(shape, MakeDisc(origin + cast * direction,
                                              1e-6)) <= 1e-6;
        }
        EXPECT_TRUE(touches) << "the ray ends on a shape";
      }
    }
  }
  EXPECT_GT(hits, 50);
}

TEST(ShapeIndexTest, RaysAgreeWithEveryShapeAskedInTurn) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-30.0, 30.0);
  std::uniform_real_distribution<double> angle(-kPi, kPi);
  for (int scene = 0; scene < 20; ++scene) {
    std::vector<Shape> shapes = RandomShapes(&random);
    // Long walls, as they lie in many buckets at once.
    shapes.push_back(MakeBox({0.0, 20.0, 0.01 * scene}, {50.0, 0.1}));
    shapes.push_back(MakeBox({-20.0, 0.0, angle(random)}, {0.1, 30.0}));
    const ShapeIndex index(shapes);
    constexpr int kBeams = 360;
    constexpr double kIncrement = 0.0123;
    constexpr double kRange = 40.0;
    const Pose2D pose(place(random), place(random), angle(random));
    BeamFan fan(kBeams, 0.0, kIncrement);
    fan.Aim(pose, kRange);
    index.CastRays(&fan);
    for (int beam = 0; beam < kBeams; ++beam) {
      const double a = pose.theta + beam * kIncrement;
      const double expected = RayDistance(shapes, pose.position(),
                                          {std::cos(a), std::sin(a)}, kRange);
      if (std::isfinite(expected)) {
        EXPECT_NEAR(fan.ranges()[beam], expected, 1e-6);
      } else {
        EXPECT_GT(fan.ranges()[beam], kRange);
      }
    }
  }
}

TEST(ShapeIndexTest, RaysBesideTheBordersOfShapes) {
  const ShapeIndex index({MakeBox({0.5, 0.5, 0.0}, {1.0, 1.0}),
                          MakeBox({4.5, 4.5, 0.0}, {1.0, 1.0})});
  constexpr double kBit = 1e-9;
  EXPECT_NEAR(CastRay(index, {kBit, 3}, {0, -1}, 10.0), 2.0, 1e-6);
  EXPECT_EQ(CastRay(index, {-kBit, 3}, {0, -1}, 10.0), kInfinity);
  EXPECT_NEAR(CastRay(index, {5 - kBit, 0}, {0, 1}, 10.0), 4.0, 1e-6);
  EXPECT_EQ(CastRay(index, {5 + kBit, 0}, {0, 1}, 10.0), kInfinity);
  EXPECT_EQ(CastRay(index, {5, 2}, {-1, 0}, 10.0), kInfinity);
  EXPECT_NEAR(CastRay(index, {-7, 1 - kBit}, {1, 0}, 10.0), 7.0, 1e-6);
  EXPECT_EQ(CastRay(index, {100, 100}, {1, 0}, 10.0), kInfinity);
}

TEST(ShapeIndexTest, ManyAtOnePlaceAndOneForAll) {
  // Nothing tells them apart, so that no division separates them.
  const std::vector<Shape> shapes(100, MakeDisc({3.0, 0.0}, 0.5));
  const ShapeIndex index(shapes);
  EXPECT_DOUBLE_EQ(CastRay(index, {0, 0}, {1, 0}, 10.0), 2.5);
  EXPECT_EQ(index.Near({3.0, 0.0}, 0.1).size(), 100u);
  EXPECT_TRUE(index.Near({0.0, 0.0}, 2.4).empty());
}

TEST(ShapeIndexTest, NearMissesNothing) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(-8.0, 8.0);
  const std::vector<Shape> shapes = RandomShapes(&random);
  const ShapeIndex index(shapes);
  for (int query = 0; query < 200; ++query) {
    const Eigen::Vector2d point(place(random), place(random));
    const std::vector<int> near = index.Near(point, 1.0);
    for (std::size_t i = 0; i < shapes.size(); ++i) {
      if (Distance(shapes[i], MakeDisc(point, 1.0)) > 0.0) continue;
      EXPECT_NE(std::find(near.begin(), near.end(), static_cast<int>(i)),
                near.end());
    }
  }
}

}  // namespace
}  // namespace vfh_astar
