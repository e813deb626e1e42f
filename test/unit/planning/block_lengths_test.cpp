#include "vfh_astar/planning/block_lengths.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <random>

#include "vfh_astar/planning/cost_map.h"

namespace vfh_astar {
namespace {

constexpr int kCells = kBlockSide * kBlockSide;

bool IsFree(std::uint64_t free, int x, int y) {
  return 0 <= x && x < kBlockSide && 0 <= y && y < kBlockSide &&
         (free >> (kBlockSide * y + x) & 1) != 0;
}

using Below = std::array<std::array<int, kBlockSide>, kBlockSide>;

/// One step after the other till nothing changes.
void RelaxCells(std::uint64_t free, Below& rows) {
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
        rows[to_y][to_x] = std::max(rows[to_y][to_x], length);
      }
    }
  }
}

/// Both kernels, as far as the processor has what they take.
class BlockLengths : public testing::TestWithParam<bool> {
 protected:
  void SetUp() override {
    kernel_ = GetParam() ? Avx2BlockKernel() : &BaselineBlockKernel();
    if (kernel_ == nullptr) GTEST_SKIP() << "this processor has no AVX2";
  }

  const BlockKernel* kernel_ = nullptr;
};

INSTANTIATE_TEST_SUITE_P(Kernels, BlockLengths, testing::Bool(),
                         [](const testing::TestParamInfo<bool>& info) {
                           return info.param ? "Avx2" : "Baseline";
                         });

void SetFree(LengthBlock& block, int x, int y) {
  block.free_rows |= std::uint64_t{1} << (kBlockSide * y + x);
  block.free_columns |= std::uint64_t{1} << (kBlockSide * x + y);
}

TEST_P(BlockLengths, AreThoseOfSingleSteps) {
  std::mt19937 random(3);
  int short_ones = 0;
  for (int round = 0; round < 500; ++round) {
    // Amid blocked ones.
    std::array<LengthBlock, 9> blocks;
    LengthBlock& block = blocks[4];
    Below expected{};
    for (int cell = 0; cell < kCells; ++cell) {
      const int x = cell % kBlockSide;
      const int y = cell / kBlockSide;
      if (static_cast<int>(random() % 100) < round / 10) continue;
      SetFree(block, x, y);
      if (random() % 10 != 0) continue;
      const int least = round % 2 == 0 ? 20000 : 1;
      const int most = round % 2 == 0 ? 32000 : 4000;
      expected[y][x] = least + static_cast<int>(random() % (most - least));
      const auto below = static_cast<std::int16_t>(expected[y][x]);
      // What comes from the blocks beside is only in the columns.
      const bool is_outer = x == 0 || x == kBlockSide - 1;
      if (is_outer && round % 3 != 0) {
        block.columns[x == 0 ? 0 : 1][y] = below;
      } else {
        block.row(y)[x] = below;
      }
    }
    RelaxCells(block.free_rows, expected);
    EdgeOffers offers;
    const BlockNews news = kernel_->expand(block, 3, EstimateFrame{}, offers);
    ASSERT_TRUE(news.edges.fits);
    ASSERT_EQ(news.edges.is_opened, 0u);
    ASSERT_EQ(news.corners, 0u);
    const bool is_short = news.is_short;
    bool expected_short = false;
    for (int y = 0; y < kBlockSide; ++y) {
      for (int x = 0; x < kBlockSide; ++x) {
        const int below = std::max(0, expected[y][x]);
        ASSERT_EQ(block.row(y)[x], below) << "round " << round;
        expected_short |= 0 < below && below < kLeastBelow;
      }
      ASSERT_EQ(block.columns[0][y], block.row(y)[0]);
      ASSERT_EQ(block.columns[1][y], block.row(y)[kBlockSide - 1]);
    }
    ASSERT_EQ(is_short, expected_short) << "round " << round;
    short_ones += is_short ? 1 : 0;
  }
  EXPECT_GT(short_ones, 50);
  EXPECT_LT(short_ones, 480);
}

constexpr std::uint32_t kGeneration = 5;

/// A block amid others, in rows of three.
struct Neighbourhood {
  static constexpr std::ptrdiff_t kStride = 3;
  std::array<LengthBlock, 9> blocks;
  LengthBlock& centre = blocks[4];
  std::array<LengthBlock*, kBlockEdges> beside = {&blocks[1], &blocks[7],
                                                  &blocks[3], &blocks[5]};

  explicit Neighbourhood(std::mt19937& random) {
    const auto any = [&](int least, int count) {
      return least + static_cast<int>(random() % count);
    };
    for (LengthBlock& block : blocks) {
      for (int cell = 0; cell < kCells; ++cell) {
        if (any(0, 4) == 0) continue;
        SetFree(block, cell % kBlockSide, cell / kBlockSide);
        if (any(0, 3) == 0) continue;
        block.row(cell / kBlockSide)[cell % kBlockSide] = any(15000, 3000);
      }
      for (int y = 0; y < kBlockSide; ++y) {
        block.columns[0][y] = block.row(y)[0];
        block.columns[1][y] = block.row(y)[kBlockSide - 1];
      }
      block.ceiling = any(1000000, 3000);
      if (any(0, 2) == 0) block.key = any(1000000, 30000);
      block.open_corners = any(0, 16);
      block.generation = kGeneration - (any(0, 4) == 0 ? 1 : 0);
    }
  }

