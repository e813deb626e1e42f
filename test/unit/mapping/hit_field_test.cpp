#include "vfh_astar/mapping/hit_field.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace vfh_astar {
namespace {

TEST(HitField, AHitIsAGaussianOfItsDistance) {
  HitField field(0.05, 0.1, 0.6);
  // In the centre of a cell, left of and below the origin.
  field.Add({{-0.975, -0.025}}, {});
  EXPECT_NEAR(field.At({-0.975, -0.025}).value, 0.6, 0.01);
  EXPECT_NEAR(field.At({-0.875, -0.025}).value, 0.6 * std::exp(-0.5), 0.01);
  EXPECT_NEAR(field.At({-0.975, 0.175}).value, 0.6 * std::exp(-2.0), 0.01);
  EXPECT_EQ(field.At({-0.5, -0.025}).value, 0.0);
}

TEST(HitField, FurtherHitsAddAPartOfWhatIsMissing) {
  HitField field(0.05, 0.1, 0.5);
  for (const double expected : {0.5, 0.75, 0.875}) {
    field.Add({{0.025, 0.025}}, {});
    EXPECT_NEAR(field.At({0.025, 0.025}).value, expected, 0.01);
  }
}

TEST(HitField, AWallSeenOftenStaysAsSharpAsItsHits) {
  HitField field(0.05, 0.1, 0.5);
  for (int i = 0; i < 50; ++i) field.Add({{0.025, 0.025}}, {});
  EXPECT_NEAR(field.At({0.125, 0.025}).value, std::exp(-0.5), 0.02);
  EXPECT_NEAR(field.At({0.225, 0.025}).value, std::exp(-2.0), 0.02);
}

TEST(HitField, PointsAreTakenToThePosesFrame) {
  HitField field(0.05, 0.05, 1.0);
  field.Add({{2.0, 1.0}}, {3.0, 4.0, 0.5 * kPi});
  // Between four centres the field lies a little below its top.
  EXPECT_GT(field.At({2.0, 6.0}).value, 0.75);
}

TEST(HitField, TheSlopeIsThatOfTheValue) {
  HitField field(0.05, 0.1, 0.7);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-3.0, 3.0);
  for (int i = 0; i < 2000; ++i) {
    field.Add({{place(random), place(random)}}, {});
  }
  constexpr double kStep = 1e-6;
  for (int i = 0; i < 500; ++i) {
    const Eigen::Vector2d at(place(random), place(random));
    const HitField::Sample sample = field.At(at);
    const double dx = field.At(at + Eigen::Vector2d(kStep, 0)).value;
    const double dy = field.At(at + Eigen::Vector2d(0, kStep)).value;
    EXPECT_NEAR((dx - sample.value) / kStep, sample.slope.x(), 1e-4);
    EXPECT_NEAR((dy - sample.value) / kStep, sample.slope.y(), 1e-4);
  }
}

TEST(HitField, ValuesOfARectangleAreThoseOfTheCells) {
  HitField field(0.1, 0.1, 0.9);
  for (double x = -5.0; x < 5.0; x += 0.3) field.Add({{x, 0.5 * x}}, {});
  const cv::Rect cells(-37, -20, 90, 41);
  const std::vector<std::uint8_t> values = field.Values(cells);
  for (int y = 0; y < cells.height; ++y) {
    for (int x = 0; x < cells.width; ++x) {
      const Eigen::Vector2d centre(0.1 * (cells.x + x + 0.5),
                                   0.1 * (cells.y + y + 0.5));
      EXPECT_NEAR(values[y * cells.width + x] / 255.0, field.At(centre).value,
                  1e-6);
    }
  }
}

TEST(HitField, CopiesShareTheTilesThatAreEqual) {
  HitField field(0.05, 0.05, 0.5);
  field.Add({{0.1, 0.1}, {10.1, 10.1}}, {});
  HitField copy = field;
  EXPECT_TRUE(copy.SharesTile(field, 2, 2));
  EXPECT_TRUE(copy.SharesTile(field, 202, 202));
  copy.Add({{10.2, 10.2}}, {});
  EXPECT_TRUE(copy.SharesTile(field, 2, 2));
  EXPECT_FALSE(copy.SharesTile(field, 202, 202));
  EXPECT_EQ(field.At({10.3, 10.3}).value, 0.0);
}

TEST(HitField, KeepsItsValuesWhenItGrows) {
  HitField field(0.05, 0.05, 0.5);
  field.Add({{0.025, 0.025}}, {});
  field.Add({{-300.0, 200.0}, {150.0, -220.0}}, {});
  EXPECT_NEAR(field.At({0.025, 0.025}).value, 0.5, 0.01);
}

}  // namespace
}  // namespace vfh_astar
