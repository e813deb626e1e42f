#include "vfh_astar/simulation/fan_lanes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "vfh_astar/geometry.h"

namespace vfh_astar {
namespace {

/// rad from `low` counter-clockwise to an angle, just below 0 for one that is
/// just before it.
double Beyond(double low, double angle) {
  const double width = std::remainder(angle - low - kPi, 2.0 * kPi) + kPi;
  return width > 2.0 * kPi - 0.01 ? width - 2.0 * kPi : width;
}

FanFrame RandomFrame(std::mt19937* random) {
  std::uniform_real_distribution<double> place(-9.0, 9.0);
  FanFrame frame;
  frame.origin = {place(*random), place(*random)};
  frame.axis = Pose2D(frame.origin, place(*random)).heading();
  return frame;
}

Eigen::Vector2d InFrame(const FanFrame& frame, double x, double y) {
  const Eigen::Vector2d offset = Eigen::Vector2d(x, y) - frame.origin;
  return {frame.axis.dot(offset),
          frame.axis.x() * offset.y() - frame.axis.y() * offset.x()};
}

double AngleOf(const Eigen::Vector2d& v) { return std::atan2(v.y(), v.x()); }

TEST(FanLanesTest, BearingsAreAngles) {
  EXPECT_EQ(Bearing({2.0, 0.0}), 0.0);
  EXPECT_DOUBLE_EQ(Bearing({0.0, 3.0}), 0.5 * kPi);
  EXPECT_DOUBLE_EQ(Bearing({-1.0, 0.0}), kPi);
  EXPECT_DOUBLE_EQ(Bearing({0.0, -1.0}), 1.5 * kPi);
  for (double angle = 0.0; angle < 2.0 * kPi; angle += 0.001) {
    EXPECT_NEAR(Bearing({7.0 * std::cos(angle), 7.0 * std::sin(angle)}), angle,
                kBearingError);
  }
}

TEST(FanLanesTest, ViewsHoldAllOfABox) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(-9.0, 9.0);
  std::uniform_real_distribution<double> size(0.01, 6.0);
  for (int scene = 0; scene < 2000; ++scene) {
    const FanFrame frame = RandomFrame(&random);
    BoxLanes boxes;
    for (int i = 0; i < kFanLanes; ++i) {
      boxes.min_x[i] = place(random);
      boxes.min_y[i] = place(random);
      boxes.max_x[i] = boxes.min_x[i] + size(random);
      boxes.max_y[i] = boxes.min_y[i] + size(random);
    }
    const ViewLanes views = ViewBoxes(frame, boxes);
    for (int i = 0; i < kFanLanes; ++i) {
      const double x =
          std::clamp(frame.origin.x(), boxes.min_x[i], boxes.max_x[i]);
      const double y =
          std::clamp(frame.origin.y(), boxes.min_y[i], boxes.max_y[i]);
      EXPECT_NEAR(views.distance_squared[i], InFrame(frame, x, y).squaredNorm(),
                  1e-9);
      const double width = views.high[i] - views.low[i];
      if (views.distance_squared[i] == 0.0) {
        EXPECT_DOUBLE_EQ(width, 2.0 * kPi);
        continue;
      }
      double widest = 0.0;
      for (const double corner_x : {boxes.min_x[i], boxes.max_x[i]}) {
        for (const double corner_y : {boxes.min_y[i], boxes.max_y[i]}) {
          const double beyond =
              Beyond(views.low[i], AngleOf(InFrame(frame, corner_x, corner_y)));
          EXPECT_GE(beyond, -kBearingError);
          widest = std::max(widest, beyond);
        }
      }
      EXPECT_NEAR(width, widest, 2.0 * kBearingError) << "and no more";
    }
  }
}

TEST(FanLanesTest, ViewsHoldAllOfADisc) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> place(-9.0, 9.0);
  std::uniform_real_distribution<double> size(0.01, 3.0);
  for (int scene = 0; scene < 2000; ++scene) {
    const FanFrame frame = RandomFrame(&random);
    DiscLanes discs;
    for (int i = 0; i < kFanLanes; ++i) {
      discs.x[i] = place(random);
      discs.y[i] = place(random);
      discs.radius[i] = size(random);
    }
    DiscLanes in_fan;
    const ViewLanes views = ViewDiscs(frame, discs, &in_fan);
    for (int i = 0; i < kFanLanes; ++i) {
      const Eigen::Vector2d at = InFrame(frame, discs.x[i], discs.y[i]);
      EXPECT_NEAR(in_fan.x[i], at.x(), 1e-12);
      EXPECT_NEAR(in_fan.y[i], at.y(), 1e-12);
      EXPECT_NEAR(views.distance_squared[i], at.squaredNorm(), 1e-9);
      const double width = views.high[i] - views.low[i];
      if (at.norm() <= discs.radius[i]) {
        EXPECT_DOUBLE_EQ(width, 2.0 * kPi);
        continue;
      }
      const double half = std::asin(discs.radius[i] / at.norm());
      EXPECT_GE(width, 2.0 * half);
      if (width < 2.0 * kPi) {
        EXPECT_NEAR(Beyond(views.low[i], AngleOf(at)), 0.5 * width,
                    kBearingError);
      }
    }
  }
}

TEST(FanLanesTest, PlacesByHand) {
  const std::array<int, kFanLanes> expected = {7, 0, 3, 4, 6, 1, 5, 2};
  EXPECT_EQ(PlacesFromFar({0.0, 9.0, 4.0, 4.0, 1.0, 8.0, 2.0, 5.0}), expected);
}

}  // namespace
}  // namespace vfh_astar
