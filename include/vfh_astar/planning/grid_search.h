#ifndef VFH_ASTAR_PLANNING_GRID_SEARCH_H_
#define VFH_ASTAR_PLANNING_GRID_SEARCH_H_

#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <vector>

#include "vfh_astar/planning/bucket_queue.h"
#include "vfh_astar/planning/cost_map.h"
#include "vfh_astar/planning/passage_check.h"
#include "vfh_astar/planning/search_result.h"

namespace vfh_astar {

/// A* over a cost map: eight directions, no corner cut, octile heuristic. The
/// path it finds has the least cost there is.
///
/// Its memory is eight bytes per cell of the map, taken from the system as the
/// search first reaches them and kept. A search costs by the cells it looks at,
/// whatever the size of the map.
class GridSearch {
 public:
  GridSearch();

  /// @param[in] start, goal within the map; the start is not lethal.
  /// @param[in] passages tested for steps to cells of its TightLevel or more.
  /// @param[in] cancelled polled; may be null.
  SearchResult Run(const CostMap& costs, const PassageCheck& passages,
                   const Cell& start, const Cell& goal,
                   const std::atomic<bool>* cancelled);

  /// True when the last search came to this cell. After kExhausted these are
  /// all the cells that can be reached from its start.
  bool IsReached(const Cell& cell) const;

 private:
  /// In one word, so that one comparison tells whether a way is news: the
  /// search that wrote it (24 bits, later ones are greater), the cost's
  /// complement (32 bits, cheaper ones are greater), the direction of the step
  /// that led here (8 bits). Zero is a node that no search has come to.
  using Node = std::uint64_t;
  struct Open {
    std::uint16_t x;
    std::uint16_t y;
    StepCost cost;  ///< out of date when its node's is less.
  };
  struct Free {
    void operator()(Node* nodes) const { std::free(nodes); }
  };

  Node MakeNode(StepCost cost, int direction) const {
    return generation_ << 40 | Node{~cost} << 8 | static_cast<Node>(direction);
  }
  static StepCost CostOf(Node node) {
    return ~static_cast<StepCost>(node >> 8);
  }

  /// A node whose neighbours are being looked at.
  struct Expansion {
    Cell cell;
    StepCost cost;
    CostMap::Level level;
    const CostMap::Level* levels;  ///< at the node.
    Node* nodes;                   ///< at the node.
    std::ptrdiff_t stride;
    Node stamp;       ///< of the present search.
    unsigned behind;  ///< directions, as bits.
    int tight_level;
    const PassageCheck& passages;
  };

  void Prepare(const CostMap& costs);
  /// @param[in] index of its cell in the cost map.
  void Expand(const Open& open, std::size_t index, const CostMap& costs,
              const PassageCheck& passages);
  template <int kDirection>
  void Look(const Expansion& from);
  std::vector<Cell> PathToGoal(const Cell& start, const CostMap& costs) const;

  GridGeometry geometry_;
  int stride_ = 0;
  std::unique_ptr<Node[], Free> nodes_;
  std::uint64_t generation_ = 0;
  BucketQueue<Open> open_;
  // Of the present search:
  Cell goal_;
  StepCost goal_cost_ = 0;
  int tight_level_ = 0;
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_PLANNING_GRID_SEARCH_H_
