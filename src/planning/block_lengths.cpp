#include "vfh_astar/planning/block_lengths.h"

namespace vfh_astar {
namespace {

/// Whether rows lie in the order of lanes or lanes in the order of rows makes
/// no difference to what is done with them.
using Passages = std::array<RowPassage, kBlockSide - 1>;

inline Passages PassagesOf(std::uint64_t free) {
  Passages passages;
  Lanes row = WallsOfRow(free, 0);
  for (int i = 0; i < kBlockSide - 1; ++i) {
    const Lanes next = WallsOfRow(free, i + 1);
    passages[i] = PassageBetween(row, next);
    row = next;
  }
  return passages;
}

/// Steps from row to row, up and down apart from each other, so that neither
/// waits for the other.
/// @return true when a length has become less.
inline bool Sweep(const Passages& passages, LaneSquare& rows) {
  constexpr int kLast = kBlockSide - 1;
  LaneSquare upward;
  LaneSquare downward;
  upward[0] = rows[0];
  downward[kLast] = rows[kLast];
  for (int i = 0; i < kLast; ++i) {
    const int j = kLast - i;
    upward[i + 1] = Greater(rows[i + 1], RowOffer(upward[i], passages[i]));
    downward[j - 1] =
        Greater(rows[j - 1], RowOffer(downward[j], passages[j - 1]));
  }
  Lanes changed{};
  for (int i = 0; i < kBlockSide; ++i) {
    const Lanes row = Greater(upward[i], downward[i]);
    changed |= row ^ rows[i];
    rows[i] = row;
  }
  return AnySet(changed);
}

}  // namespace

// Shortest ways within a block. None goes from a row to the next and straight
// back, since where it could, a step along the row is open and shorter. So
// between two steps along a row it goes from row to row in one direction: a
// sweep does all of that, and when one sweep changes nothing after the other,
// all is done.
void RelaxBlock(std::uint64_t free_rows, std::uint64_t free_columns,
                LaneSquare& rows, LaneSquare& columns) {
  const Passages by_row = PassagesOf(free_rows);
  const Passages by_column = PassagesOf(free_columns);
  Sweep(by_column, columns);
  for (;;) {
    rows = Transposed(columns);
    if (!Sweep(by_row, rows)) return;
    columns = Transposed(rows);
    if (!Sweep(by_column, columns)) return;
  }
}

}  // namespace vfh_astar
