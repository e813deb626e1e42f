#include "vfh_astar/mapping/log_odds_grid.h"

#include <algorithm>
#include <cmath>

namespace vfh_astar {
namespace {

// A jump of the map's size makes everybody take the whole map anew, so it is
// made seldom and large: 12.8 m at 0.05 m per cell.
constexpr int kGrowthStep = 4 * LogOddsGrid::kTileSize;

int DivideUp(int numerator, int denominator) {
  return (numerator + denominator - 1) / denominator;
}

/// Cells to add so that `missing` fit in, within what may still be added.
int Growth(int missing, int allowed) {
  if (missing <= 0) return 0;
  const int wanted = missing < allowed
                         ? DivideUp(missing, kGrowthStep) * kGrowthStep
                         : allowed;
  return std::min(wanted, allowed) / LogOddsGrid::kTileSize *
         LogOddsGrid::kTileSize;
}

}  // namespace

LogOdds ToLogOdds(double probability) {
  assert(0.0 < probability && probability < 1.0);
  const double steps =
      std::log(probability / (1.0 - probability)) / kLogOddsStep;
  return static_cast<LogOdds>(
      std::clamp(std::lround(steps) + kEvenOdds, 1L, 255L));
}

double ToProbability(LogOdds value) {
  if (value == kUnexplored) return -1.0;
  return 1.0 / (1.0 + std::exp(-kLogOddsStep * (value - kEvenOdds)));
}

std::int8_t ToOccupancy(LogOdds value) {
  if (value == kUnexplored) return kUnknown;
  return static_cast<std::int8_t>(std::lround(100.0 * ToProbability(value)));
}

LogOdds FromOccupancy(std::int8_t occupancy) {
  if (occupancy == kUnknown) return kUnexplored;
  return ToLogOdds(std::clamp(occupancy / 100.0, 0.002, 0.998));
}

LogOddsGrid::LogOddsGrid(const GridGeometry& geometry)
    : geometry_(geometry),
      tile_columns_(DivideUp(geometry.width, kTileSize)),
      tile_rows_(DivideUp(geometry.height, kTileSize)),
      tiles_(static_cast<std::size_t>(tile_columns_) * tile_rows_) {}

LogOddsGrid::Tile& LogOddsGrid::MutableTile(int column, int row) {
  std::shared_ptr<Tile>& tile = tiles_[TileIndex(column, row)];
  if (!tile) {
    tile = std::make_shared<Tile>();
    tile->fill(kUnexplored);
  } else if (tile.use_count() > 1) {
    tile = std::make_shared<Tile>(*tile);
  }
  return *tile;
}

Cell LogOddsGrid::GrowToHold(const cv::Rect& cells) {
  const int spare_width = kMaxSide - geometry_.width;
  const int spare_height = kMaxSide - geometry_.height;
  // Whole tiles at the lower left keep the tiles' own borders in place.
  const int left = Growth(-cells.x, spare_width);
  const int below = Growth(-cells.y, spare_height);
  const int right = Growth(cells.br().x - geometry_.width, spare_width - left);
  const int above =
      Growth(cells.br().y - geometry_.height, spare_height - below);
  if (left == 0 && below == 0 && right == 0 && above == 0) return {};

  GridGeometry grown = geometry_;
  grown.width += left + right;
  grown.height += below + above;
  grown.origin -= geometry_.resolution * Eigen::Vector2d(left, below);
  LogOddsGrid larger(grown);
  for (int row = 0; row < tile_rows_; ++row) {
    for (int column = 0; column < tile_columns_; ++column) {
      larger.tiles_[larger.TileIndex(column + left / kTileSize,
                                     row + below / kTileSize)] =
          std::move(tiles_[TileIndex(column, row)]);
    }
  }
  *this = std::move(larger);
  return {left, below};
}

}  // namespace vfh_astar
