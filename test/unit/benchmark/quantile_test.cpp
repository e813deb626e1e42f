#include "benchmark/quantile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

namespace vfh_astar {
namespace {

TEST(Quantile, ByHand) {
  EXPECT_EQ(Quantile(std::vector<int>{7}, 0.0), 7);
  EXPECT_EQ(Quantile(std::vector<int>{7}, 1.0), 7);
  const std::vector<double> values = {4.0, 1.0, 3.0, 2.0, 5.0};
  EXPECT_EQ(Quantile(values, 0.0), 1.0);
  EXPECT_EQ(Quantile(values, 0.5), 3.0);
  EXPECT_EQ(Quantile(values, 0.99), 5.0);
  EXPECT_EQ(Quantile(values, 1.0), 5.0);
  EXPECT_EQ(Quantile(std::vector<int>{1, 2, 3, 4}, 0.5), 3);
}

TEST(Quantile, OneInAHundredLiesAboveThe99th) {
  std::vector<int> values(1000);
  std::iota(values.begin(), values.end(), 0);
  std::shuffle(values.begin(), values.end(), std::mt19937(3));
  EXPECT_EQ(Quantile(values, 0.99), 990);
  EXPECT_EQ(Quantile(values, 0.5), 500);
}

}  // namespace
}  // namespace vfh_astar
