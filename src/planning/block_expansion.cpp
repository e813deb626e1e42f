#include "vfh_astar/planning/block_search.h"

#include <algorithm>
#include <cstdlib>
#include <limits>

#include "vfh_astar/planning/block_lengths.h"
#include "vfh_astar/planning/cost_map.h"

namespace vfh_astar {
namespace {

constexpr int kSide = kBlockSide;

// What is longer may have lost its next step to the end of the range.
constexpr int kLeast = kBlockDiagonal + 1;

bool IsShortOfRange(const LaneSquare& rows) {
  Lanes is_short{};
  for (const Lanes& row : rows) is_short |= (row < kLeast) & (row > 0);
  return AnySet(is_short);
}

}  // namespace

/// Eight cells in a line at the edge of the block that lengths come to.
struct BlockSearch::Edge {
  Lanes from;        ///< lengths on the other side.
  Lanes from_walls;  ///< as WallsOfRow gives them.
  Lanes walls;
  Cell first;
  bool is_vertical;
};

void BlockSearch::Expand(Block& block) {
  LaneSquare columns = Transposed(block.rows);
  columns.front() = Greater(columns.front(), block.west);
  columns.back() = Greater(columns.back(), block.east);
  LaneSquare rows;
  RelaxBlock(block.free_rows, block.free_columns, rows, columns);
  block.rows = rows;
  if (IsShortOfRange(rows)) DropShort(block);
  block.west = columns.front();
  block.east = columns.back();

  constexpr int kLast = kSide - 1;
  Block& below = (&block)[-stride_];
  Block& above = (&block)[stride_];
  Block& west = (&block)[-1];
  Block& east = (&block)[1];
  PushEdge(block, below,
           {rows.front(),
            WallsOfRow(block.free_rows, 0),
            WallsOfRow(below.free_rows, kLast),
            {block.x, block.y - 1},
            false},
           below.rows.back());
  PushEdge(block, above,
           {rows.back(),
            WallsOfRow(block.free_rows, kLast),
            WallsOfRow(above.free_rows, 0),
            {block.x, block.y + kSide},
            false},
           above.rows.front());
  PushEdge(block, west,
           {columns.front(),
            WallsOfRow(block.free_columns, 0),
            WallsOfRow(west.free_columns, kLast),
            {block.x - 1, block.y},
            true},
           west.east);
  PushEdge(block, east,
           {columns.back(),
            WallsOfRow(block.free_columns, kLast),
            WallsOfRow(east.free_columns, 0),
            {block.x + kSide, block.y},
            true},
           east.west);
  for (const int direction : {1, 3, 5, 7}) PushCorner(block, direction);
}

inline void BlockSearch::PushEdge(const Block& from, Block& to,
                                  const Edge& edge, Lanes& lengths) {
  const Lanes offers =
      RowOffer(edge.from, PassageBetween(edge.from_walls, edge.walls));
  const Lanes is_offered = offers > 0;
  if (to.generation != generation_) {
    if (!AnySet(is_offered)) return;
    Enter(to, from.ceiling - GreatestLane(offers));
  }
  const int shift = static_cast<int>(to.ceiling - from.ceiling);
  const bool fits = -kMost < shift && (shift <= kBlockStraight ||
                                       GreatestLane(offers) + shift <= kMost);
  if (fits) {
    const Lanes news =
        Greater(offers + static_cast<std::int16_t>(shift), AllLanes(1)) &
        is_offered;
    const Lanes is_less = news > lengths;
    if (!AnySet(is_less)) return;
    if (!AnySet(is_less & (news < kLeast))) {
      lengths = Greater(lengths, news);
      Open(to, LeastEstimate(to, edge, news, is_less));
      return;
    }
  }
  for (int lane = 0; lane < kLanes; ++lane) {
    if (offers[lane] == 0) continue;
    const Cell cell = {edge.first.x + (edge.is_vertical ? 0 : lane),
                       edge.first.y + (edge.is_vertical ? lane : 0)};
    PushCell(from, to, cell, offers[lane]);
  }
}

inline BlockSearch::Length BlockSearch::LeastEstimate(const Block& block,
                                                      const Edge& edge,
                                                      Lanes lengths,
                                                      Lanes is_wanted) const {
  using Unsigned = std::uint16_t __attribute__((vector_size(16)));
  const int along =
      edge.is_vertical ? goal_.y - edge.first.y : goal_.x - edge.first.x;
  const int across = std::abs(edge.is_vertical ? goal_.x - edge.first.x
                                               : goal_.y - edge.first.y);
  const Lanes ahead =
      Lanes{0, 1, 2, 3, 4, 5, 6, 7} - static_cast<std::int16_t>(along);
  const Lanes a = Greater(ahead, -ahead);
  const Lanes b = AllLanes(static_cast<std::int16_t>(across));
  // Only what they exceed the least one by fits into the lanes.
  const int least_a = std::abs(std::clamp(along, 0, kLanes - 1) - along);
  const Length least =
      kBlockStraight * std::max(least_a, across) +
      (kBlockDiagonal - kBlockStraight) * std::min(least_a, across);
  const Lanes excess =
      (Lanes)((Unsigned)Greater(a, b) * std::uint16_t{kBlockStraight} +
              (Unsigned)Lesser(a, b) *
                  std::uint16_t{kBlockDiagonal - kBlockStraight} -
              static_cast<std::uint16_t>(least));
  constexpr std::int16_t kNever = std::numeric_limits<std::int16_t>::min();
  const Lanes gained = is_wanted ? lengths - excess : AllLanes(kNever);
  return block.ceiling + least - GreatestLane(gained);
}

inline void BlockSearch::PushCorner(const Block& from, int direction) {
  constexpr int kLast = kSide - 1;
  const Cell step = kSteps[direction];
  const int x = step.x > 0 ? kLast : 0;
  const int y = step.y > 0 ? kLast : 0;
  const Block* const beside = &from + step.x;
  Block* const over = const_cast<Block*>(&from) + step.y * stride_;
  Block* const to = over + step.x;
  const auto is_free = [](const Block& block, int column, int row) {
    return (block.free_rows >> (kSide * row + column) & 1) != 0;
  };
  const int below = from.rows[y][x];
  const int known = to->rows[kLast - y][kLast - x];
  // Without branches, which would be guessed wrong: few corners bring news.
  const bool is_open = (below > 0) & is_free(*beside, kLast - x, y) &
                       is_free(*over, x, kLast - y) &
                       is_free(*to, kLast - x, kLast - y);
  const auto shift = static_cast<int>(to->ceiling - from.ceiling);
  const bool is_news = (to->generation != generation_) | (known == 0) |
                       (below - kBlockDiagonal + shift > known);
  if (!(is_open & is_news)) return;
  PushCell(from, *to, {from.x + x + step.x, from.y + y + step.y},
           below - kBlockDiagonal);
}

void BlockSearch::PushCell(const Block& from, Block& to, const Cell& cell,
                           int below) {
  const Length length = from.ceiling - below;
  const Length estimate = length + Heuristic(cell);
  if (estimate >= goal_length_) return;
  if (to.generation != generation_) Enter(to, length);
  int below_to = static_cast<int>(to.ceiling - length);
  if (below_to > kMost) {
    LowerCeiling(to, below_to - kFirst);
    below_to = kFirst;
  }
  std::int16_t* const row =
      reinterpret_cast<std::int16_t*>(&to.rows[cell.y % kSide]);
  std::int16_t& known = row[cell.x % kSide];
  if (known != 0 && below_to <= known) return;
  if (below_to < kLeast) {
    Drop(estimate);
    return;
  }
  known = static_cast<std::int16_t>(below_to);
  Open(to, estimate);
}

void BlockSearch::DropShort(const Block& block) {
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      const int below = block.rows[y][x];
      if (below == 0 || below >= kLeast) continue;
      Drop(block.ceiling - below + Heuristic({block.x + x, block.y + y}));
    }
  }
}

void BlockSearch::LowerCeiling(Block& block, int by) {
  for (int y = 0; y < kSide; ++y) {
    Lanes& row = block.rows[y];
    row[0] = std::max(row[0], block.west[y]);
    row[kSide - 1] = std::max(row[kSide - 1], block.east[y]);
    for (int x = 0; x < kSide; ++x) {
      if (row[x] == 0) continue;
      const int below = row[x] - by;
      if (below <= 0) {
        Drop(block.ceiling - row[x] + Heuristic({block.x + x, block.y + y}));
      }
      row[x] = static_cast<std::int16_t>(std::max(0, below));
    }
  }
  block.west = AllLanes(0);
  block.east = AllLanes(0);
  block.ceiling -= by;
}

}  // namespace vfh_astar
