#include "vfh_astar/planning/block_lengths.h"

namespace vfh_astar {
namespace {

/// Whether rows lie in the order of lanes or lanes in the order of rows makes
/// no difference to what is done with them.
struct Passages {
  explicit Passages(std::uint64_t free);

  // Between one row and the next: straight, and to the higher or lower lane.
  std::array<Lanes, kBlockSide - 1> straight;
  std::array<Lanes, kBlockSide - 1> up;
  std::array<Lanes, kBlockSide - 1> down;
};

using MaskTable = std::array<Lanes, 256>;

MaskTable MakeMasks() {
  MaskTable masks{};
  for (int bits = 0; bits < 256; ++bits) {
    for (int lane = 0; lane < kLanes; ++lane) {
      masks[bits][lane] = (bits >> lane & 1) != 0 ? -1 : 0;
    }
  }
  return masks;
}

const MaskTable kMasks = MakeMasks();

Passages::Passages(std::uint64_t free) {
  Lanes row = MaskOfRow(free, 0);
  for (int i = 0; i < kBlockSide - 1; ++i) {
    const Lanes next = MaskOfRow(free, i + 1);
    straight[i] = row & next;
    // A diagonal step needs all four cells, whichever way it goes.
    up[i] = straight[i] & ShiftedUp(straight[i]);
    down[i] = ShiftedDown(up[i]);
    row = next;
  }
}

/// Steps from row to row, to and fro.
/// @return true when a length has become less.
inline bool Sweep(const Passages& passages, LaneSquare& rows) {
  const LaneSquare before = rows;
  for (int i = 0; i < kBlockSide - 1; ++i) {
    rows[i + 1] =
        Greater(rows[i + 1], RowOffer(rows[i], passages.straight[i],
                                      passages.up[i], passages.down[i]));
  }
  for (int i = kBlockSide - 2; i >= 0; --i) {
    rows[i] = Greater(rows[i], RowOffer(rows[i + 1], passages.straight[i],
                                        passages.up[i], passages.down[i]));
  }
  Lanes changed{};
  for (int i = 0; i < kBlockSide; ++i) changed |= before[i] ^ rows[i];
  return AnySet(changed);
}

}  // namespace

Lanes MaskOfRow(std::uint64_t free, int row) {
  return kMasks[free >> (8 * row) & 0xff];
}

// Shortest ways within a block. A shortest way does not turn by more than a
// right angle at once, so between two steps along a row it goes from row to
// row in one direction: a sweep does all of that, and when one sweep changes
// nothing after the other, all is done.
void RelaxBlock(std::uint64_t free_rows, std::uint64_t free_columns,
                LaneSquare& rows, LaneSquare& columns) {
  const Passages by_row(free_rows);
  const Passages by_column(free_columns);
  Sweep(by_column, columns);
  for (;;) {
    rows = Transposed(columns);
    if (!Sweep(by_row, rows)) return;
    columns = Transposed(rows);
    if (!Sweep(by_column, columns)) return;
  }
}

}  // namespace vfh_astar
