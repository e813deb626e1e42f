#include "vfh_astar/planning/lanes.h"

#include <gtest/gtest.h>

#include <limits>

namespace vfh_astar {
namespace {

TEST(Lanes, ShiftBringsInZeros) {
  const Lanes lanes = {1, 2, 3, 4, 5, 6, 7, 8};
  for (int i = 0; i < kLanes; ++i) {
    EXPECT_EQ(ShiftedUp(lanes)[i], i == 0 ? 0 : i);
    EXPECT_EQ(ShiftedDown(lanes)[i], i == kLanes - 1 ? 0 : i + 2);
    EXPECT_EQ(ShiftedUpByTwo(lanes)[i], i < 2 ? 0 : i - 1);
    EXPECT_EQ(ShiftedDownByTwo(lanes)[i], i >= kLanes - 2 ? 0 : i + 3);
  }
}

TEST(Lanes, TransposeTurnsRowsIntoColumns) {
  LaneSquare square;
  for (int y = 0; y < kLanes; ++y) {
    for (int x = 0; x < kLanes; ++x) {
      square[y][x] = static_cast<std::int16_t>(10 * y + x);
    }
  }
  const LaneSquare turned = Transposed(square);
  for (int y = 0; y < kLanes; ++y) {
    for (int x = 0; x < kLanes; ++x) EXPECT_EQ(turned[y][x], 10 * x + y);
  }
}

TEST(Lanes, DifferenceStopsAtZero) {
  const Lanes a = {0, 0, 5, 5, 5, 32767, 32767, 32767};
  const Lanes b = {0, 32767, 4, 5, 6, 0, 32766, 32767};
  const Lanes less = LessBy(a, b);
  const Lanes expected = {0, 0, 1, 0, 0, 32767, 1, 0};
  for (int i = 0; i < kLanes; ++i) EXPECT_EQ(less[i], expected[i]);
}

TEST(Lanes, SumStopsAtTheLimit) {
  const Lanes a = {0, 5, 20000, 32767, -5, -20000, -32768, 32767};
  const Lanes b = {0, -7, 20000, 1, -6, -20000, -1, -32768};
  const Lanes expected = {0, -2, 32767, 32767, -11, -32768, -32768, -1};
  for (int i = 0; i < kLanes; ++i) EXPECT_EQ(SumUpToMost(a, b)[i], expected[i]);
}

TEST(Lanes, SignsAreBits) {
  EXPECT_EQ((SignBits(WideLanes{0, 1, 2, 3})), 0u);
  EXPECT_EQ((SignBits(WideLanes{-1, 1, -2, 3})), 5u);
  EXPECT_EQ(
      (SignBits(WideLanes{4, -4, 0, std::numeric_limits<std::int32_t>::min()})),
      10u);
}

TEST(Lanes, AnyLaneCounts) {
  EXPECT_FALSE(AnySet(AllLanes(0)));
  for (int i = 0; i < kLanes; ++i) {
    Lanes lanes = AllLanes(0);
    lanes[i] = 1;
    EXPECT_TRUE(AnySet(lanes));
    lanes = AllLanes(-20000);
    lanes[i] = -5;
    EXPECT_EQ(GreatestLane(lanes), -5);
  }
}

}  // namespace
}  // namespace vfh_astar
