#ifndef VFH_ASTAR_MAPPING_CELL_MARKS_H_
#define VFH_ASTAR_MAPPING_CELL_MARKS_H_

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "vfh_astar/grid/ray_traversal.h"

namespace vfh_astar {

/// A set of cells, as a bit for each: of 64 columns a word per row, and the
/// words of such a strip one after the other, so that a line finds most of its
/// words beside each other, whichever way it runs.
///
/// Blocks of 64 x 16 cells may be closed when nobody asks for what is marked in
/// them: lines then jump over them, and leave there some of their cells at
/// most.
class CellMarks {
 public:
  static constexpr int kBlockWidth = 64;   ///< columns, a word of bits.
  static constexpr int kBlockHeight = 16;  ///< rows.

  /// Makes room for so many blocks in each direction, none of it marked and all
  /// of it open.
  void Reset(int columns, int rows);

  /// Before the first line.
  /// @param[in] is_closed called as is_closed(column, row) for each block.
  template <typename Predicate>
  void CloseBlocks(Predicate&& is_closed) {
    std::size_t i = 0;
    for (int row = 0; row < block_rows_; ++row, ++i) {
      for (int column = 0; column < block_columns_; ++column, ++i) {
        open_before_[i + 1] =
            open_before_[i] + (is_closed(column, row) ? 0 : 1);
      }
    }
  }

  /// The columns of a strip of blocks in a row, and behind it those of the rows
  /// that follow; the lowest column is the lowest bit.
  const std::uint64_t* Words(int strip, int y) const {
    return words_.data() + Index(strip, y);
  }

  void Mark(int x, int y) { *At(x / kBlockWidth, y) |= Bit(x); }

  /// Marks the cells that TraverseRows visits.
  /// @param[in] from, to cell units, within the room.
  void MarkLine(const Eigen::Vector2d& from, const Eigen::Vector2d& to);

 private:
  static std::uint64_t Bit(unsigned x) {
    return std::uint64_t{1} << x % kBlockWidth;
  }
  static unsigned StripAt(std::int64_t x) {
    return static_cast<unsigned>(x >> RowCrossings::kFraction) / kBlockWidth;
  }

  std::size_t Index(unsigned strip, unsigned y) const {
    return strip * rows_ + y;
  }
  std::uint64_t* At(unsigned strip, unsigned y) {
    return words_.data() + Index(strip, y);
  }
  bool IsClosed(int y, unsigned first_strip, unsigned last_strip) const {
    const int* row =
        open_before_.data() + y / kBlockHeight * (block_columns_ + 1);
    return row[first_strip] == row[last_strip + 1];
  }

  /// Marks columns of a row, both included, in either order.
  void MarkRun(int y, int first, int last);
  /// What is between a line's first row and its last.
  void MarkBetween(const RowCrossings& line);
  /// Marks rows from `y` up of a line that crosses the lowest one's lower edge
  /// at `x` and goes on by `slope` per row, both as in RowCrossings.
  void MarkRows(int y, std::int64_t x, std::int64_t slope, int rows);
  /// Of these rows those that can be marked at once: whole blocks of them, as
  /// long as the line stays in its strip, which is open.
  int OpenRowsOfStrip(int y, std::int64_t x, std::int64_t slope,
                      int rows) const;

  int block_columns_ = 0;
  int block_rows_ = 0;
  std::size_t rows_ = 0;  ///< of cells.
  /// Some more than the cells need, so that rows can be marked several at once.
  std::vector<std::uint64_t> words_;
  /// Open blocks in the same row of blocks before each, and in all of the row.
  std::vector<int> open_before_;
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_MAPPING_CELL_MARKS_H_
