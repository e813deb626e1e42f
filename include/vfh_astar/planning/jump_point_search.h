#ifndef VFH_ASTAR_PLANNING_JUMP_POINT_SEARCH_H_
#define VFH_ASTAR_PLANNING_JUMP_POINT_SEARCH_H_

#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <vector>

#include "vfh_astar/grid/grid.h"
#include "vfh_astar/planning/bit_grid.h"
#include "vfh_astar/planning/bucket_queue.h"

namespace vfh_astar {

struct JumpPointResult {
  bool is_found = false;
  std::vector<Cell> cells;  ///< start to goal, neighbour by neighbour.
  double length = 0.0;      ///< cells; a diagonal step is the root of 2.
  std::int64_t nodes_expanded = 0;
};

/// Shortest paths over cells that are blocked or free: eight directions, no
/// corner cut. Nothing is worked out beforehand, so cells may change at any
/// time; a search costs by what it scans, whatever the size of the map.
///
/// Harabor and Grastien, "Online Graph Pruning for Pathfinding on Grid Maps"
/// (2011), in the variant without corner cutting; scanned 64 cells at a time,
/// and with diagonal jump points passed over, after "Improving Jump Point
/// Search" (2014) by the same.
class JumpPointSearch {
 public:
  /// A map of free cells.
  JumpPointSearch(int width, int height);

  void SetBlocked(const Cell& cell, bool is_blocked);
  bool IsBlocked(const Cell& cell) const {
    return rows_.Test(cell.x + 1, cell.y + 1);
  }

  /// @param[in] start, goal free cells of the map.
  JumpPointResult Run(const Cell& start, const Cell& goal);

 private:
  using Length = std::uint32_t;

  struct Node {
    std::uint32_t generation;  ///< of the search that wrote it.
    Length length;             ///< from the start, as far as known.
    std::uint32_t parent;      ///< index of the jump point before.
    std::uint8_t arrivals;     ///< directions of the last step, as bits.
  };
  struct Open {
    std::uint16_t x;
    std::uint16_t y;
    std::uint32_t direction;
    Length length;
  };
  struct Free {
    void operator()(Node* nodes) const { std::free(nodes); }
  };

  std::uint32_t Index(int x, int y) const {
    return static_cast<std::uint32_t>(y) * stride_ + x;
  }
  Length Heuristic(int x, int y) const;
  unsigned Successors(const Open& open) const;
  void JumpStraight(const Open& from, int x, int y, int direction,
                    Length length);
  void JumpDiagonally(const Open& from, int direction);
  void Reach(const Open& from, int x, int y, int direction, Length length);
  std::vector<Cell> PathToGoal(const Cell& start) const;

  int stride_;  ///< columns with the border.
  BitGrid rows_;
  BitGrid columns_;  ///< the same with x and y exchanged.
  std::unique_ptr<Node[], Free> nodes_;
  std::uint32_t generation_ = 0;
  BucketQueue<Open> open_;
  // Of the present search, with the border:
  Cell goal_;
  Length goal_length_ = 0;
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_PLANNING_JUMP_POINT_SEARCH_H_
