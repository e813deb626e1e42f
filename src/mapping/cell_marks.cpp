#include "vfh_astar/mapping/cell_marks.h"

#include <algorithm>
#include <cstring>

// GCC picks between versions of a function when the program starts.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define VFH_ASTAR_HAS_AVX2_VERSION
#endif

namespace vfh_astar {
namespace {

constexpr std::uint64_t kAllBits = ~std::uint64_t{0};
constexpr int kFraction = RowCrossings::kFraction;
constexpr int kLanes = 4;  ///< rows marked at once.

/// True when the line's last crossing, and so every one, is right without
/// RowCrossings::ColumnAt's bound.
bool IsWithinBound(const RowCrossings& line) {
  const std::int64_t last = line.x + (line.count - 1) * line.next;
  return last >> kFraction == line.ColumnAt(last);
}

/// Rows from `y` up to the end of its blocks.
int RowsToBlockEnd(int y) {
  return CellMarks::kBlockHeight - y % CellMarks::kBlockHeight;
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

constexpr std::uint64_t kLastColumn = CellMarks::kBlockWidth - 1;

/// Marks in each row of a strip the columns from one crossing to the next, both
/// included.
/// @param[in,out] words of the strip from the first row on; of kLanes - 1 rows
///   beyond the last the words may be written as they were.
/// @param[in] low, high of the first row's crossings that with the lower
///   column, and the other.
/// @param[in] slope how much more both are from row to row.
#ifdef VFH_ASTAR_HAS_AVX2_VERSION
__attribute__((target("default")))
#endif
void MarkRowsOfStrip(std::uint64_t* words, std::uint64_t low,
                     std::uint64_t high, std::uint64_t slope, int rows) {
  for (int i = 0; i < rows; ++i) {
    // Beyond the last column there is none: 2 is shifted out, and the
    // difference still holds all bits from the lowest on.
    words[i] |= (std::uint64_t{2} << (high >> kFraction & kLastColumn)) -
                (std::uint64_t{1} << (low >> kFraction & kLastColumn));
    low += slope;
    high += slope;
  }
}

#ifdef VFH_ASTAR_HAS_AVX2_VERSION
using Lanes [[gnu::vector_size(8 * kLanes)]] = std::uint64_t;

/// The same in several rows at once: AVX2 can shift each by its own amount.
__attribute__((target("avx2"))) void MarkRowsOfStrip(std::uint64_t* words,
                                                     std::uint64_t low,
                                                     std::uint64_t high,
                                                     std::uint64_t slope,
                                                     int rows) {
  const Lanes more = {0, slope, 2 * slope, 3 * slope};
  Lanes lows = low + more;
  Lanes highs = high + more;
  Lanes word;
  for (int left = rows; left > 0; left -= kLanes, words += kLanes) {
    Lanes columns = (Lanes{2, 2, 2, 2} << (highs >> kFraction & kLastColumn)) -
                    (Lanes{1, 1, 1, 1} << (lows >> kFraction & kLastColumn));
    if (left < kLanes) {
      columns &=
          Lanes{kAllBits, left > 1 ? kAllBits : 0, left > 2 ? kAllBits : 0, 0};
    }
    std::memcpy(&word, words, sizeof(word));
    word |= columns;
    std::memcpy(words, &word, sizeof(word));
    lows += kLanes * slope;
    highs += kLanes * slope;
  }
}
#endif

}  // namespace

void CellMarks::Reset(int columns, int rows) {
  block_columns_ = columns;
  block_rows_ = rows;
  rows_ = static_cast<std::size_t>(rows) * kBlockHeight;
  words_.assign(columns * rows_ + kLanes - 1, 0);
  open_before_.resize(static_cast<std::size_t>(columns + 1) * rows);
  CloseBlocks([](int, int) { return false; });
}

void CellMarks::MarkRun(int y, int first, int last) {
  MarkOrderedRun(At(0, y), rows_, std::min(first, last), std::max(first, last));
}

void CellMarks::MarkRows(int y, std::int64_t x, std::int64_t slope, int rows) {
  constexpr std::int64_t kStrip = std::int64_t{kBlockWidth} << kFraction;
  while (rows > 0) {
    const unsigned strip = StripAt(x);
    const std::int64_t inside = x % kStrip;
    const std::int64_t fitting =
        slope < 0 ? inside / -slope
                  : (slope > 0 ? (kStrip - 1 - inside) / slope : rows);
    const int count = static_cast<int>(std::min<std::int64_t>(rows, fitting));
    MarkRowsOfStrip(At(strip, y), std::min(x, x + slope),
                    std::max(x, x + slope), slope, count);
    y += count;
    x += count * slope;
    rows -= count;
    if (rows == 0) return;
    // The row in which the line changes strips.
    MarkRun(y, x >> kFraction, (x + slope) >> kFraction);
    ++y;
    x += slope;
    --rows;
  }
}

int CellMarks::OpenRowsOfStrip(int y, std::int64_t x, std::int64_t slope,
                               int rows) const {
  const unsigned strip = StripAt(x);
  int count = std::min(rows, RowsToBlockEnd(y));
  while (count < rows) {
    const int more = std::min(rows - count, kBlockHeight);
    if (StripAt(x + (count + more) * slope) != strip) break;
    if (IsClosed(y + count, strip, strip)) break;
    count += more;
  }
  return count;
}

void CellMarks::MarkBetween(const RowCrossings& line) {
  int rows = line.count - 1;
  const bool is_upward = line.step > 0;
  int y = is_upward ? line.y + 1 : line.y - rows;
  std::int64_t x = is_upward ? line.x : line.x + rows * line.next;
  const std::int64_t slope = line.step * line.next;
  while (rows > 0) {
    int count = std::min(rows, RowsToBlockEnd(y));
    const std::int64_t end = x + count * slope;
    const unsigned first = StripAt(std::min(x, end));
    const unsigned last = StripAt(std::max(x, end));
    const bool is_closed = IsClosed(y, first, last);
    if (!is_closed && first == last) {
      count = OpenRowsOfStrip(y, x, slope, rows);
      MarkRowsOfStrip(At(first, y), std::min(x, x + slope),
                      std::max(x, x + slope), slope, count);
    } else if (!is_closed) {
      MarkRows(y, x, slope, count);
    }
    y += count;
    x += count * slope;
    rows -= count;
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
  MarkBetween(line);
  const std::int64_t last = line.x + (line.count - 1) * line.next;
  MarkRun(line.y + line.count * line.step, last >> kFraction, line.last_column);
}

}  // namespace vfh_astar
