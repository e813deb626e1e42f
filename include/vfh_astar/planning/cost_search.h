#ifndef VFH_ASTAR_PLANNING_COST_SEARCH_H_
#define VFH_ASTAR_PLANNING_COST_SEARCH_H_

#include <atomic>
#include <optional>
#include <utility>

#include "vfh_astar/planning/cost_block_search.h"
#include "vfh_astar/planning/cost_map.h"
#include "vfh_astar/planning/grid_search.h"
#include "vfh_astar/planning/passage_check.h"
#include "vfh_astar/planning/search_result.h"

namespace vfh_astar {

/// Least-cost paths over a cost map: from CostBlockSearch where it tells, which
/// is nearly always, else from GridSearch.
class CostSearch {
 public:
  /// As that of GridSearch.
  SearchResult Run(const CostMap& costs, const PassageCheck& passages,
                   const Cell& start, const Cell& goal,
                   const std::atomic<bool>* cancelled) {
    if (by_block_.is_supported()) {
      std::optional<SearchResult> result =
          by_block_.Run(costs, passages, start, goal, cancelled);
      if (result) return std::move(*result);
    }
    return by_cell_.Run(costs, passages, start, goal, cancelled);
  }

  /// After kExhausted: true for the cells that can be reached from the start.
  bool IsReached(const Cell& cell) const { return by_cell_.IsReached(cell); }

 private:
  CostBlockSearch by_block_;
  GridSearch by_cell_;
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_PLANNING_COST_SEARCH_H_
