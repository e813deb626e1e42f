#include "vfh_astar/planning/cost_block.h"

#include <cstdlib>

// Other compilers have other ways to compile a function for one processor.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)

#include "vfh_astar/planning/cost_lanes.h"

#pragma GCC push_options
#pragma GCC target("avx2")

namespace vfh_astar {
namespace {

constexpr int kSide = CostBlock::kSide;
constexpr int kLast = kSide - 1;
constexpr StepCost kUnreached = CostBlock::kUnreached;

/// What steps from a line to the one beside it, or back, cost; kUnreached or
/// more where there is none.
struct LinePassage {
  CostLanes straight;
  CostLanes rising;   ///< from a lane of the line to the next one beside it.
  CostLanes falling;  ///< from the lane after it to the same one beside it.
  // Both stand in the higher one of their two lanes. Lane 0 has none, which
  // also undoes that lanes are rotated.
};

/// @param[in] from, to levels of the two lines.
inline LinePassage PassageBetween(CostLanes from, CostLanes to) {
  const auto wall =
      (CostLanes)((from == CostMap::kLethal) | (to == CostMap::kLethal)) &
      kUnreached;
  // A diagonal step needs all four cells, whichever way it goes.
  const CostLanes corner = wall | RotatedUp(wall) | CostLanes{kUnreached};
  return {(from + to) * kStraight | wall,
          (RotatedUp(from) + to) * kDiagonal | corner,
          (from + RotatedUp(to)) * kDiagonal | corner};
}

using Passages = std::array<LinePassage, kLast>;

inline Passages PassagesOf(const CostSquare& levels) {
  Passages passages;
  for (int i = 0; i < kLast; ++i) {
    passages[i] = PassageBetween(levels.lines[i], levels.lines[i + 1]);
  }
  return passages;
}

/// What the costs of a line give to those of the line after it.
inline CostLanes OfferOnward(CostLanes line, const LinePassage& passage) {
  return Lesser(line + passage.straight,
                Lesser(RotatedUp(line) + passage.rising,
                       RotatedDown(line + passage.falling)));
}

/// And to those of the line before.
inline CostLanes OfferBack(CostLanes line, const LinePassage& passage) {
  return Lesser(line + passage.straight,
                Lesser(RotatedDown(line + passage.rising),
                       RotatedUp(line) + passage.falling));
}

/// Steps from line to line, onward and back apart from each other, so that
/// neither waits for the other.
/// @return true when a cost has become less.
inline bool Sweep(const Passages& passages, CostSquare& costs) {
  CostSquare onward;
  CostSquare back;
  onward.lines[0] = costs.lines[0];
  back.lines[kLast] = costs.lines[kLast];
  for (int i = 0; i < kLast; ++i) {
    const int j = kLast - i;
    onward.lines[i + 1] =
        Lesser(costs.lines[i + 1], OfferOnward(onward.lines[i], passages[i]));
    back.lines[j - 1] =
        Lesser(costs.lines[j - 1], OfferBack(back.lines[j], passages[j - 1]));
  }
  CostLanes changed{};
  for (int i = 0; i < kSide; ++i) {
    const CostLanes line = Lesser(onward.lines[i], back.lines[i]);
    changed |= line ^ costs.lines[i];
    costs.lines[i] = line;
  }
  return AnySet(changed);
}

/// Steps within the block till no cost becomes less.
/// @param[out] rows
/// @param[in,out] columns the same with x and y exchanged.
inline void Relax(const CostSquare& row_levels, const CostSquare& column_levels,
                  CostSquare& rows, CostSquare& columns) {
  const Passages by_row = PassagesOf(row_levels);
  const Passages by_column = PassagesOf(column_levels);
  Sweep(by_column, columns);
  for (;;) {
    rows = Transposed(columns);
    if (!Sweep(by_row, rows)) return;
    columns = Transposed(rows);
    if (!Sweep(by_column, columns)) return;
  }
}

inline bool IsReached(CostLanes costs) {
  return AnySet((CostLanes)(costs < kUnreached));
}

/// The heuristic of a line of cells.
/// @param[in] along, across from the line's first cell to the goal.
inline CostLanes HeuristicOf(int along, int across) {
  using Signed = std::int32_t __attribute__((vector_size(32)));
  const Signed ahead = Signed{0, 1, 2, 3, 4, 5, 6, 7} - along;
  const auto a = (CostLanes)(ahead < 0 ? -ahead : ahead);
  const CostLanes b = AllLanes(std::abs(across));
  const CostLanes lesser = Lesser(a, b);
  return (a + b - lesser) * kFreeStep + lesser * (kFreeDiagonal - kFreeStep);
}

/// @param[in,out] known costs of the line of cells that offers are made to.
/// @return their part of the news.
inline StepCost Push(CostLanes offers, int along, int across,
                     CostBlock::Line& known) {
  const CostLanes before = Load(known);
  const auto is_less = (CostLanes)(offers < before);
  if (!AnySet(is_less)) return kUnreached;
  Store(Lesser(offers, before), known);
  const CostLanes estimates = offers + HeuristicOf(along, across);
  return LeastLane(is_less != 0 ? estimates : AllLanes(kUnreached));
}

inline CostSquare RowLevels(const CostBlockPlace& place) {
  CostSquare levels;
  for (int y = 0; y < kSide; ++y) {
    levels.lines[y] = LoadLevels(place.levels + y * place.stride);
  }
  return levels;
}

inline CostLanes ColumnLevels(const CostBlockPlace& place, int x) {
  CostBlock::Line levels;
  for (int y = 0; y < kSide; ++y) {
    levels[y] = place.levels[y * place.stride + x];
  }
  return Load(levels);
}

CostBlockNews Expand(CostBlock& block, const CostBlockPlace& place) {
  const CostSquare row_levels = RowLevels(place);
  const CostSquare column_levels = Transposed(row_levels);
  CostSquare rows;
  for (int y = 0; y < kSide; ++y) rows.lines[y] = Load(block.rows[y]);
  CostSquare columns = Transposed(rows);
  columns.lines[0] = Lesser(columns.lines[0], Load(block.west));
  columns.lines[kLast] = Lesser(columns.lines[kLast], Load(block.east));
  Relax(row_levels, column_levels, rows, columns);
  for (int y = 0; y < kSide; ++y) Store(rows.lines[y], block.rows[y]);
  Store(columns.lines[0], block.west);
  Store(columns.lines[kLast], block.east);

  CostBlockNews news;
  news.fill(kUnreached);
  const auto entered = [&block](std::ptrdiff_t offset) -> CostBlock& {
    CostBlock& beside = (&block)[offset];
    if (beside.generation != block.generation) beside.Clear(block.generation);
    return beside;
  };
  const Cell& goal = place.goal;
  // No way leads out of the map, whose outermost cells are lethal, so what lies
  // beyond is not looked at.
  if (IsReached(rows.lines[0])) {
    const CostLanes levels = LoadLevels(place.levels - place.stride);
    const LinePassage passage = PassageBetween(levels, row_levels.lines[0]);
    news[kSouth] = Push(OfferBack(rows.lines[0], passage), goal.x, goal.y + 1,
                        entered(-place.blocks_per_row).rows[kLast]);
  }
  if (IsReached(rows.lines[kLast])) {
    const CostLanes levels = LoadLevels(place.levels + kSide * place.stride);
    const LinePassage passage = PassageBetween(row_levels.lines[kLast], levels);
    news[kNorth] = Push(OfferOnward(rows.lines[kLast], passage), goal.x,
                        goal.y - kSide, entered(place.blocks_per_row).rows[0]);
  }
  if (IsReached(columns.lines[0])) {
    const LinePassage passage =
        PassageBetween(ColumnLevels(place, -1), column_levels.lines[0]);
    news[kWest] = Push(OfferBack(columns.lines[0], passage), goal.y, goal.x + 1,
                       entered(-1).east);
  }
  if (IsReached(columns.lines[kLast])) {
    const LinePassage passage =
        PassageBetween(column_levels.lines[kLast], ColumnLevels(place, kSide));
    news[kEast] = Push(OfferOnward(columns.lines[kLast], passage), goal.y,
                       goal.x - kSide, entered(1).west);
  }
  return news;
}

}  // namespace
}  // namespace vfh_astar

#pragma GCC pop_options

namespace vfh_astar {

ExpandCostBlock FindCostBlockExpansion() {
  return __builtin_cpu_supports("avx2") ? Expand : nullptr;
}

}  // namespace vfh_astar

#else

namespace vfh_astar {

ExpandCostBlock FindCostBlockExpansion() { return nullptr; }

}  // namespace vfh_astar

#endif
