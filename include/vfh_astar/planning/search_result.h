#ifndef VFH_ASTAR_PLANNING_SEARCH_RESULT_H_
#define VFH_ASTAR_PLANNING_SEARCH_RESULT_H_

#include <cstdint>
#include <vector>

#include "vfh_astar/grid/grid.h"
#include "vfh_astar/planning/cost_map.h"

namespace vfh_astar {

enum class SearchStatus { kFound, kExhausted, kCancelled };

struct SearchResult {
  SearchStatus status = SearchStatus::kExhausted;
  std::vector<Cell> cells;  ///< start to goal; empty unless found.
  StepCost cost = 0;
  std::int64_t nodes_expanded = 0;  ///< cells, or blocks of them.
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_PLANNING_SEARCH_RESULT_H_