  /// The cell in its direction from the centre's first one.
  LengthBlock& BlockOf(int x, int y) {
    return blocks[3 * ((y + kBlockSide) / kBlockSide) +
                  (x + kBlockSide) / kBlockSide];
  }
  /// @param[in] before the blocks as they were before they got any news.
  unsigned CornersWithNews(const std::array<LengthBlock, 9>& before) {
    constexpr int kLast = kBlockSide - 1;
    unsigned corners = 0;
    for (int corner = 0; corner < 4; ++corner) {
      const int x = corner % 2 == 0 ? 0 : kLast;
      const int y = corner / 2 == 0 ? 0 : kLast;
      const LengthBlock& to =
          before[(corner % 2 == 0 ? 0 : 2) + (corner / 2 == 0 ? 0 : 6)];
      const int known = to.row(kLast - y)[kLast - x];
      const int length = centre.ceiling - centre.row(y)[x] + kBlockDiagonal;
      const bool is_less = known == 0 || to.generation != kGeneration ||
                           length < static_cast<int>(to.ceiling) - known;
      if ((centre.open_corners >> corner & 1) != 0 &&
          centre.row(y)[x] >= kLeastBelow && is_less) {
        corners |= 1U << corner;
      }
    }
    return corners;
  }
  bool IsFreeCell(int x, int y) {
    return IsFree(BlockOf(x, y).free_rows, (x + kBlockSide) % kBlockSide,
                  (y + kBlockSide) % kBlockSide);
  }
};

int Heuristic(int dx, int dy) {
  return kBlockStraight * std::max(std::abs(dx), std::abs(dy)) +
         (kBlockDiagonal - kBlockStraight) *
             std::min(std::abs(dx), std::abs(dy));
}

TEST_P(BlockLengths, GoOnToTheBlocksBeside) {
  std::mt19937 random(4);
  int opened = 0;
  int unfit = 0;
  int entered = 0;
  for (int round = 0; round < 1000; ++round) {
    Neighbourhood around(random);
    const Cell goal = {static_cast<int>(random() % 1000) - 500,
                       static_cast<int>(random() % 1000) - 500};
    // Now and then beyond the range, at either end.
    if (round % 10 == 0) around.centre.ceiling -= 15000 + random() % 6000;
    if (round % 10 == 5) around.centre.ceiling += 15000 + random() % 6000;
    const EstimateFrame frame = {
        goal,
        around.centre.ceiling - 20000 +
            std::max(0, Heuristic(goal.x, goal.y) - 12 * kBlockDiagonal),
        round % 2 == 0 ? kNoLength
                       : 1000000 - 15000 + Heuristic(goal.x, goal.y),
        kGeneration};

    const auto before = around.blocks;
    EdgeOffers offers;
    const BlockNews result =
        kernel_->expand(around.centre, Neighbourhood::kStride, frame, offers);
    const EdgeNews& news = result.edges;
    ASSERT_EQ(result.corners, around.CornersWithNews(before));
    bool fits = true;
    for (int edge = 0; edge < kBlockEdges; ++edge) {
      LengthBlock& to = *around.beside[edge];
      LengthBlock was = before[&to - around.blocks.data()];
      if (was.generation != kGeneration) {
        const int greatest = GreatestLane(offers.lanes[edge]);
        if (greatest == 0) continue;
        ++entered;
        was.Enter(around.centre.ceiling - greatest, kGeneration);
        ASSERT_EQ(to.ceiling, was.ceiling);
        ASSERT_EQ(to.generation, kGeneration);
      }
      const bool is_row = edge < 2;
      const int across = edge % 2 == 0 ? -1 : kBlockSide;
      const int from_line = edge % 2 == 0 ? 0 : kBlockSide - 1;
      BlockLength key = kNoLength;
      for (int lane = 0; lane < kBlockSide; ++lane) {
        const Cell cell = is_row ? Cell{lane, across} : Cell{across, lane};
        int best = 0;
        for (int aside = -1; aside <= 1; ++aside) {
          const int other = lane + aside;
          if (other < 0 || other >= kBlockSide) continue;
          const Cell from =
              is_row ? Cell{other, from_line} : Cell{from_line, other};
          if (!around.IsFreeCell(cell.x, cell.y) ||
              !around.IsFreeCell(from.x, from.y) ||
              !around.IsFreeCell(from.x, cell.y) ||
              !around.IsFreeCell(cell.x, from.y)) {
            continue;
          }
          best = std::max(best,
                          around.centre.row(from.y)[from.x] -
                              (aside == 0 ? kBlockStraight : kBlockDiagonal));
        }
        ASSERT_EQ(offers.lanes[edge][lane], best)
            << "round " << round << " edge " << edge << " lane " << lane;
        if (best == 0) continue;
        const int to_line = kBlockSide - 1 - from_line;
        const int known =
            is_row ? was.row(to_line)[lane] : was.columns[1 - edge % 2][lane];
        const int below =
            best + static_cast<int>(to.ceiling - around.centre.ceiling);
        if (below <= known && known > 0) continue;
        fits &= kLeastBelow <= below && below < kMostBelow;
        const BlockLength estimate =
            to.ceiling - below + Heuristic(goal.x - cell.x, goal.y - cell.y);
        key = std::min(key, estimate);
        if (!news.fits) continue;
        ASSERT_EQ(
            is_row ? to.row(to_line)[lane] : to.columns[1 - edge % 2][lane],
            below);
      }
      if (!news.fits) continue;
      const bool is_opened = key < was.key && key < frame.limit;
      ASSERT_EQ((news.is_opened >> edge & 1) != 0, is_opened)
          << "round " << round;
      if (!is_opened) continue;
      ASSERT_EQ(news.keys[edge], key);
      ++opened;
    }
    ASSERT_EQ(news.fits, fits) << "round " << round;
    unfit += fits ? 0 : 1;
  }
  EXPECT_GT(opened, 500);
  EXPECT_GT(unfit, 20);
  EXPECT_GT(entered, 200);
}

}  // namespace
}  // namespace vfh_astar
