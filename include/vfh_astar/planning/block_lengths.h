#ifndef VFH_ASTAR_PLANNING_BLOCK_LENGTHS_H_
#define VFH_ASTAR_PLANNING_BLOCK_LENGTHS_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "vfh_astar/grid/grid.h"
#include "vfh_astar/planning/lanes.h"

namespace vfh_astar {

/// Of a way, in units of a straight step's 408th part.
using BlockLength = std::uint32_t;
inline constexpr BlockLength kNoLength =
    std::numeric_limits<BlockLength>::max();

inline constexpr int kBlockSide = kLanes;  ///< cells.

// 577 / 408 is the root of 2 to 2e-6.
inline constexpr std::int16_t kBlockStraight = 408;
inline constexpr std::int16_t kBlockDiagonal = 577;

/// How far below the ceiling lengths may be.
inline constexpr std::int16_t kMostBelow =
    std::numeric_limits<std::int16_t>::max();
/// What is nearer to it may have lost its next step to the end of the range.
inline constexpr std::int16_t kLeastBelow = kBlockDiagonal + 1;

/// Where the first length in a block is put: what comes later may be shorter by
/// ten cells.
inline constexpr int kFirstBelow = kMostBelow - 10 * kBlockStraight;

/// The lengths of ways to 8 x 8 cells, kept as what they fall short of a
/// ceiling: the greater, the shorter; 0 where no way leads and in blocked
/// cells. What is longer than the ceiling is dropped.
struct LengthBlock {
  /// Row y and row 7 - y side by side, the outermost ones first: what goes from
  /// row to row does so upward and downward at once.
  alignas(32) std::array<Lanes, kBlockSide> folded_rows{};
  /// The outermost ones, with what has come from the blocks to the west and
  /// east since the rows were brought up to date.
  alignas(32) std::array<Lanes, 2> columns{};
  BlockLength ceiling = 0;
  BlockLength key = kNoLength;   ///< least estimate when open, else kNoLength.
  std::uint32_t generation = 0;  ///< of the search that wrote it.
  std::int16_t x = 0;            ///< its first cell.
  std::int16_t y = 0;
  std::uint64_t free_rows = 0;     ///< a bit per cell, a byte per row.
  std::uint64_t free_columns = 0;  ///< the same with x and y exchanged.
  /// A bit per corner, set where a diagonal step leads through it: south-west,
  /// south-east, north-west, north-east.
  std::uint32_t open_corners = 0;

  Lanes& row(int y) { return folded_rows[PlaceOfRow(y)]; }
  const Lanes& row(int y) const { return folded_rows[PlaceOfRow(y)]; }
  /// Forgets what an earlier search wrote.
  /// @param[in] length of the first way into it.
  void Enter(BlockLength length, std::uint32_t generation_now) {
    folded_rows.fill(AllLanes(0));
    columns.fill(AllLanes(0));
    ceiling = length + kFirstBelow;
    key = kNoLength;
    generation = generation_now;
  }

 private:
  static int PlaceOfRow(int y) {
    return y < kBlockSide / 2 ? 2 * y : 2 * (kBlockSide - 1 - y) + 1;
  }
};

inline constexpr int kBlockEdges = 4;  ///< south, north, west, east.

/// @param[in] block in an array of rows of `stride` blocks.
inline std::array<LengthBlock*, kBlockEdges> BlocksBeside(
    LengthBlock& block, std::ptrdiff_t stride) {
  return {&block - stride, &block + stride, &block - 1, &block + 1};
}

/// By edge, what steps from its cells lead to in those of the block beside.
struct EdgeOffers {
  alignas(32) std::array<Lanes, kBlockEdges> lanes;
};

/// What estimates are made of and held against.
struct EstimateFrame {
  Cell goal;          ///< from the block's first cell.
  BlockLength least;  ///< no estimate is less, nor more by 2^16 - 1 or more.
  BlockLength limit;  ///< nothing opens a block whose estimate is not less.
  std::uint32_t generation;  ///< of the search.
};

struct EdgeNews {
  /// False when some lengths do not fit into the block beside. Then nothing has
  /// been done.
  bool fits;
  unsigned is_opened;  ///< a bit per edge: the block beside gets a lower key,
  std::array<BlockLength, kBlockEdges> keys;  ///< this one.
};

struct BlockNews {
  EdgeNews edges;
  /// A bit per corner, in the order of LengthBlock: a diagonal step through it
  /// makes a length less. Nothing has been done about it.
  unsigned corners;
  /// Whether a length in the block is less than kLeastBelow below its ceiling.
  bool is_short;
};

/// What is done with all cells of a block or of its edges at once, for one kind
/// of processor.
struct BlockKernel {
  /// Steps within the block till no length becomes less, and as `push` into the
  /// blocks beside, which become part of the search when something is offered
  /// to them.
  /// @param[in] block in an array of rows of `stride` blocks.
  /// @param[out] offers to the blocks beside.
  BlockNews (*expand)(LengthBlock& block, std::ptrdiff_t stride,
                      const EstimateFrame& frame, EdgeOffers& offers);
  /// Shortens what the offers shorten in the blocks beside; one that nothing is
  /// offered to is left alone.
  EdgeNews (*push)(LengthBlock& block, std::ptrdiff_t stride,
                   const EdgeOffers& offers, const EstimateFrame& frame);
};

/// For any processor.
const BlockKernel& BaselineBlockKernel();
/// Null when this processor (or compiler) does not have AVX2.
const BlockKernel* Avx2BlockKernel();
/// The faster one of those that can be used.
const BlockKernel& FastestBlockKernel();

}  // namespace vfh_astar

#endif  // VFH_ASTAR_PLANNING_BLOCK_LENGTHS_H_
