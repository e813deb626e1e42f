#include "vfh_astar/planning/block_search.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "vfh_astar/planning/block_lengths.h"

namespace vfh_astar {
namespace {

// Bands of ten cells, and in them steps of two and a half: narrower ones let
// blocks be looked at again, wider ones let them be looked at in vain.
constexpr int kBandBits = 12;
constexpr int kOrderBits = 10;

constexpr int kSide = kBlockSide;

constexpr BlockLength StepLength(int direction) {
  return direction % 2 == 0 ? kBlockStraight : kBlockDiagonal;
}

}  // namespace

BlockSearch::BlockSearch(int width, int height, const BlockKernel& kernel)
    : kernel_(&kernel),
      stride_((width + kSide - 1) / kSide + 2),
      blocks_(stride_ * ((height + kSide - 1) / kSide + 2)),
      // Lengths in a block differ by less than 15 bits, estimates by little
      // more, and those of a band by less than 16 from its beginning.
      open_(kBandBits, kOrderBits, 2 << 16, 1 << 20) {
  assert(0 < width && width < 32000 && 0 < height && height < 32000);
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    const auto place = static_cast<std::ptrdiff_t>(i);
    blocks_[i].x = static_cast<std::int16_t>((place % stride_ - 1) * kSide);
    blocks_[i].y = static_cast<std::int16_t>((place / stride_ - 1) * kSide);
  }
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) SetBlocked({x, y}, false);
  }
}

inline bool BlockSearch::IsFree(const Cell& cell) const {
  const int bit = kSide * InBlock(cell.y) + InBlock(cell.x);
  return (blocks_[IndexOfBlock(cell)].free_rows >> bit & 1) != 0;
}

void BlockSearch::SetBlocked(const Cell& cell, bool is_blocked) {
  Block& block = blocks_[IndexOfBlock(cell)];
  const int x = InBlock(cell.x);
  const int y = InBlock(cell.y);
  const std::uint64_t in_row = std::uint64_t{1} << (kSide * y + x);
  const std::uint64_t in_column = std::uint64_t{1} << (kSide * x + y);
  if (is_blocked) {
    block.free_rows &= ~in_row;
    block.free_columns &= ~in_column;
  } else {
    block.free_rows |= in_row;
    block.free_columns |= in_column;
  }
  const auto is_end = [](int i) { return i == 0 || i == kSide - 1; };
  if (is_end(x) && is_end(y)) {
    UpdateCorner({x == 0 ? cell.x - 1 : cell.x, y == 0 ? cell.y - 1 : cell.y});
  }
}

void BlockSearch::UpdateCorner(const Cell& cell) {
  bool is_open = true;
  for (int i = 0; i < 4; ++i) {
    is_open &= IsFree({cell.x + i % 2, cell.y + i / 2});
  }
  for (int i = 0; i < 4; ++i) {
    Block& block = blocks_[IndexOfBlock({cell.x + i % 2, cell.y + i / 2})];
    // To the south-western one it is the north-eastern corner.
    const std::uint32_t bit = 1U << (3 - i);
    block.open_corners =
        is_open ? block.open_corners | bit : block.open_corners & ~bit;
  }
}

inline bool BlockSearch::IsOpen(const Cell& cell, int direction) const {
  const Cell step = kSteps[direction];
  return IsFree({cell.x + step.x, cell.y + step.y}) &&
         IsFree({cell.x + step.x, cell.y}) && IsFree({cell.x, cell.y + step.y});
}

inline BlockLength BlockSearch::LengthTo(const Cell& cell) const {
  const Block& block = blocks_[IndexOfBlock(cell)];
  if (block.generation != generation_) return kNoLength;
  const std::int16_t below = block.row(InBlock(cell.y))[InBlock(cell.x)];
  return below == 0 ? kNoLength : block.ceiling - below;
}

JumpPointResult BlockSearch::Run(const Cell& start, const Cell& goal) {
  assert(IsFree(start) && IsFree(goal));
  if (++generation_ == 0) {
    for (Block& block : blocks_) block.generation = 0;
    generation_ = 1;
  }
  goal_ = goal;
  goal_length_ = kNoLength;
  dropped_estimate_ = kNoLength;
  open_.Restart(Heuristic(start));
  Block& first = blocks_[IndexOfBlock(start)];
  first.Enter(0, generation_);
  first.row(InBlock(start.y))[InBlock(start.x)] = kFirstBelow;
  Open(first, Heuristic(start));

  const Block& last = blocks_[IndexOfBlock(goal)];
  JumpPointResult result;
  while (!open_.empty()) {
    least_key_ = open_.LeastKey();
    if (least_key_ >= goal_length_) break;
    Block& block = *open_.Pop();
    // Opened twice and done already, or to be done later; or too far.
    if (block.key >= std::min(open_.EndOfBand(), goal_length_)) continue;
    block.key = kNoLength;
    ++result.nodes_expanded;
    Expand(block);
    if (&block == &last) goal_length_ = std::min(goal_length_, LengthTo(goal));
  }
  if (goal_length_ != kNoLength && is_decided()) TracePath(start, result);
  return result;
}

int BlockSearch::DirectionBack(const Cell& cell, BlockLength length,
                               int preferred) const {
  for (const int turn : kTurns) {
    const int direction = (preferred + turn) % kDirections;
    const Cell before = {cell.x + kSteps[direction].x,
                         cell.y + kSteps[direction].y};
    // Few cells have the right length.
    if (LengthTo(before) == length - StepLength(direction) &&
        IsOpen(cell, direction)) {
      return direction;
    }
  }
  assert(false);
  return 0;
}

void BlockSearch::TracePath(const Cell& start, JumpPointResult& result) const {
  result.is_found = true;
  result.cells = {goal_};
  BlockLength length = goal_length_;
  int direction = 0;
  while (result.cells.back() != start) {
    const Cell cell = result.cells.back();
    direction = DirectionBack(cell, length, direction);
    length -= StepLength(direction);
    result.cells.push_back(
        {cell.x + kSteps[direction].x, cell.y + kSteps[direction].y});
    result.length += direction % 2 == 0 ? 1.0 : std::sqrt(2.0);
  }
  std::reverse(result.cells.begin(), result.cells.end());
}

}  // namespace vfh_astar
