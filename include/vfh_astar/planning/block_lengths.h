#ifndef VFH_ASTAR_PLANNING_BLOCK_LENGTHS_H_
#define VFH_ASTAR_PLANNING_BLOCK_LENGTHS_H_

#include <array>
#include <cstdint>

#include "vfh_astar/planning/lanes.h"

namespace vfh_astar {

/// Lengths of ways to the cells of a square block, as what they fall short of a
/// ceiling: the greater, the shorter; 0 where no way leads. Blocked cells have
/// 0. What is longer than the ceiling is dropped.

inline constexpr int kBlockSide = kLanes;  ///< cells.

// 577 / 408 is the root of 2 to 2e-6.
inline constexpr std::int16_t kBlockStraight = 408;
inline constexpr std::int16_t kBlockDiagonal = 577;

/// All bits in the lanes whose cells are free.
/// @param[in] free a bit per cell, a byte per row.
Lanes MaskOfRow(std::uint64_t free, int row);

/// What the lengths of a row give to those of the row beside it. May be less
/// than 0 where it is not a length.
/// @param[in] straight where both rows are free, as a mask.
/// @param[in] up, down where a diagonal step to the higher or lower lane ends.
inline Lanes RowOffer(Lanes row, Lanes straight, Lanes up, Lanes down) {
  const Lanes diagonal = Greater(ShiftedUp(row) & up, ShiftedDown(row) & down);
  return Greater((row - kBlockStraight) & straight, diagonal - kBlockDiagonal);
}

/// Steps within the block till no length becomes less.
/// @param[in] free_rows, free_columns the free cells, a bit per cell, a byte
/// per
///   row or per column.
/// @param[out] rows lengths, a row per element.
/// @param[in,out] columns the same with x and y exchanged.
void RelaxBlock(std::uint64_t free_rows, std::uint64_t free_columns,
                LaneSquare& rows, LaneSquare& columns);

}  // namespace vfh_astar

#endif  // VFH_ASTAR_PLANNING_BLOCK_LENGTHS_H_
