#ifndef VFH_ASTAR_PLANNING_UNIFORM_SEARCH_H_
#define VFH_ASTAR_PLANNING_UNIFORM_SEARCH_H_

#include "vfh_astar/planning/block_search.h"
#include "vfh_astar/planning/jump_point_search.h"

namespace vfh_astar {

/// Shortest paths over cells that are blocked or free, by the search that is
/// likely to be the quicker one between start and goal: JumpPointSearch in the
/// open and between walls, BlockSearch among scattered obstacles. Both find
/// the same length.
class UniformSearch {
 public:
  /// A map of free cells.
  UniformSearch(int width, int height)
      : jumping_(width, height), by_block_(width, height) {}

  void SetBlocked(const Cell& cell, bool is_blocked) {
    jumping_.SetBlocked(cell, is_blocked);
    by_block_.SetBlocked(cell, is_blocked);
  }
  bool IsBlocked(const Cell& cell) const { return jumping_.IsBlocked(cell); }

  /// @param[in] start, goal free cells of the map.
  JumpPointResult Run(const Cell& start, const Cell& goal) {
    if (IsScattered(start, goal)) {
      JumpPointResult result = by_block_.Run(start, goal);
      if (by_block_.is_decided()) return result;
    }
    return jumping_.Run(start, goal);
  }

  /// True when single blocked cells are many on the straight line.
  bool IsScattered(const Cell& start, const Cell& goal) const;

 private:
  bool StandsAlone(const Cell& cell) const;

  JumpPointSearch jumping_;
  BlockSearch by_block_;
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_PLANNING_UNIFORM_SEARCH_H_
