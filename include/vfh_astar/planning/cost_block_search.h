#ifndef VFH_ASTAR_PLANNING_COST_BLOCK_SEARCH_H_
#define VFH_ASTAR_PLANNING_COST_BLOCK_SEARCH_H_

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <optional>
#include <vector>

#include "vfh_astar/planning/bucket_queue.h"
#include "vfh_astar/planning/cost_block.h"
#include "vfh_astar/planning/cost_map.h"
#include "vfh_astar/planning/passage_check.h"
#include "vfh_astar/planning/search_result.h"

namespace vfh_astar {

/// Finds what GridSearch finds several times faster, or does not tell.
///
/// A* whose open nodes are blocks of 8 x 8 cells, as BlockSearch is, over a
/// cost map. It takes for granted that the robot's rectangle fits at every
/// step, and asks only along the path it has found: among steps of equal cost
/// it takes one at which the rectangle fits. Where there is none, another path
/// may be the best one, and the question is left open.
///
/// Its memory is five bytes per cell of the map, taken from the system as the
/// search first reaches them and kept. A search costs by the cells it looks at,
/// whatever the size of the map.
class CostBlockSearch {
 public:
  CostBlockSearch();

  /// False when this processor does not have what it takes.
  bool is_supported() const { return expand_ != nullptr; }

  /// As that of GridSearch; only where is_supported().
  /// @return kFound or kCancelled, its nodes are blocks; nothing when it has
  ///   found no path along which the rectangle fits, or none that costs less
  ///   than CostBlock::kUnreached.
  std::optional<SearchResult> Run(const CostMap& costs,
                                  const PassageCheck& passages,
                                  const Cell& start, const Cell& goal,
                                  const std::atomic<bool>* cancelled);

 private:
  struct Free {
    void operator()(CostBlock* blocks) const { std::free(blocks); }
  };

  void Prepare(const CostMap& costs);
  /// @param[in] cell within the map or on its border.
  CostBlock& BlockOf(const Cell& cell) const;
  StepCost CostTo(const Cell& cell) const;
  void Open(CostBlock& block, StepCost estimate);
  void Expand(CostBlock& block, const CostMap& costs);
  void PushCorner(const CostBlock& block, const CostMap& costs,
                  const Cell& corner, int direction);
  /// The step from the path's first cell to the one before it, as the direction
  /// from that one; nothing when there is none at which the rectangle fits.
  /// @param[in] cost of the way to `cell`.
  /// @param[in] preferred among equal ones.
  std::optional<int> StepTo(const Cell& cell, StepCost cost, int preferred,
                            const CostMap& costs,
                            const PassageCheck& passages) const;
  /// @return nothing when there is a step at which the rectangle does not fit.
  std::optional<std::vector<Cell>> Trace(const CostMap& costs,
                                         const PassageCheck& passages,
                                         const Cell& start) const;

  ExpandCostBlock expand_;
  GridGeometry geometry_;
  std::ptrdiff_t blocks_per_row_ = 0;
  std::unique_ptr<CostBlock, Free> memory_;
  CostBlock* blocks_ = nullptr;  ///< the map's; more of them lie around it.
  std::uint32_t generation_ = 0;
  BucketQueue<CostBlock*> open_;
  // Of the present search:
  Cell goal_;
  StepCost goal_cost_ = 0;
  int tight_level_ = 0;
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_PLANNING_COST_BLOCK_SEARCH_H_
