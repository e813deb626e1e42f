#include "vfh_astar/planning/block_search.h"

#include <algorithm>
#include <array>

#include "vfh_astar/planning/block_lengths.h"

namespace vfh_astar {
namespace {

constexpr int kSide = kBlockSide;
constexpr int kLast = kSide - 1;

}  // namespace

void BlockSearch::Expand(Block& block) {
  const EstimateFrame frame = {{goal_.x - block.x, goal_.y - block.y},
                               least_key_,
                               goal_length_,
                               generation_};
  EdgeOffers offers;
  const BlockNews result = kernel_->expand(block, stride_, frame, offers);
  EdgeNews news = result.edges;
  if (result.is_short) DropUpTo(block, kLeastBelow - 1);
  if (!news.fits) {
    MakeRoom(block, offers);
    news = kernel_->push(block, stride_, offers, frame);
  }
  if (news.fits) {
    const std::array<Block*, kBlockEdges> beside = BlocksBeside(block, stride_);
    for (unsigned left = news.is_opened; left != 0; left &= left - 1) {
      const int edge = __builtin_ctz(left);
      beside[edge]->key = news.keys[edge];
      Push(*beside[edge]);
    }
  } else {
    PushEdgesByCell(block, offers);
  }
  PushCorners(block, result.corners);
}

void BlockSearch::MakeRoom(Block& block, const EdgeOffers& offers) {
  const std::array<Block*, kBlockEdges> beside = BlocksBeside(block, stride_);
  for (int edge = 0; edge < kBlockEdges; ++edge) {
    Block& to = *beside[edge];
    const int greatest = GreatestLane(offers.lanes[edge]);
    if (greatest == 0) continue;
    const int below = greatest + static_cast<int>(to.ceiling - block.ceiling);
    if (below >= kMostBelow) LowerCeiling(to, below - kFirstBelow);
  }
}

void BlockSearch::PushEdgesByCell(Block& block, const EdgeOffers& offers) {
  const std::array<Block*, kBlockEdges> beside = BlocksBeside(block, stride_);
  const Cell first[] = {{block.x, block.y - 1},
                        {block.x, block.y + kSide},
                        {block.x - 1, block.y},
                        {block.x + kSide, block.y}};
  for (int edge = 0; edge < kBlockEdges; ++edge) {
    for (int lane = 0; lane < kLanes; ++lane) {
      const int below = offers.lanes[edge][lane];
      if (below == 0) continue;
      const Cell cell = {first[edge].x + (edge < 2 ? lane : 0),
                         first[edge].y + (edge < 2 ? 0 : lane)};
      PushCell(block, *beside[edge], cell, below);
    }
  }
}

inline void BlockSearch::PushCorners(Block& block, unsigned is_news) {
  for (unsigned left = is_news; left != 0; left &= left - 1) {
    const int corner = __builtin_ctz(left);
    const Cell step = {corner % 2 == 0 ? -1 : 1, corner / 2 == 0 ? -1 : 1};
    const Cell from = {step.x < 0 ? 0 : kLast, step.y < 0 ? 0 : kLast};
    Block& to = (&block)[step.y * stride_ + step.x];
    PushCell(block, to, {block.x + from.x + step.x, block.y + from.y + step.y},
             block.row(from.y)[from.x] - kBlockDiagonal);
  }
}

void BlockSearch::PushCell(const Block& from, Block& to, const Cell& cell,
                           int below) {
  const BlockLength length = from.ceiling - below;
  const BlockLength estimate = length + Heuristic(cell);
  if (estimate >= goal_length_) return;
  if (to.generation != generation_) to.Enter(length, generation_);
  int below_to = static_cast<int>(to.ceiling - length);
  if (below_to > kMostBelow) {
    LowerCeiling(to, below_to - kFirstBelow);
    below_to = kFirstBelow;
  }
  std::int16_t* const row =
      reinterpret_cast<std::int16_t*>(&to.row(InBlock(cell.y)));
  std::int16_t& known = row[InBlock(cell.x)];
  if (known != 0 && below_to <= known) return;
  if (below_to < kLeastBelow) {
    Drop(estimate);
    return;
  }
  known = static_cast<std::int16_t>(below_to);
  Open(to, estimate);
}

void BlockSearch::DropUpTo(const Block& block, int most) {
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      int below = block.row(y)[x];
      if (x == 0) below = std::max<int>(below, block.columns[0][y]);
      if (x == kLast) below = std::max<int>(below, block.columns[1][y]);
      if (below == 0 || below > most) continue;
      Drop(block.ceiling - below + Heuristic({block.x + x, block.y + y}));
    }
  }
}

void BlockSearch::LowerCeiling(Block& block, int by) {
  const Lanes fall =
      AllLanes(static_cast<std::int16_t>(std::min<int>(by, kMostBelow)));
  Lanes is_lost{};
  for (Lanes& row : block.folded_rows) {
    is_lost |= (row > 0) & (row <= fall);
  }
  for (Lanes& column : block.columns) {
    is_lost |= (column > 0) & (column <= fall);
  }
  if (AnySet(is_lost)) DropUpTo(block, by);
  for (Lanes& row : block.folded_rows) row = LessBy(row, fall);
  for (Lanes& column : block.columns) column = LessBy(column, fall);
  block.ceiling -= by;
}

}  // namespace vfh_astar
