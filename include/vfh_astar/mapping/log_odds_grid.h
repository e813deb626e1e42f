#ifndef VFH_ASTAR_MAPPING_LOG_ODDS_GRID_H_
#define VFH_ASTAR_MAPPING_LOG_ODDS_GRID_H_

#include <array>
#include <cassert>
#include <cstdint>
#include <memory>
#include <opencv2/core/types.hpp>
#include <vector>

#include "vfh_astar/grid/grid.h"

namespace vfh_astar {

/// Log-odds of occupancy in one byte: 0 is unexplored, 128 is even odds, and
/// one step is kStep.
using LogOdds = std::uint8_t;
inline constexpr LogOdds kUnexplored = 0;
inline constexpr LogOdds kEvenOdds = 128;
inline constexpr double kLogOddsStep = 0.05;  ///< nats; +-6.35 at most.

/// The log-odds value nearest to a probability within (0, 1).
LogOdds ToLogOdds(double probability);

/// 0 to 1, or -1 for unexplored.
double ToProbability(LogOdds value);

/// As published: 0 to 100 percent, or kUnknown.
std::int8_t ToOccupancy(LogOdds value);

/// The value that ToOccupancy takes back to the same percentage, or to one
/// beside it where the steps are too coarse; 0, 100 and kUnknown come back
/// exactly.
LogOdds FromOccupancy(std::int8_t occupancy);

/// A map of log-odds in square tiles. A tile exists once a cell of it has been
/// explored; a growing map moves no tile, only the table of them. Copies share
/// their tiles until one of them writes.
class LogOddsGrid {
 public:
  static constexpr int kTileSize = 64;  ///< cells per side.

  /// Values row by row from the lower left.
  using Tile = std::array<LogOdds, kTileSize * kTileSize>;

  LogOddsGrid() = default;
  explicit LogOddsGrid(const GridGeometry& geometry);

  const GridGeometry& geometry() const { return geometry_; }

  /// @param[in] cell within the grid.
  LogOdds operator[](const Cell& cell) const {
    assert(geometry_.Contains(cell));
    const Tile* tile = FindTile(cell.x / kTileSize, cell.y / kTileSize);
    return tile ? (*tile)[Offset(cell)] : kUnexplored;
  }

  void Set(const Cell& cell, LogOdds value) {
    assert(geometry_.Contains(cell));
    MutableTile(cell.x / kTileSize, cell.y / kTileSize)[Offset(cell)] = value;
  }

  /// 0 to 1, or -1 for a cell that is unexplored or outside the grid.
  double Probability(const Cell& cell) const {
    return geometry_.Contains(cell) ? ToProbability((*this)[cell]) : -1.0;
  }

  /// Makes the grid hold a rectangle of cells (in its present cells; negative
  /// ones lie beyond the origin). Grows in large steps, to kMaxSide cells per
  /// side at most; what lies farther out stays outside.
  /// @return cells that were added to the left and below: what to add to an
  ///   old cell to get its new name. The geometry is unchanged when the
  ///   rectangle was held already.
  Cell GrowToHold(const cv::Rect& cells);
  static constexpr int kMaxSide = 16384;

  /// The tile in a column and row of tiles, or null while nothing in it is
  /// explored.
  const Tile* FindTile(int column, int row) const {
    return tiles_[TileIndex(column, row)].get();
  }

  /// The same for writing; makes it when there is none.
  Tile& MutableTile(int column, int row);

  static std::size_t Offset(const Cell& cell) {
    return static_cast<std::size_t>(cell.y % kTileSize) * kTileSize +
           cell.x % kTileSize;
  }

  int tile_columns() const { return tile_columns_; }
  int tile_rows() const { return tile_rows_; }

 private:
  std::size_t TileIndex(int column, int row) const {
    assert(0 <= column && column < tile_columns_);
    assert(0 <= row && row < tile_rows_);
    return static_cast<std::size_t>(row) * tile_columns_ + column;
  }

  GridGeometry geometry_;
  int tile_columns_ = 0;
  int tile_rows_ = 0;
  std::vector<std::shared_ptr<Tile>> tiles_;
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_MAPPING_LOG_ODDS_GRID_H_
