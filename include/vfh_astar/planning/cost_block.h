#ifndef VFH_ASTAR_PLANNING_COST_BLOCK_H_
#define VFH_ASTAR_PLANNING_COST_BLOCK_H_

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>

#include "vfh_astar/grid/grid.h"
#include "vfh_astar/planning/cost_map.h"

namespace vfh_astar {

/// The least costs found so far of ways to 8 x 8 cells.
struct CostBlock {
  static constexpr int kSide = CostMap::kBlockSide;  ///< cells.
  using Line = StepCost[kSide];

  /// No way has been found. Twice this and a step still fit into the type.
  static constexpr StepCost kUnreached = StepCost{1} << 30;

  Line rows[kSide];
  Line west;  ///< column 0 and
  Line east;  ///< the last one, with what has come from the blocks beside since
              ///< `rows` was brought up to date.
  /// The least estimate of what is new, if anything is, else kUnreached.
  StepCost key;
  std::uint32_t generation;  ///< of the search that wrote it.

  void Clear(std::uint32_t generation_now) {
    std::fill(&rows[0][0], std::end(east), kUnreached);
    key = kUnreached;
    generation = generation_now;
  }
};

/// Where a block lies.
struct CostBlockPlace {
  std::ptrdiff_t blocks_per_row;  ///< from a block in memory to its north.
  const CostMap::Level* levels;   ///< of its first cell,
  std::ptrdiff_t stride;          ///< from there to the next row.
  Cell goal;                      ///< of the search, from its first cell.
};

enum CostBlockSide { kSouth, kNorth, kWest, kEast };

/// By side, the least cost from start to goal that the heuristic allows through
/// what has become cheaper in the block beside; kUnreached when nothing has.
using CostBlockNews = std::array<StepCost, 4>;

/// Brings the costs within a block up to date with what has come to it, and
/// those of the four blocks beside it, as far as one step leads into them. Does
/// not step through its corners.
/// @param[in,out] block in an array; the blocks beside it that have not its
///   generation yet are cleared when a way leads into them.
using ExpandCostBlock = CostBlockNews (*)(CostBlock& block,
                                          const CostBlockPlace& place);

/// Null when this processor does not have what it takes (AVX2).
ExpandCostBlock FindCostBlockExpansion();

}  // namespace vfh_astar

#endif  // VFH_ASTAR_PLANNING_COST_BLOCK_H_
