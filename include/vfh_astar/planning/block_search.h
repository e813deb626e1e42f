#ifndef VFH_ASTAR_PLANNING_BLOCK_SEARCH_H_
#define VFH_ASTAR_PLANNING_BLOCK_SEARCH_H_

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "vfh_astar/grid/grid.h"
#include "vfh_astar/planning/band_queue.h"
#include "vfh_astar/planning/block_lengths.h"
#include "vfh_astar/planning/cost_map.h"
#include "vfh_astar/planning/jump_point_search.h"

namespace vfh_astar {

/// Finds what JumpPointSearch finds, by blocks of 8 x 8 cells: quicker where
/// obstacles lie so densely that jumps are short, slower in the open.
///
/// A* whose open nodes are blocks. A block is open when its neighbours have
/// found shorter ways to cells at its edge, and leaves the queue by the least
/// estimate among these and, where estimates are much the same, by length. Then
/// the lengths in all of its cells are brought up to date, sixteen at a time
/// (with AVX2, else eight), and what has become shorter goes on to its
/// neighbours. So a block is looked at less than twice instead of its cells one
/// by one. The search is over when no open block can make the goal's length
/// less. Blocked cells may change at any time. Ways of ten million cells are
/// too long for its numbers.
class BlockSearch {
 public:
  /// A map of free cells.
  /// @param[in] kernel what blocks are expanded by; results do not depend on
  /// it.
  BlockSearch(int width, int height,
              const BlockKernel& kernel = FastestBlockKernel());

  void SetBlocked(const Cell& cell, bool is_blocked);

  /// @param[in] start, goal free cells of the map.
  /// @return its nodes are blocks. Nothing is decided when is_decided() is
  ///   false afterwards.
  JumpPointResult Run(const Cell& start, const Cell& goal);

  /// False when lengths within one block differed by more than its numbers
  /// hold, and a shortest path may have been among what was dropped: the last
  /// search's result is then to be thrown away.
  bool is_decided() const {
    return dropped_estimate_ == kNoLength || dropped_estimate_ > goal_length_;
  }

 private:
  using Block = LengthBlock;

  /// @param[in] cell of the map or beside it.
  std::size_t IndexOfBlock(const Cell& cell) const {
    // Without a sign, to divide is to shift.
    const auto x = static_cast<unsigned>(cell.x + kBlockSide);
    const auto y = static_cast<unsigned>(cell.y + kBlockSide);
    return std::size_t{y / kBlockSide} * stride_ + x / kBlockSide;
  }
  /// A coordinate of a cell, counted from its block's first one.
  static int InBlock(int coordinate) { return coordinate & (kBlockSide - 1); }
  bool IsOpen(const Cell& cell, int direction) const;
  bool IsFree(const Cell& cell) const;
  /// Notes whether a diagonal step leads through the corner at which four
  /// blocks meet.
  /// @param[in] cell the south-western one of the four at that corner.
  void UpdateCorner(const Cell& cell);
  BlockLength Heuristic(const Cell& cell) const;
  /// The length to a cell; nothing (kNoLength) when no way has been found.
  BlockLength LengthTo(const Cell& cell) const;

  void Expand(Block& block);
  /// Lowers the ceilings of the blocks beside as far as what is offered needs.
  void MakeRoom(Block& block, const EdgeOffers& offers);
  void PushEdgesByCell(Block& block, const EdgeOffers& offers);
  /// @param[in] is_news a bit per corner.
  void PushCorners(Block& block, unsigned is_news);
  void PushCell(const Block& from, Block& to, const Cell& cell, int below);
  void Open(Block& block, BlockLength estimate);
  /// Puts a block with a new key into the queue.
  void Push(Block& block) {
    // The ceiling stands for the length.
    open_.Push(block.key, block.ceiling, &block);
  }
  void Drop(BlockLength estimate) {
    dropped_estimate_ = std::min(dropped_estimate_, estimate);
  }
  /// Drops the lengths that fall short of the ceiling by no more than `most`.
  void DropUpTo(const Block& block, int most);
  void LowerCeiling(Block& block, int by);
  /// Where a shortest way comes from, as a direction from the cell.
  /// @param[in] preferred among equal ones.
  int DirectionBack(const Cell& cell, BlockLength length, int preferred) const;
  void TracePath(const Cell& start, JumpPointResult& result) const;

  const BlockKernel* kernel_;
  std::ptrdiff_t stride_;  ///< blocks in a row, with a border of blocked ones.
  std::vector<Block> blocks_;
  BandQueue<Block*> open_;
  std::uint32_t generation_ = 0;
  // Of the present search:
  Cell goal_;
  BlockLength goal_length_ = 0;
  BlockLength least_key_ = 0;  ///< a lower bound of all that are open.
  BlockLength dropped_estimate_ = kNoLength;
};

inline BlockLength BlockSearch::Heuristic(const Cell& cell) const {
  return OctileDistance(cell, goal_, kBlockStraight, kBlockDiagonal);
}

inline void BlockSearch::Open(Block& block, BlockLength estimate) {
  if (estimate >= goal_length_ || estimate >= block.key) return;
  block.key = estimate;
  Push(block);
}

}  // namespace vfh_astar

#endif  // VFH_ASTAR_PLANNING_BLOCK_SEARCH_H_
