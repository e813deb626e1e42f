#ifndef VFH_ASTAR_PLANNING_BLOCK_LENGTHS_H_
#define VFH_ASTAR_PLANNING_BLOCK_LENGTHS_H_

#include <cstdint>
#include <limits>

#include "vfh_astar/planning/lanes.h"

namespace vfh_astar {

// Lengths of ways to the cells of a square block are kept as what they fall
// short of a ceiling: the greater, the shorter; 0 where no way leads. Blocked
// cells have 0. What is longer than the ceiling is dropped.

inline constexpr int kBlockSide = kLanes;  ///< cells.

// 577 / 408 is the root of 2 to 2e-6.
inline constexpr std::int16_t kBlockStraight = 408;
inline constexpr std::int16_t kBlockDiagonal = 577;

/// No length is greater.
inline constexpr std::int16_t kWall = std::numeric_limits<std::int16_t>::max();

/// kWall in the lanes whose cells are blocked, else 0.
/// @param[in] free a bit per cell, a byte per row.
inline Lanes WallsOfRow(std::uint64_t free, int row) {
  const auto byte = static_cast<std::int16_t>(free >> (8 * row) & 0xff);
  return ((Lanes{1, 2, 4, 8, 16, 32, 64, 128} & byte) == 0) & kWall;
}

/// What steps from a row to the one beside it, or back, cost; kWall where there
/// is none.
struct RowPassage {
  Lanes straight;
  Lanes diagonal;  ///< between a lane and the lower one beside it.
};

/// @param[in] walls, next of the two rows, as WallsOfRow gives them.
inline RowPassage PassageBetween(Lanes walls, Lanes next) {
  const Lanes straight = walls | next;
  // A diagonal step needs all four cells, whichever way it goes.
  const Lanes diagonal = straight | ShiftedUp(straight);
  return {straight | kBlockStraight, diagonal | kBlockDiagonal};
}

/// What the lengths of a row give to those of the row beside it.
inline Lanes RowOffer(Lanes row, const RowPassage& passage) {
  const Lanes diagonal = Greater(LessBy(ShiftedUp(row), passage.diagonal),
                                 ShiftedDown(LessBy(row, passage.diagonal)));
  return Greater(LessBy(row, passage.straight), diagonal);
}

/// Steps within the block till no length becomes less.
/// @param[in] free_rows, free_columns the free cells, a bit per cell, a byte
///   per row or per column.
/// @param[out] rows lengths, a row per element.
/// @param[in,out] columns the same with x and y exchanged.
void RelaxBlock(std::uint64_t free_rows, std::uint64_t free_columns,
                LaneSquare& rows, LaneSquare& columns);

}  // namespace vfh_astar

#endif  // VFH_ASTAR_PLANNING_BLOCK_LENGTHS_H_
