#include "vfh_astar/mapping/cell_marks.h"

#include <algorithm>

namespace vfh_astar {
namespace {

constexpr std::uint64_t kAllBits = ~std::uint64_t{0};
constexpr int kFraction = RowCrossings::kFraction;

/// True when the line's last crossing, and so every one, is right without
/// RowCrossings::ColumnAt's bound.
bool IsWithinBound(const RowCrossings& line) {
  const std::int64_t last = line.x + (line.count - 1) * line.next;
  return last >> kFraction == line.ColumnAt(last);
}

/// Rows from `y` to the last one of its blocks, both included.
int RowsToBlockEnd(int y, int step) {
  constexpr int kRows = CellMarks::kBlockHeight;
  return step > 0 ? kRows - y % kRows : y % kRows + 1;
}

/// Marks columns in order, both included, of a row whose word in the first
/// strip is given; from strip to strip there are `rows` words.
inline void MarkOrderedRun(std::uint64_t* word, std::size_t rows, unsigned low,
                           unsigned high) {
  constexpr unsigned kBits = CellMarks::kBlockWidth;
  const std::uint64_t from_low = kAllBits << low % kBits;
  const std::uint64_t to_high = kAllBits >> (kBits - 1 - high % kBits);
  word += low / kBits * rows;
  if (low / kBits == high / kBits) {
    *word |= from_low & to_high;
    return;
  }
  *word |= from_low;
  for (unsigned strip = low / kBits + 1; strip < high / kBits; ++strip) {
    *(word += rows) = kAllBits;
  }
  word[rows] |= to_high;
}

/// Marks the columns of crossings from `x` on in both rows of each, in a strip
/// whose word in the first row is given.
inline void MarkStepsOfStrip(std::int64_t x, const RowCrossings& line,
                             int count, std::uint64_t* word) {
  const std::ptrdiff_t step = line.step;
  const std::int64_t next = line.next;
#pragma GCC unroll 4
  for (int i = 0; i < count; ++i) {
    const std::uint64_t bit = std::uint64_t{1} << (x >> kFraction & 63);
    word[0] |= bit;
    word[step] |= bit;
    word += step;
    x += next;
  }
}

}  // namespace

void CellMarks::Reset(int columns, int rows) {
  block_columns_ = columns;
  block_rows_ = rows;
  rows_ = static_cast<std::size_t>(rows) * kBlockHeight;
  words_.assign(columns * rows_, 0);
  open_before_.resize(static_cast<std::size_t>(columns + 1) * rows);
  CloseBlocks([](int, int) { return false; });
}

void CellMarks::MarkRun(int y, int first, int last) {
  MarkOrderedRun(At(0, y), rows_, std::min(first, last), std::max(first, last));
}

void CellMarks::MarkSteps(const RowCrossings& line) {
  std::int64_t x = line.x;
  int y = line.y;
  for (int left = line.count; left > 0;) {
    const int count = std::min(left, RowsToBlockEnd(y, line.step));
    const std::int64_t last = x + (count - 1) * line.next;
    const unsigned first_strip = StripAt(x);
    const unsigned last_strip = StripAt(last);
    std::uint64_t* word = At(first_strip, y);
    y += count * line.step;
    left -= count;
    if (IsClosed(y - line.step, std::min(first_strip, last_strip),
                 std::max(first_strip, last_strip))) {
      // The column is crossed into a row that may be open.
      *At(last_strip, y) |= Bit(last >> kFraction);
    } else if (first_strip == last_strip) {
      MarkStepsOfStrip(x, line, count, word);
    } else {
      std::uint64_t* row = word - first_strip * rows_;
      for (int i = 0; i < count; ++i) {
        std::uint64_t* const crossed = row + StripAt(x) * rows_;
        crossed[0] |= Bit(x >> kFraction);
        crossed[line.step] |= Bit(x >> kFraction);
        row += line.step;
        x += line.next;
      }
    }
    x = last + line.next;
  }
}

void CellMarks::MarkRuns(const RowCrossings& line) {
  std::int64_t low = std::min(line.x, line.x + line.next);
  std::int64_t high = std::max(line.x, line.x + line.next);
  int y = line.y + line.step;
  const std::size_t rows = rows_;
  const std::int64_t next = line.next;
  const int step = line.step;
  for (int left = line.count - 1; left > 0;) {
    const int count = std::min(left, RowsToBlockEnd(y, step));
    const std::int64_t way = (count - 1) * next;
    const bool is_closed = IsClosed(y, StripAt(std::min(low, low + way)),
                                    StripAt(std::max(high, high + way)));
    std::uint64_t* word = At(0, y);
    for (int i = is_closed ? count : 0; i < count; ++i) {
      MarkOrderedRun(word + i * step, rows, (low + i * next) >> kFraction,
                     (high + i * next) >> kFraction);
    }
    y += count * step;
    low += count * next;
    high += count * next;
    left -= count;
  }
}

void CellMarks::MarkLine(const Eigen::Vector2d& from,
                         const Eigen::Vector2d& to) {
  const RowCrossings line(from, to);
  if (line.count == 0 || !IsWithinBound(line)) {
    TraverseRows(from, to, [this](int y, int first, int last) {
      MarkRun(y, first, last);
      return true;
    });
    return;
  }
  MarkRun(line.y, line.column, line.x >> kFraction);
  if (std::abs(line.next) <= std::int64_t{1} << kFraction) {
    MarkSteps(line);
  } else {
    MarkRuns(line);
  }
  const std::int64_t last = line.x + (line.count - 1) * line.next;
  MarkRun(line.y + line.count * line.step, last >> kFraction, line.last_column);
}

}  // namespace vfh_astar
