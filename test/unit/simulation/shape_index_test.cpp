#include "vfh_astar/simulation/shape_index.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

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
  EXPECT_DOUBLE_EQ(index.CastRay({0, 0}, {1, 0}, 10.0), 2.5);
  EXPECT_DOUBLE_EQ(index.CastRay({0, 0}, {0, 1}, 10.0), 3.5);
  EXPECT_EQ(index.CastRay({0, 0}, {-1, 0}, 10.0), kInfinity);
  EXPECT_EQ(index.CastRay({0, 0}, {1, 0}, 2.4), kInfinity);
  EXPECT_DOUBLE_EQ(index.CastRay({-20, 0}, {1, 0}, 30.0), 22.5);
  EXPECT_EQ(index.CastRay({3, 0}, {1, 0}, 10.0), 0.0) << "from inside";
}

TEST(ShapeIndexTest, NothingToMeet) {
  EXPECT_EQ(ShapeIndex().CastRay({0, 0}, {1, 0}, 10.0), kInfinity);
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
      const double cast = index.CastRay(origin, direction, 10.0);
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
    // Of no round number, and some of them along the axes.
    std::vector<Eigen::Vector2d> directions = {{1, 0}, {-1, 0}, {0, 1}};
    for (int ray = 0; ray < 60; ++ray) {
      const double a = angle(random);
      directions.emplace_back(std::cos(a), std::sin(a));
    }
    const Eigen::Vector2d origin(place(random), place(random));
    const double range = 40.0;
    std::vector<double> distances(directions.size());
    index.CastRays(origin, directions.data(), directions.size(), range,
                   distances.data());
    for (std::size_t ray = 0; ray < directions.size(); ++ray) {
      double expected = kInfinity;
      for (const Shape& shape : shapes) {
        expected =
            std::min(expected, RayDistance(shape, origin, directions[ray]));
      }
      if (expected > range) expected = kInfinity;
      if (std::isfinite(expected)) {
        EXPECT_NEAR(distances[ray], expected, 1e-9);
      } else {
        EXPECT_EQ(distances[ray], expected);
      }
      EXPECT_EQ(index.CastRay(origin, directions[ray], range), distances[ray]);
    }
  }
}

TEST(ShapeIndexTest, RaysFromAndAlongTheBordersOfAllShapes) {
  const ShapeIndex index({MakeBox({0.5, 0.5, 0.0}, {1.0, 1.0}),
                          MakeBox({4.5, 4.5, 0.0}, {1.0, 1.0})});
  EXPECT_DOUBLE_EQ(index.CastRay({0, 3}, {0, -1}, 10.0), 2.0);
  EXPECT_DOUBLE_EQ(index.CastRay({5, 0}, {0, 1}, 10.0), 4.0);
  EXPECT_DOUBLE_EQ(index.CastRay({5, 2}, {-1, 0}, 10.0), kInfinity);
  EXPECT_DOUBLE_EQ(index.CastRay({-7, 1}, {1, 0}, 10.0), 7.0);
  EXPECT_DOUBLE_EQ(index.CastRay({5, 9}, {0, -1}, 10.0), 4.0);
  EXPECT_EQ(index.CastRay({5, 9}, {0, 1}, 10.0), kInfinity);
  EXPECT_EQ(index.CastRay({100, 100}, {1, 0}, 10.0), kInfinity);
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
