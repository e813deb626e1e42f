#ifndef VFH_ASTAR_PLANNING_BIT_GRID_H_
#define VFH_ASTAR_PLANNING_BIT_GRID_H_

#include <cstddef>
#include <cstdint>
#include <vector>

namespace vfh_astar {

/// A bit per cell, in words along x, with a border of set bits one cell wide.
/// Columns and rows below count the border: cell (x, y) is at (x + 1, y + 1).
class BitGrid {
 public:
  BitGrid() = default;

  /// All bits within the border are clear.
  BitGrid(int width, int height)
      : words_((static_cast<std::size_t>(width) + 2 + 63) / 64),
        rows_(words_ * (static_cast<std::size_t>(height) + 2), 0) {
    for (int x = 0; x < width + 2; ++x) {
      Set(x, 0, true);
      Set(x, height + 1, true);
    }
    for (int y = 0; y < height + 2; ++y) {
      Set(0, y, true);
      // What is left of the last word is border too.
      for (int x = width + 1; x < static_cast<int>(words_) * 64; ++x) {
        Set(x, y, true);
      }
    }
  }

  bool Test(int x, int y) const {
    return (Row(y)[x / 64] >> (x % 64) & 1) != 0;
  }

  void Set(int x, int y, bool value) {
    std::uint64_t& word = rows_[y * words_ + x / 64];
    const std::uint64_t bit = std::uint64_t{1} << (x % 64);
    word = value ? word | bit : word & ~bit;
  }

  const std::uint64_t* Row(int y) const { return rows_.data() + y * words_; }

 private:
  std::size_t words_ = 0;
  std::vector<std::uint64_t> rows_;
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_PLANNING_BIT_GRID_H_
