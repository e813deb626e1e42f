#include "vfh_astar/planning/grid_search.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstring>
#include <limits>
#include <new>

namespace vfh_astar {
namespace {

constexpr StepCost kUnreached = std::numeric_limits<StepCost>::max();

// The most that one step adds to the cost and to the heuristic together.
constexpr StepCost kLongestStep =
    2 * CostMap::kMaxLevel * kDiagonal + kFreeDiagonal;

// Costs beyond this would run over; at 0.05 m per cell it is a hundred
// kilometres of free path.
constexpr StepCost kFarthest = kUnreached / 2 - kLongestStep;

// A ninth of a free step per bucket: fine enough that hardly a node is expanded
// twice, and few enough buckets to stay in the cache.
constexpr int kBucketBits = 8;

// Expansions between two looks at the cancel flag, well under 10 ms.
constexpr std::int64_t kPollMask = 127;

constexpr std::uint64_t kGenerations = 1 << 24;

// Stands for the step that led to the start.
constexpr std::uint8_t kNoDirection = kDirections;

/// The directions that lead back beside or onto the cell before, as bits. Each
/// of these neighbours is one straight step from that cell, which costs no
/// more than the way round.
unsigned Behind(int direction) {
  if (direction == kNoDirection) return 0;
  constexpr unsigned kThreeBack = 0b00111000;
  return (kThreeBack << direction | kThreeBack << direction >> kDirections) &
         0xff;
}

}  // namespace

GridSearch::GridSearch() : open_(kBucketBits, kLongestStep) {}

void GridSearch::Prepare(const CostMap& costs) {
  const std::size_t size = costs.levels().size();
  if (!nodes_ || geometry_.width != costs.geometry().width ||
      geometry_.height != costs.geometry().height) {
    // Zeroed pages come from the system when they are first written, so a
    // large map costs no more than the part of it that is searched.
    nodes_.reset(static_cast<Node*>(std::calloc(size, sizeof(Node))));
    if (!nodes_) throw std::bad_alloc();
    generation_ = 0;
  }
  geometry_ = costs.geometry();
  stride_ = costs.stride();
  if (++generation_ == kGenerations) {
    std::memset(nodes_.get(), 0, size * sizeof(Node));
    generation_ = 1;
  }
}

// One function per direction, so that steps and lengths are constants in the
// innermost loop; inlined, or half of it would be passing arguments.
template <int kDirection>
__attribute__((always_inline)) inline void GridSearch::Look(
    const Expansion& from) {
  constexpr Cell kStep = kSteps[kDirection];
  const std::ptrdiff_t offset = kStep.y * from.stride + kStep.x;
  const CostMap::Level level = from.levels[offset];
  if (level == CostMap::kLethal) return;
  // The step before went straight to what lies behind for less; only where
  // the rectangle did not fit on that way it may do so on this one.
  if ((from.behind >> kDirection & 1) != 0 && level < from.tight_level) return;
  const StepCost cost = from.cost + CostOfStep(from.level, level, kDirection);
  const Node news = from.stamp | Node{~cost} << 8 | kDirection;
  Node& node = from.nodes[offset];
  // Most neighbours are known for less already.
  if (news <= (node | 0xff)) return;
  if (kStep.x != 0 && kStep.y != 0 &&
      (from.levels[kStep.x] == CostMap::kLethal ||
       from.levels[kStep.y * from.stride] == CostMap::kLethal)) {
    return;
  }
  const Cell cell{from.cell.x + kStep.x, from.cell.y + kStep.y};
  const StepCost key = cost + FreeCost(cell, goal_);
  if (key >= goal_cost_) return;
  if (level >= from.tight_level && !from.passages.Fits(cell, kDirection)) {
    return;
  }
  node = news;
  if (cell == goal_) {
    goal_cost_ = cost;
  } else {
    open_.Push(key, {static_cast<std::uint16_t>(cell.x),
                     static_cast<std::uint16_t>(cell.y), cost});
  }
}

inline void GridSearch::Expand(const Open& open, std::size_t index,
                               const CostMap& costs,
                               const PassageCheck& passages) {
  if (open.cost > kFarthest) return;
  const CostMap::Level* const levels = costs.levels().data() + index;
  Node* const nodes = nodes_.get() + index;
  const Expansion from = {{open.x, open.y},
                          open.cost,
                          levels[0],
                          levels,
                          nodes,
                          stride_,
                          generation_ << 40,
                          Behind(*nodes & 0xff),
                          tight_level_,
                          passages};
  Look<0>(from);
  Look<1>(from);
  Look<2>(from);
  Look<3>(from);
  Look<4>(from);
  Look<5>(from);
  Look<6>(from);
  Look<7>(from);
}

SearchResult GridSearch::Run(const CostMap& costs, const PassageCheck& passages,
                             const Cell& start, const Cell& goal,
                             const std::atomic<bool>* cancelled) {
  assert(costs.geometry().Contains(start) && costs.geometry().Contains(goal));
  assert(!costs.IsLethal(start));
  Prepare(costs);
  goal_ = goal;
  goal_cost_ = kUnreached;
  tight_level_ = passages.TightLevel(costs);
  nodes_[costs.Index(start)] = MakeNode(0, kNoDirection);
  if (start == goal) goal_cost_ = 0;
  const StepCost first_key = FreeCost(start, goal);
  open_.Restart(first_key);
  open_.Push(first_key, {static_cast<std::uint16_t>(start.x),
                         static_cast<std::uint16_t>(start.y), 0});

  SearchResult result;
  while (!open_.empty() && open_.LeastKey() < goal_cost_) {
    const Open open = open_.Pop();
    const std::size_t index = costs.Index({open.x, open.y});
    if (CostOf(nodes_[index]) != open.cost) continue;
    if ((result.nodes_expanded & kPollMask) == 0 && cancelled && *cancelled) {
      result.status = SearchStatus::kCancelled;
      return result;
    }
    ++result.nodes_expanded;
    Expand(open, index, costs, passages);
  }
  if (goal_cost_ == kUnreached) return result;
  result.status = SearchStatus::kFound;
  result.cost = goal_cost_;
  result.cells = PathToGoal(start, costs);
  return result;
}

std::vector<Cell> GridSearch::PathToGoal(const Cell& start,
                                         const CostMap& costs) const {
  std::vector<Cell> cells = {goal_};
  while (cells.back() != start) {
    const Cell& cell = cells.back();
    const Cell& step = kSteps[nodes_[costs.Index(cell)] & 0xff];
    cells.push_back({cell.x - step.x, cell.y - step.y});
  }
  std::reverse(cells.begin(), cells.end());
  return cells;
}

bool GridSearch::IsReached(const Cell& cell) const {
  return nodes_[static_cast<std::size_t>(cell.y + 1) * stride_ + cell.x + 1] >>
             40 ==
         generation_;
}

}  // namespace vfh_astar
