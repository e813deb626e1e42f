#ifndef VFH_ASTAR_PLANNING_CANONICAL_SEARCH_H_
#define VFH_ASTAR_PLANNING_CANONICAL_SEARCH_H_

#include <cstdint>
#include <vector>

#include "vfh_astar/grid/grid.h"
#include "vfh_astar/planning/bucket_queue.h"
#include "vfh_astar/planning/jump_point_search.h"

namespace vfh_astar {

/// Finds what JumpPointSearch finds, cell by cell: quicker where obstacles lie
/// so densely that jumps are short, slower in the open.
///
/// A* that takes from a cell only the steps that may be part of a shortest path
/// by the direction of its arrival and the blocked cells around it (Sturtevant
/// and Rabin, "Canonical Orderings on Grids", 2016). Cells leave the queue in
/// the exact order of their estimates, so each is looked at once, and nothing
/// is kept of it but the direction. Blocked cells may change at any time.
class CanonicalSearch {
 public:
  /// A map of free cells.
  CanonicalSearch(int width, int height);

  void SetBlocked(const Cell& cell, bool is_blocked);

  /// @param[in] start, goal free cells of the map.
  JumpPointResult Run(const Cell& start, const Cell& goal);

 private:
  /// The search that closed the cell (20 bits, later ones are greater, blocked
  /// cells have the greatest), the direction of the step that led here (4
  /// bits), which neighbours are blocked (8 bits).
  using Node = std::uint32_t;
  struct Open {
    std::uint16_t x;
    std::uint16_t y;
    std::uint32_t direction;
  };

  std::size_t Index(int x, int y) const {
    return static_cast<std::size_t>(y) * stride_ + x;
  }
  std::uint32_t Heuristic(int x, int y) const;
  void StartGeneration();
  JumpPointResult PathTo(const Cell& start) const;

  int stride_;  ///< columns with a border of blocked cells.
  std::vector<Node> nodes_;
  Node generation_ = 0;
  BucketQueue<Open> open_;
  Cell goal_;  ///< of the present search, with the border.
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_PLANNING_CANONICAL_SEARCH_H_
