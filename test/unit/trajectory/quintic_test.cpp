#include "vfh_astar/trajectory/quintic.h"

#include <gtest/gtest.h>

#include <random>

namespace vfh_astar {
namespace {

TEST(Quintic, DerivativesByHand) {
  // x = 1 + 2 tau + 3 tau^2 + 4 tau^3 + 5 tau^4 + 6 tau^5 in 2 s, at tau = 1.
  Quintic quintic;
  quintic << 1, 2, 3, 4, 5, 6;
  const Jet jet = Evaluate(quintic, 2.0, 1.0);
  EXPECT_DOUBLE_EQ(jet.value, 21.0);
  EXPECT_DOUBLE_EQ(jet.first, (2 + 6 + 12 + 20 + 30) / 2.0);
  EXPECT_DOUBLE_EQ(jet.second, (6 + 24 + 60 + 120) / 4.0);
  EXPECT_DOUBLE_EQ(jet.third, (24 + 120 + 360) / 8.0);
}

TEST(Quintic, HermiteFromRestToRest) {
  // The minimum jerk motion over 1 m in 2 s: half way at half time, with
  // 15/8 of the mean speed there.
  const Quintic quintic = HermiteQuintic({0, 0, 0, 0}, {1, 0, 0, 0}, 2.0);
  const Jet middle = Evaluate(quintic, 2.0, 0.5);
  EXPECT_NEAR(middle.value, 0.5, 1e-12);
  EXPECT_NEAR(middle.first, 15.0 / 8.0 / 2.0, 1e-12);
  EXPECT_NEAR(middle.second, 0.0, 1e-12);
}

TEST(Quintic, HermiteMeetsBothEnds) {
  std::mt19937 random(1);
  std::uniform_real_distribution<> value(-3.0, 3.0);
  std::uniform_real_distribution<> length(0.05, 20.0);
  for (int i = 0; i < 1000; ++i) {
    const Jet start{value(random), value(random), value(random), 0.0};
    const Jet end{value(random), value(random), value(random), 0.0};
    const double duration = length(random);
    const Quintic quintic = HermiteQuintic(start, end, duration);
    for (const double tau : {0.0, 1.0}) {
      const Jet expected = tau == 0.0 ? start : end;
      const Jet jet = Evaluate(quintic, duration, tau);
      EXPECT_NEAR(jet.value, expected.value, 1e-9);
      EXPECT_NEAR(jet.first, expected.first, 1e-9);
      EXPECT_NEAR(jet.second, expected.second, 1e-8);
    }
  }
}

}  // namespace
}  // namespace vfh_astar
