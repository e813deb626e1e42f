#ifndef VFH_ASTAR_PLANNING_UNIFORM_SEARCH_H_
#define VFH_ASTAR_PLANNING_UNIFORM_SEARCH_H_

#include "vfh_astar/planning/canonical_search.h"
#include "vfh_astar/planning/jump_point_search.h"

namespace vfh_astar {

/// Shortest paths over cells that are blocked or free, by the search that is
/// likely to be the quicker one between start and goal: JumpPointSearch in the
/// open and between walls, CanonicalSearch among scattered obstacles. Both find
/// the same length.
class UniformSearch {
 public:
  /// A map of free cells.
  UniformSearch(int width, int height)
      : jumping_(width, height), stepping_(width, height) {}

  void SetBlocked(const Cell& cell, bool is_blocked) {
    jumping_.SetBlocked(cell, is_blocked);
    stepping_.SetBlocked(cell, is_blocked);
  }
  bool IsBlocked(const Cell& cell) const { return jumping_.IsBlocked(cell); }

  /// @param[in] start, goal free cells of the map.
  JumpPointResult Run(const Cell& start, const Cell& goal) {
    return IsScattered(start, goal) ? stepping_.Run(start, goal)
                                    : jumping_.Run(start, goal);
  }

  /// True when single blocked cells are many on the straight line.
  bool IsScattered(const Cell& start, const Cell& goal) const;

 private:
  bool StandsAlone(const Cell& cell) const;

  JumpPointSearch jumping_;
  CanonicalSearch stepping_;
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_PLANNING_UNIFORM_SEARCH_H_
