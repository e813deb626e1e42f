#include "vfh_astar/planning/canonical_search.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdlib>

#include "vfh_astar/planning/cost_map.h"

namespace vfh_astar {
namespace {

// 1393 / 985 is the root of 2 to 4e-7.
constexpr std::uint32_t kStraightLength = 985;
constexpr std::uint32_t kDiagonalLength = 1393;

// A step away from the goal adds its length to the estimate twice.
constexpr std::uint32_t kLongestStep = 2 * kDiagonalLength;

constexpr int kGenerationShift = 12;
constexpr int kDirectionShift = 8;
constexpr std::uint32_t kAround = 0xff;
constexpr std::uint32_t kBlocked = 0xfffff;  ///< as a generation.

// Stands for the step that led to the start.
constexpr std::uint32_t kNoDirection = kDirections;

bool IsSet(unsigned bits, int direction) {
  return (bits >> (direction & 7) & 1) != 0;
}

/// Whether a step may go on a shortest path that came here by `arrival`: from
/// the cell before, what lies behind or beside is nearer on another way, unless
/// the cell for that way is blocked. Of a straight and a diagonal step in
/// either order the diagonal goes first.
bool GoesOn(int arrival, int direction, unsigned blocked) {
  const int turn = (direction - arrival) & 7;
  if (arrival % 2 != 0) return turn <= 1 || turn == 7;
  if (turn == 1 || turn == 2) return IsSet(blocked, arrival + 3);
  if (turn == 7 || turn == 6) return IsSet(blocked, arrival + 5);
  return turn == 0;
}

bool IsOpen(int direction, unsigned blocked) {
  if (IsSet(blocked, direction)) return false;
  return direction % 2 == 0 ||
         (!IsSet(blocked, direction + 1) && !IsSet(blocked, direction + 7));
}

/// Directions to go on, as bits, by the direction of arrival and the blocked
/// neighbours.
using SuccessorTable =
    std::array<std::array<std::uint8_t, 256>, kDirections + 1>;

SuccessorTable MakeSuccessors() {
  SuccessorTable table{};
  for (int arrival = 0; arrival <= kDirections; ++arrival) {
    for (unsigned blocked = 0; blocked < 256; ++blocked) {
      for (int direction = 0; direction < kDirections; ++direction) {
        const bool goes_on = arrival == static_cast<int>(kNoDirection) ||
                             GoesOn(arrival, direction, blocked);
        if (goes_on && IsOpen(direction, blocked)) {
          table[arrival][blocked] |= 1 << direction;
        }
      }
    }
  }
  return table;
}

const SuccessorTable kSuccessors = MakeSuccessors();

}  // namespace

CanonicalSearch::CanonicalSearch(int width, int height)
    : stride_(width + 2),
      nodes_(static_cast<std::size_t>(stride_) * (height + 2), 0),
      open_(0, kLongestStep) {
  assert(0 < width && width < 65000 && 0 < height && height < 65000);
  for (int x = -1; x <= width; ++x) {
    SetBlocked({x, -1}, true);
    SetBlocked({x, height}, true);
  }
  for (int y = 0; y < height; ++y) {
    SetBlocked({-1, y}, true);
    SetBlocked({width, y}, true);
  }
}

void CanonicalSearch::SetBlocked(const Cell& cell, bool is_blocked) {
  const int rows = static_cast<int>(nodes_.size() / stride_);
  const int x = cell.x + 1;
  const int y = cell.y + 1;
  Node& node = nodes_[Index(x, y)];
  node &= kAround;
  if (is_blocked) node |= kBlocked << kGenerationShift;
  for (int direction = 0; direction < kDirections; ++direction) {
    const int beside_x = x - kSteps[direction].x;
    const int beside_y = y - kSteps[direction].y;
    if (beside_x < 0 || beside_x >= stride_ || beside_y < 0 ||
        beside_y >= rows) {
      continue;
    }
    Node& beside = nodes_[Index(beside_x, beside_y)];
    const Node bit = Node{1} << direction;
    beside = is_blocked ? beside | bit : beside & ~bit;
  }
}

inline std::uint32_t CanonicalSearch::Heuristic(int x, int y) const {
  const std::uint32_t dx = std::abs(x - goal_.x);
  const std::uint32_t dy = std::abs(y - goal_.y);
  return kStraightLength * std::max(dx, dy) +
         (kDiagonalLength - kStraightLength) * std::min(dx, dy);
}

void CanonicalSearch::StartGeneration() {
  if (++generation_ < kBlocked) return;
  for (Node& node : nodes_) {
    if (node >> kGenerationShift != kBlocked) node &= kAround;
  }
  generation_ = 1;
}

JumpPointResult CanonicalSearch::Run(const Cell& start, const Cell& goal) {
  StartGeneration();
  goal_ = {goal.x + 1, goal.y + 1};
  const Node closed = generation_ << kGenerationShift;
  const Open first = {static_cast<std::uint16_t>(start.x + 1),
                      static_cast<std::uint16_t>(start.y + 1), kNoDirection};
  open_.Restart(Heuristic(first.x, first.y));
  open_.Push(Heuristic(first.x, first.y), first);
  std::int64_t expanded = 0;
  while (!open_.empty()) {
    const std::uint32_t key = open_.LeastKey();
    const Open open = open_.Pop();
    Node* const node = &nodes_[Index(open.x, open.y)];
    if (*node >= closed) continue;
    const unsigned around = *node & kAround;
    *node = closed | open.direction << kDirectionShift | around;
    ++expanded;
    if (open.x == goal_.x && open.y == goal_.y) {
      JumpPointResult result = PathTo(start);
      result.nodes_expanded = expanded;
      return result;
    }
    const std::uint32_t length = key - Heuristic(open.x, open.y);
    for (unsigned left = kSuccessors[open.direction][around]; left != 0;
         left &= left - 1) {
      const int direction = __builtin_ctz(left);
      const Cell step = kSteps[direction];
      if (node[step.y * std::ptrdiff_t{stride_} + step.x] >= closed) continue;
      const int x = open.x + step.x;
      const int y = open.y + step.y;
      const std::uint32_t step_length =
          direction % 2 == 0 ? kStraightLength : kDiagonalLength;
      open_.Push(length + step_length + Heuristic(x, y),
                 {static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y),
                  static_cast<std::uint32_t>(direction)});
    }
  }
  JumpPointResult result;
  result.nodes_expanded = expanded;
  return result;
}

JumpPointResult CanonicalSearch::PathTo(const Cell& start) const {
  JumpPointResult result;
  result.is_found = true;
  result.cells = {{goal_.x - 1, goal_.y - 1}};
  while (result.cells.back() != start) {
    const Cell cell = result.cells.back();
    const int direction =
        nodes_[Index(cell.x + 1, cell.y + 1)] >> kDirectionShift & 0xf;
    const Cell step = kSteps[direction];
    result.cells.push_back({cell.x - step.x, cell.y - step.y});
    result.length += direction % 2 == 0 ? 1.0 : std::sqrt(2.0);
  }
  std::reverse(result.cells.begin(), result.cells.end());
  return result;
}

}  // namespace vfh_astar
