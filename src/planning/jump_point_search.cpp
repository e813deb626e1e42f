#include "vfh_astar/planning/jump_point_search.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstring>
#include <limits>
#include <new>

#include "vfh_astar/planning/cost_map.h"

namespace vfh_astar {
namespace {

// 1393 / 985 is the root of 2 to 4e-7, so that in maps of any size the order of
// two paths is right but for less than a thousandth of a cell.
constexpr std::uint32_t kStraightLength = 985;
constexpr std::uint32_t kDiagonalLength = 1393;

constexpr std::uint32_t kUnreached = std::numeric_limits<std::uint32_t>::max();

// Half a cell per bucket.
constexpr int kBucketBits = 9;

constexpr unsigned kAllDirections = 0xff;
constexpr std::uint64_t kAllBits = ~std::uint64_t{0};

constexpr std::uint32_t kNoDirection = kDirections;

int Turned(int direction, int by) { return (direction + by) & 7; }

/// Walks along a row towards higher x to where a way may open to the side:
/// where a free cell beside the row follows upon a blocked one.
/// @return its column, or the first blocked column when there is none before.
int ScanUp(const BitGrid& grid, int x, int y) {
  const std::uint64_t* const row = grid.Row(y);
  const std::uint64_t* const above = grid.Row(y + 1);
  const std::uint64_t* const below = grid.Row(y - 1);
  int word = x / 64;
  // The cell itself is not looked at, but what lies beside it counts.
  std::uint64_t ahead = x % 64 == 63 ? 0 : kAllBits << (x % 64 + 1);
  std::uint64_t carry_above = 0;
  std::uint64_t carry_below = 0;
  for (;; ++word, ahead = kAllBits) {
    const std::uint64_t opens_above =
        ~above[word] & (above[word] << 1 | carry_above);
    const std::uint64_t opens_below =
        ~below[word] & (below[word] << 1 | carry_below);
    const std::uint64_t stops = (row[word] | opens_above | opens_below) & ahead;
    if (stops != 0) return word * 64 + __builtin_ctzll(stops);
    carry_above = above[word] >> 63;
    carry_below = below[word] >> 63;
  }
}

/// The same towards lower x.
int ScanDown(const BitGrid& grid, int x, int y) {
  const std::uint64_t* const row = grid.Row(y);
  const std::uint64_t* const above = grid.Row(y + 1);
  const std::uint64_t* const below = grid.Row(y - 1);
  int word = x / 64;
  std::uint64_t ahead = (std::uint64_t{1} << (x % 64)) - 1;
  std::uint64_t carry_above = 0;
  std::uint64_t carry_below = 0;
  for (;; --word, ahead = kAllBits) {
    const std::uint64_t opens_above =
        ~above[word] & (above[word] >> 1 | carry_above);
    const std::uint64_t opens_below =
        ~below[word] & (below[word] >> 1 | carry_below);
    const std::uint64_t stops = (row[word] | opens_above | opens_below) & ahead;
    if (stops != 0) return word * 64 + 63 - __builtin_clzll(stops);
    carry_above = above[word] << 63;
    carry_below = below[word] << 63;
  }
}

}  // namespace

JumpPointSearch::JumpPointSearch(int width, int height)
    : stride_(width + 2),
      rows_(width, height),
      columns_(height, width),
      // A jump may lead straight away from the goal.
      open_(kBucketBits,
            3 * kDiagonalLength *
                static_cast<std::uint32_t>(std::max(width, height) + 2)) {
  assert(0 < width && width < 65000 && 0 < height && height < 65000);
  const std::size_t size = static_cast<std::size_t>(stride_) * (height + 2);
  // Zeroed pages come from the system when they are first written.
  nodes_.reset(static_cast<Node*>(std::calloc(size, sizeof(Node))));
  if (!nodes_) throw std::bad_alloc();
}

void JumpPointSearch::SetBlocked(const Cell& cell, bool is_blocked) {
  rows_.Set(cell.x + 1, cell.y + 1, is_blocked);
  columns_.Set(cell.y + 1, cell.x + 1, is_blocked);
}

JumpPointSearch::Length JumpPointSearch::Heuristic(int x, int y) const {
  return OctileDistance({x, y}, goal_, kStraightLength, kDiagonalLength);
}

JumpPointResult JumpPointSearch::Run(const Cell& start, const Cell& goal) {
  assert(!IsBlocked(start) && !IsBlocked(goal));
  ++generation_;
  goal_ = {goal.x + 1, goal.y + 1};
  const Open first = {static_cast<std::uint16_t>(start.x + 1),
                      static_cast<std::uint16_t>(start.y + 1), kNoDirection, 0};
  nodes_[Index(first.x, first.y)] = {generation_, 0, 0, 0};
  goal_length_ = start == goal ? 0 : kUnreached;
  open_.Restart(Heuristic(first.x, first.y));
  open_.Push(Heuristic(first.x, first.y), first);

  JumpPointResult result;
  while (!open_.empty() && open_.LeastKey() < goal_length_) {
    const Open open = open_.Pop();
    if (nodes_[Index(open.x, open.y)].length != open.length) continue;
    ++result.nodes_expanded;
    for (unsigned left = Successors(open); left != 0; left &= left - 1) {
      const int direction = __builtin_ctz(left);
      if (direction % 2 == 0) {
        JumpStraight(open, open.x, open.y, direction, open.length);
      } else {
        JumpDiagonally(open, direction);
      }
    }
  }
  if (goal_length_ == kUnreached) return result;
  result.is_found = true;
  result.cells = PathToGoal(start);
  for (std::size_t i = 1; i < result.cells.size(); ++i) {
    const bool is_straight = result.cells[i].x == result.cells[i - 1].x ||
                             result.cells[i].y == result.cells[i - 1].y;
    result.length += is_straight ? 1.0 : std::sqrt(2.0);
  }
  return result;
}

/// The directions, as bits, in which a shortest path may go on that came here
/// by `open.direction`: straight on; after a diagonal its two parts as well;
/// after a straight step also where an obstacle beside it has just ended.
unsigned JumpPointSearch::Successors(const Open& open) const {
  if (open.direction == kNoDirection) return kAllDirections;
  const int direction = static_cast<int>(open.direction);
  unsigned successors = 1u << direction;
  if (direction % 2 != 0) {
    return successors | 1u << Turned(direction, 1) |
           1u << Turned(direction, -1);
  }
  const Cell back = kSteps[Turned(direction, 4)];
  for (const int side : {1, -1}) {
    const Cell beside = kSteps[Turned(direction, 2 * side)];
    const int x = open.x + beside.x;
    const int y = open.y + beside.y;
    if (!rows_.Test(x, y) && rows_.Test(x + back.x, y + back.y)) {
      successors |=
          1u << Turned(direction, side) | 1u << Turned(direction, 2 * side);
    }
  }
  return successors;
}

void JumpPointSearch::JumpStraight(const Open& from, int x, int y,
                                   int direction, Length length) {
  const bool is_vertical = kSteps[direction].x == 0;
  const bool is_upward = direction < 4;
  const BitGrid& grid = is_vertical ? columns_ : rows_;
  const int along = is_vertical ? y : x;
  const int across = is_vertical ? x : y;
  int stop =
      is_upward ? ScanUp(grid, along, across) : ScanDown(grid, along, across);
  const int goal_along = is_vertical ? goal_.y : goal_.x;
  const int goal_across = is_vertical ? goal_.x : goal_.y;
  const bool passes_goal =
      across == goal_across &&
      (is_upward ? along < goal_along && goal_along < stop
                 : stop < goal_along && goal_along < along);
  if (passes_goal) {
    stop = goal_along;
  } else if (grid.Test(stop, across)) {
    return;
  }
  const Length total = length + kStraightLength * std::abs(stop - along);
  if (is_vertical) {
    Reach(from, x, stop, direction, total);
  } else {
    Reach(from, stop, y, direction, total);
  }
}

void JumpPointSearch::JumpDiagonally(const Open& from, int direction) {
  const Cell step = kSteps[direction];
  int x = from.x;
  int y = from.y;
  Length length = from.length;
  while (!rows_.Test(x + step.x, y) && !rows_.Test(x, y + step.y) &&
         !rows_.Test(x + step.x, y + step.y)) {
    x += step.x;
    y += step.y;
    length += kDiagonalLength;
    if (length + Heuristic(x, y) >= goal_length_) return;
    if (x == goal_.x && y == goal_.y) {
      Reach(from, x, y, direction, length);
      return;
    }
    JumpStraight(from, x, y, Turned(direction, 1), length);
    JumpStraight(from, x, y, Turned(direction, -1), length);
  }
}

void JumpPointSearch::Reach(const Open& from, int x, int y, int direction,
                            Length length) {
  const Length key = length + Heuristic(x, y);
  if (key >= goal_length_) return;
  Node& node = nodes_[Index(x, y)];
  const auto arrival = static_cast<std::uint8_t>(1u << direction);
  const bool is_known = node.generation == generation_;
  if (is_known && node.length < length) return;
  if (is_known && node.length == length) {
    // Another way of the same length goes on differently.
    if ((node.arrivals & arrival) != 0) return;
    node.arrivals |= arrival;
  } else {
    node = {generation_, length, Index(from.x, from.y), arrival};
  }
  if (x == goal_.x && y == goal_.y) {
    goal_length_ = length;
    return;
  }
  open_.Push(key, {static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y),
                   static_cast<std::uint32_t>(direction), length});
}

std::vector<Cell> JumpPointSearch::PathToGoal(const Cell& start) const {
  std::vector<Cell> cells = {{goal_.x - 1, goal_.y - 1}};
  while (cells.back() != start) {
    const Cell to = cells.back();
    const std::uint32_t parent = nodes_[Index(to.x + 1, to.y + 1)].parent;
    const Cell from{static_cast<int>(parent % stride_) - 1,
                    static_cast<int>(parent / stride_) - 1};
    // A jump goes diagonally first and straight at its end.
    Cell at = to;
    while (at != from) {
      const int dx = from.x - at.x;
      const int dy = from.y - at.y;
      const bool is_straight = std::abs(dx) != std::abs(dy);
      if (!is_straight || std::abs(dx) > std::abs(dy)) at.x += dx > 0 ? 1 : -1;
      if (!is_straight || std::abs(dy) > std::abs(dx)) at.y += dy > 0 ? 1 : -1;
      cells.push_back(at);
    }
  }
  std::reverse(cells.begin(), cells.end());
  return cells;
}

}  // namespace vfh_astar
