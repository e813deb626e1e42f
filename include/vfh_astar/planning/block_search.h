#ifndef VFH_ASTAR_PLANNING_BLOCK_SEARCH_H_
#define VFH_ASTAR_PLANNING_BLOCK_SEARCH_H_

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <vector>

#include "vfh_astar/grid/grid.h"
#include "vfh_astar/planning/block_lengths.h"
#include "vfh_astar/planning/bucket_queue.h"
#include "vfh_astar/planning/jump_point_search.h"
#include "vfh_astar/planning/lanes.h"

namespace vfh_astar {

/// Finds what JumpPointSearch finds, by blocks of 8 x 8 cells: quicker where
/// obstacles lie so densely that jumps are short, slower in the open.
///
/// A* whose open nodes are blocks. A block is open when its neighbours have
/// found shorter ways to cells at its edge, and leaves the queue by the least
/// estimate among these. Then the lengths in all of its cells are brought up to
/// date, eight at a time, and what has become shorter goes on to its
/// neighbours. So a block is looked at about twice instead of its cells one by
/// one. The search is over when no open block can make the goal's length less.
/// Blocked cells may change at any time.
class BlockSearch {
 public:
  /// A map of free cells.
  BlockSearch(int width, int height);

  void SetBlocked(const Cell& cell, bool is_blocked);

  /// @param[in] start, goal free cells of the map.
  /// @return its nodes are blocks. Nothing is decided when is_decided() is
  ///   false afterwards.
  JumpPointResult Run(const Cell& start, const Cell& goal);

  /// False when lengths within one block differed by more than its numbers
  /// hold, and a shortest path may have been among what was dropped: the last
  /// search's result is then to be thrown away.
  bool is_decided() const {
    return dropped_estimate_ == kNone || dropped_estimate_ > goal_length_;
  }

 private:
  using Length = std::uint32_t;
  static constexpr Length kNone = std::numeric_limits<Length>::max();
  // How far below the ceiling lengths may be.
  static constexpr int kMost = std::numeric_limits<std::int16_t>::max();
  // Where the first length in a block is put: what comes later may be shorter
  // by ten cells.
  static constexpr int kFirst = kMost - 10 * kBlockStraight;

  /// Lengths are kept as what they fall short of the block's `ceiling`, so that
  /// 16 bits do and 0 is a cell that no way leads to.
  struct Block {
    LaneSquare rows{};
    // What has come from the blocks beside, for the outermost columns.
    Lanes west{};
    Lanes east{};
    std::uint64_t free_rows = 0;     ///< a bit per cell, a byte per row.
    std::uint64_t free_columns = 0;  ///< the same with x and y exchanged.
    Length ceiling = 0;
    Length key = kNone;            ///< least estimate when open, else kNone.
    std::uint32_t generation = 0;  ///< of the search that wrote it.
    std::int16_t x = 0;            ///< its first cell.
    std::int16_t y = 0;
  };

  struct Edge;

  /// @param[in] cell of the map or beside it.
  std::size_t IndexOfBlock(const Cell& cell) const {
    return static_cast<std::size_t>((cell.y + 8) / 8) * stride_ +
           (cell.x + 8) / 8;
  }
  bool IsOpen(const Cell& cell, int direction) const;
  bool IsFree(const Cell& cell) const;
  Length Heuristic(const Cell& cell) const;
  /// The length to a cell; nothing (kNone) when no way has been found.
  Length LengthTo(const Cell& cell) const;

  void Enter(Block& block, Length length);
  void Expand(Block& block);
  void PushEdge(const Block& from, Block& to, const Edge& edge, Lanes& lengths);
  void PushCorner(const Block& from, int direction);
  void PushCell(const Block& from, Block& to, const Cell& cell, int below);
  void Open(Block& block, Length estimate);
  void Drop(Length estimate) {
    dropped_estimate_ = std::min(dropped_estimate_, estimate);
  }
  void DropShort(const Block& block);
  void LowerCeiling(Block& block, int by);
  /// Over the cells whose lanes are set in `is_wanted`, one at least.
  Length LeastEstimate(const Block& block, const Edge& edge, Lanes lengths,
                       Lanes is_wanted) const;
  void TracePath(const Cell& start, JumpPointResult& result) const;

  std::ptrdiff_t stride_;  ///< blocks in a row, with a border of blocked ones.
  std::vector<Block> blocks_;
  BucketQueue<Block*> open_;
  std::uint32_t generation_ = 0;
  // Of the present search:
  Cell goal_;
  Length goal_length_ = 0;
  Length dropped_estimate_ = kNone;
};

inline BlockSearch::Length BlockSearch::Heuristic(const Cell& cell) const {
  const Length dx = std::abs(cell.x - goal_.x);
  const Length dy = std::abs(cell.y - goal_.y);
  return kBlockStraight * std::max(dx, dy) +
         (kBlockDiagonal - kBlockStraight) * std::min(dx, dy);
}

inline void BlockSearch::Enter(Block& block, Length length) {
  block.rows = {};
  block.west = AllLanes(0);
  block.east = AllLanes(0);
  block.ceiling = length + kFirst;
  block.key = kNone;
  block.generation = generation_;
}

inline void BlockSearch::Open(Block& block, Length estimate) {
  if (estimate >= goal_length_ || estimate >= block.key) return;
  block.key = estimate;
  open_.Push(estimate, &block);
}

}  // namespace vfh_astar

#endif  // VFH_ASTAR_PLANNING_BLOCK_SEARCH_H_
