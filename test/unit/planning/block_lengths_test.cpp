#include "vfh_astar/planning/block_lengths.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "vfh_astar/planning/cost_map.h"

namespace vfh_astar {
namespace {

constexpr int kCells = kBlockSide * kBlockSide;

bool IsFree(std::uint64_t free, int x, int y) {
  return 0 <= x && x < kBlockSide && 0 <= y && y < kBlockSide &&
         (free >> (kBlockSide * y + x) & 1) != 0;
}

/// One step after the other till nothing changes.
void RelaxCells(std::uint64_t free, LaneSquare& rows) {
  for (int round = 0; round < kCells; ++round) {
    for (int cell = 0; cell < kCells; ++cell) {
      const int x = cell % kBlockSide;
      const int y = cell / kBlockSide;
      if (rows[y][x] == 0) continue;
      for (int direction = 0; direction < kDirections; ++direction) {
        const int to_x = x + kSteps[direction].x;
        const int to_y = y + kSteps[direction].y;
        if (!IsFree(free, to_x, to_y) || !IsFree(free, to_x, y) ||
            !IsFree(free, x, to_y)) {
          continue;
        }
        const int length =
            rows[y][x] - (direction % 2 == 0 ? kBlockStraight : kBlockDiagonal);
        rows[to_y][to_x] =
            static_cast<std::int16_t>(std::max<int>(rows[to_y][to_x], length));
      }
    }
  }
}

TEST(BlockLengths, AreThoseOfSingleSteps) {
  std::mt19937 random(3);
  for (int round = 0; round < 500; ++round) {
    std::uint64_t free_rows = 0;
    std::uint64_t free_columns = 0;
    LaneSquare rows{};
    for (int cell = 0; cell < kCells; ++cell) {
      const int x = cell % kBlockSide;
      const int y = cell / kBlockSide;
      if (static_cast<int>(random() % 100) < round / 10) continue;
      free_rows |= std::uint64_t{1} << (kBlockSide * y + x);
      free_columns |= std::uint64_t{1} << (kBlockSide * x + y);
      if (random() % 10 == 0) {
        rows[y][x] = static_cast<std::int16_t>(20000 + random() % 12000);
      }
    }
    LaneSquare columns = Transposed(rows);
    LaneSquare expected = rows;
    RelaxCells(free_rows, expected);
    RelaxBlock(free_rows, free_columns, rows, columns);
    for (int y = 0; y < kBlockSide; ++y) {
      for (int x = 0; x < kBlockSide; ++x) {
        ASSERT_EQ(rows[y][x], expected[y][x]) << "round " << round;
        ASSERT_EQ(columns[x][y], expected[y][x]) << "round " << round;
      }
    }
  }
}

}  // namespace
}  // namespace vfh_astar
