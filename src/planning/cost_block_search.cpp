#include "vfh_astar/planning/cost_block_search.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <new>
#include <utility>

namespace vfh_astar {
namespace {

constexpr int kSide = CostBlock::kSide;
constexpr StepCost kUnreached = CostBlock::kUnreached;

// About a free step per bucket: wider ones let blocks go ahead of cheaper ways
// and be looked at again, narrower ones gain nothing more.
constexpr int kBucketBits = 11;

// Estimates that exceed the least one by more wait in the last bucket.
constexpr StepCost kSpan = 256 * kFreeStep;

}  // namespace

CostBlockSearch::CostBlockSearch()
    : expand_(FindCostBlockExpansion()), open_(kBucketBits, kSpan) {}

void CostBlockSearch::Prepare(const CostMap& costs) {
  constexpr auto kLastGeneration = std::numeric_limits<std::uint32_t>::max();
  if (!memory_ || generation_ == kLastGeneration ||
      geometry_.width != costs.geometry().width ||
      geometry_.height != costs.geometry().height) {
    blocks_per_row_ = costs.stride() / kSide;
    // With blocks around those of the map, whose neighbours they are.
    const std::size_t count = blocks_per_row_ * (costs.rows() / kSide + 2) + 2;
    // Zeroed pages come from the system when they are first written, so a
    // large map costs no more than the part of it that is searched.
    memory_.reset(
        static_cast<CostBlock*>(std::calloc(count, sizeof(CostBlock))));
    if (!memory_) throw std::bad_alloc();
    blocks_ = memory_.get() + blocks_per_row_ + 1;
    generation_ = 0;
  }
  geometry_ = costs.geometry();
  ++generation_;
}

inline CostBlock& CostBlockSearch::BlockOf(const Cell& cell) const {
  // Without a sign, to divide is to shift.
  const auto x = static_cast<unsigned>(cell.x + 1);
  const auto y = static_cast<unsigned>(cell.y + 1);
  return blocks_[y / kSide * blocks_per_row_ + x / kSide];
}

inline StepCost CostBlockSearch::CostTo(const Cell& cell) const {
  const CostBlock& block = BlockOf(cell);
  if (block.generation != generation_) return kUnreached;
  return block.rows[(cell.y + 1) % kSide][(cell.x + 1) % kSide];
}

inline void CostBlockSearch::Open(CostBlock& block, StepCost estimate) {
  if (estimate >= goal_cost_ || estimate >= block.key) return;
  block.key = estimate;
  open_.Push(std::min(estimate, open_.GreatestKey()), &block);
}

inline void CostBlockSearch::PushCorner(const CostBlock& block,
                                        const CostMap& costs,
                                        const Cell& corner, int direction) {
  const Cell step = kSteps[direction];
  const int x = step.x > 0 ? kSide - 1 : 0;
  const int y = step.y > 0 ? kSide - 1 : 0;
  const StepCost cost = block.rows[y][x];
  if (cost == kUnreached || !costs.IsOpen(corner, direction)) return;
  const Cell cell{corner.x + step.x, corner.y + step.y};
  CostBlock& to = BlockOf(cell);
  if (to.generation != generation_) to.Clear(generation_);
  const StepCost sum = cost + CostOfStep(costs[corner], costs[cell], direction);
  StepCost& known = to.rows[kSide - 1 - y][kSide - 1 - x];
  if (sum >= known) return;
  known = sum;
  Open(to, sum + FreeCost(cell, goal_));
}

void CostBlockSearch::Expand(CostBlock& block, const CostMap& costs) {
  const std::ptrdiff_t index = &block - blocks_;
  const int x = static_cast<int>(index % blocks_per_row_) * kSide - 1;
  const int y = static_cast<int>(index / blocks_per_row_) * kSide - 1;
  const CostBlockNews news =
      expand_(block, {blocks_per_row_,
                      &costs.levels()[costs.Index({x, y})],
                      costs.stride(),
                      {goal_.x - x, goal_.y - y}});
  const auto open_beside = [&](CostBlockSide side, std::ptrdiff_t offset) {
    if (news[side] != kUnreached) Open((&block)[offset], news[side]);
  };
  open_beside(kSouth, -blocks_per_row_);
  open_beside(kNorth, blocks_per_row_);
  open_beside(kWest, -1);
  open_beside(kEast, 1);
  constexpr int kLast = kSide - 1;
  PushCorner(block, costs, {x + kLast, y + kLast}, 1);
  PushCorner(block, costs, {x, y + kLast}, 3);
  PushCorner(block, costs, {x, y}, 5);
  PushCorner(block, costs, {x + kLast, y}, 7);
}

std::optional<SearchResult> CostBlockSearch::Run(
    const CostMap& costs, const PassageCheck& passages, const Cell& start,
    const Cell& goal, const std::atomic<bool>* cancelled) {
  assert(is_supported());
  assert(costs.geometry().Contains(start) && costs.geometry().Contains(goal));
  assert(!costs.IsLethal(start));
  Prepare(costs);
  goal_ = goal;
  goal_cost_ = kUnreached;
  tight_level_ = passages.TightLevel(costs);
  const StepCost first_key = FreeCost(start, goal);
  open_.Restart(first_key);
  CostBlock& first = BlockOf(start);
  first.Clear(generation_);
  first.rows[(start.y + 1) % kSide][(start.x + 1) % kSide] = 0;
  Open(first, first_key);

  const CostBlock& last = BlockOf(goal);
  SearchResult result;
  while (!open_.empty() && open_.LeastKey() < goal_cost_) {
    CostBlock& block = *open_.Pop();
    // Opened twice and done already, or too far.
    if (block.key >= goal_cost_) continue;
    block.key = kUnreached;
    if (cancelled && *cancelled) {
      result.status = SearchStatus::kCancelled;
      return result;
    }
    ++result.nodes_expanded;
    Expand(block, costs);
    if (&block == &last) goal_cost_ = std::min(goal_cost_, CostTo(goal));
  }
  if (goal_cost_ == kUnreached) return std::nullopt;
  std::optional<std::vector<Cell>> cells = Trace(costs, passages, start);
  if (!cells) return std::nullopt;
  result.status = SearchStatus::kFound;
  result.cells = std::move(*cells);
  result.cost = goal_cost_;
  return result;
}

std::optional<int> CostBlockSearch::StepTo(const Cell& cell, StepCost cost,
                                           int preferred, const CostMap& costs,
                                           const PassageCheck& passages) const {
  const bool is_tight = costs[cell] >= tight_level_;
  for (const int turn : kTurns) {
    const int direction = (preferred + turn) % kDirections;
    const Cell& step = kSteps[direction];
    const Cell from{cell.x - step.x, cell.y - step.y};
    if (costs.IsLethal(from) || !costs.IsOpen(from, direction)) continue;
    const StepCost sum =
        CostTo(from) + CostOfStep(costs[from], costs[cell], direction);
    if (sum != cost) continue;
    if (!is_tight || passages.Fits(cell, direction)) return direction;
  }
  return std::nullopt;
}

std::optional<std::vector<Cell>> CostBlockSearch::Trace(
    const CostMap& costs, const PassageCheck& passages,
    const Cell& start) const {
  std::vector<Cell> cells = {goal_};
  int direction = 0;
  while (cells.back() != start) {
    const Cell& cell = cells.back();
    const std::optional<int> step =
        StepTo(cell, CostTo(cell), direction, costs, passages);
    if (!step) return std::nullopt;
    direction = *step;
    cells.push_back(
        {cell.x - kSteps[direction].x, cell.y - kSteps[direction].y});
  }
  std::reverse(cells.begin(), cells.end());
  return cells;
}

}  // namespace vfh_astar
