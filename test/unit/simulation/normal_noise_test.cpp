#include "vfh_astar/simulation/normal_noise.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace vfh_astar {
namespace {

/// The share of a normal distribution below x.
double ShareBelow(double x) { return 0.5 * std::erfc(-x / std::sqrt(2.0)); }

TEST(NormalNoiseTest, EveryIntervalHasItsShare) {
  constexpr int kDraws = 4000000;
  constexpr double kWidth = 0.125;
  constexpr int kIntervals = 80;  // from -5 to 5.
  std::mt19937 random(1);
  std::vector<int> counts(kIntervals, 0);
  for (int i = 0; i < kDraws; ++i) {
    const double x = DrawNormal(&random);
    const int interval =
        static_cast<int>(std::floor(x / kWidth)) + kIntervals / 2;
    if (0 <= interval && interval < kIntervals) ++counts[interval];
  }
  for (int i = 0; i < kIntervals; ++i) {
    const double from = (i - kIntervals / 2) * kWidth;
    const double expected =
        kDraws * (ShareBelow(from + kWidth) - ShareBelow(from));
    // Five deviations of a count.
    EXPECT_NEAR(counts[i], expected, 5.0 * std::sqrt(expected) + 1.0) << from;
  }
}

TEST(NormalNoiseTest, HasItsMomentsAndItsTail) {
  constexpr int kDraws = 4000000;
  std::mt19937 random(2);
  double sum = 0.0, squares = 0.0, fourths = 0.0;
  int beyond = 0;
  for (int i = 0; i < kDraws; ++i) {
    const double x = DrawNormal(&random);
    sum += x;
    squares += x * x;
    fourths += x * x * x * x;
    if (std::abs(x) > 3.6) ++beyond;
  }
  EXPECT_NEAR(sum / kDraws, 0.0, 5.0 / std::sqrt(kDraws));
  EXPECT_NEAR(squares / kDraws, 1.0, 5.0 * std::sqrt(2.0 / kDraws));
  EXPECT_NEAR(fourths / kDraws, 3.0, 5.0 * std::sqrt(96.0 / kDraws));
  const double expected = kDraws * 2.0 * ShareBelow(-3.6);
  EXPECT_NEAR(beyond, expected, 5.0 * std::sqrt(expected));
}

TEST(NormalNoiseTest, SameSeedSameNumbers) {
  std::mt19937 first(3);
  std::mt19937 second(3);
  for (int i = 0; i < 1000; ++i) {
    EXPECT_EQ(DrawNormal(&first), DrawNormal(&second));
  }
}

}  // namespace
}  // namespace vfh_astar
