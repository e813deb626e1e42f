#include "vfh_astar/mapping/hit_field.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <opencv2/core/fast_math.hpp>

namespace vfh_astar {
namespace {

constexpr int kTile = HitField::kTileSize;
constexpr int kSpareTiles = 8;  // added at once on a side that grows

int TileOf(int cell) {
  return cell >= 0 ? cell / kTile : -((-cell + kTile - 1) / kTile);
}

std::size_t Offset(int x, int y) {
  static_assert((kTile & (kTile - 1)) == 0, "a mask takes the remainder");
  return static_cast<std::size_t>(y & (kTile - 1)) * kTile + (x & (kTile - 1));
}

/// height * exp(-spread * x^2) at x = first, first + 1, ...
void FillGaussian(double first, double spread, double height, int count,
                  float* values) {
  // From one value to the next by a ratio, which itself shrinks evenly: far
  // fewer exponentials.
  double value = height * std::exp(-spread * first * first);
  double ratio = std::exp(-spread * (2.0 * first + 1.0));
  const double shrink = std::exp(-2.0 * spread);
  for (int i = 0; i < count; ++i) {
    values[i] = static_cast<float>(value);
    value *= ratio;
    ratio *= shrink;
  }
}

}  // namespace

HitField::HitField(double resolution, double sigma, double gain)
    : resolution_(resolution),
      gain_(gain),
      spread_(0.5 * resolution * resolution / (sigma * sigma)),
      reach_(static_cast<int>(std::ceil(2.5 * sigma / resolution))) {
  assert(resolution > 0.0 && sigma > 0.0 && 0.0 < gain && gain <= 1.0);
}

void HitField::Add(const std::vector<Eigen::Vector2d>& points,
                   const Pose2D& pose) {
  const double c = std::cos(pose.theta);
  const double s = std::sin(pose.theta);
  for (const Eigen::Vector2d& point : points) {
    AddHit(Eigen::Vector2d(pose.x + c * point.x() - s * point.y(),
                           pose.y + s * point.x() + c * point.y()) /
               resolution_ -
           Eigen::Vector2d(0.5, 0.5));
  }
}

void HitField::AddHit(const Eigen::Vector2d& at) {
  const int left = static_cast<int>(std::lround(at.x())) - reach_;
  const int below = static_cast<int>(std::lround(at.y())) - reach_;
  const int side = 2 * reach_ + 1;
  constexpr int kLargestSide = 64;
  assert(side <= kLargestSide);
  std::array<float, kLargestSide> along_x;
  std::array<float, kLargestSide> along_y;
  const float gain = static_cast<float>(gain_);
  FillGaussian(left - at.x(), spread_, 1.0, side, along_x.data());
  FillGaussian(below - at.y(), spread_, 255.0, side, along_y.data());
  const cv::Rect tiles(
      cv::Point(TileOf(left), TileOf(below)),
      cv::Point(TileOf(left + side - 1) + 1, TileOf(below + side - 1) + 1));
  GrowToHold(tiles);
  for (int row = tiles.y; row < tiles.br().y; ++row) {
    for (int column = tiles.x; column < tiles.br().x; ++column) {
      Tile& tile = MutableTile(column, row);
      const int first_x = std::max(left, column * kTile);
      const int last_x = std::min(left + side, (column + 1) * kTile);
      const int last_y = std::min(below + side, (row + 1) * kTile);
      for (int y = std::max(below, row * kTile); y < last_y; ++y) {
        std::uint8_t* const cells = &tile[Offset(first_x, y)];
        const float height = along_y[y - below];
        for (int x = first_x; x < last_x; ++x) {
          const float old = cells[x - first_x];
          const float missing = height * along_x[x - left] - old;
          cells[x - first_x] = static_cast<std::uint8_t>(
              old + gain * std::max(0.0f, missing) + 0.5f);
        }
      }
    }
  }
}

int HitField::Value(int x, int y) const {
  const Tile* const tile = FindTile(TileOf(x), TileOf(y));
  return tile ? (*tile)[Offset(x, y)] : 0;
}

HitField::Sample HitField::At(const Eigen::Vector2d& point) const {
  const double u = point.x() / resolution_ - 0.5;
  const double v = point.y() / resolution_ - 0.5;
  const int x = cvFloor(u);
  const int y = cvFloor(v);
  double low_left, low_right, high_left, high_right;
  const bool is_one_tile =
      (x & (kTile - 1)) != kTile - 1 && (y & (kTile - 1)) != kTile - 1;
  if (is_one_tile) {
    const Tile* const tile = FindTile(TileOf(x), TileOf(y));
    if (tile == nullptr) return {};
    const std::uint8_t* const cells = &(*tile)[Offset(x, y)];
    low_left = cells[0];
    low_right = cells[1];
    high_left = cells[kTile];
    high_right = cells[kTile + 1];
  } else {
    low_left = Value(x, y);
    low_right = Value(x + 1, y);
    high_left = Value(x, y + 1);
    high_right = Value(x + 1, y + 1);
  }
  const double right = u - x;
  const double up = v - y;
  const double low = low_left + right * (low_right - low_left);
  const double high = high_left + right * (high_right - high_left);
  constexpr double kUnit = 1.0 / 255.0;
  const double scale = kUnit / resolution_;
  Sample sample;
  sample.value = kUnit * (low + up * (high - low));
  sample.slope.x() = scale * ((1.0 - up) * (low_right - low_left) +
                              up * (high_right - high_left));
  sample.slope.y() = scale * (high - low);
  return sample;
}

std::vector<std::uint8_t> HitField::Values(const cv::Rect& cells) const {
  std::vector<std::uint8_t> values(static_cast<std::size_t>(cells.width) *
                                   cells.height);
  const int last_column = TileOf(cells.br().x - 1);
  for (int y = cells.y; y < cells.br().y; ++y) {
    std::uint8_t* const row =
        values.data() + static_cast<std::size_t>(y - cells.y) * cells.width;
    for (int column = TileOf(cells.x); column <= last_column; ++column) {
      const Tile* const tile = FindTile(column, TileOf(y));
      if (tile == nullptr) continue;
      const int first = std::max(cells.x, column * kTile);
      const int end = std::min(cells.br().x, (column + 1) * kTile);
      const std::uint8_t* const from = &(*tile)[Offset(first, y)];
      std::copy(from, from + (end - first), row + (first - cells.x));
    }
  }
  return values;
}

bool HitField::SharesTile(const HitField& other, int x, int y) const {
  return FindTile(TileOf(x), TileOf(y)) == other.FindTile(TileOf(x), TileOf(y));
}

HitField::Tile& HitField::MutableTile(int column, int row) {
  std::shared_ptr<Tile>& tile =
      table_[static_cast<std::size_t>(row - tiles_.y) * tiles_.width + column -
             tiles_.x];
  if (!tile) {
    tile = std::make_shared<Tile>();
    tile->fill(0);
  } else if (tile.use_count() > 1) {
    tile = std::make_shared<Tile>(*tile);
  }
  return *tile;
}

void HitField::GrowToHold(const cv::Rect& tiles) {
  if (!tiles_.empty() && (tiles & tiles_) == tiles) return;
  cv::Rect grown = tiles;
  if (tiles_.empty()) {
    grown = cv::Rect(tiles.tl() - cv::Point(kSpareTiles, kSpareTiles),
                     tiles.br() + cv::Point(kSpareTiles, kSpareTiles));
  } else {
    const auto lower = [](int old, int wanted) {
      return wanted < old ? wanted - kSpareTiles : old;
    };
    const auto upper = [](int old, int wanted) {
      return wanted > old ? wanted + kSpareTiles : old;
    };
    grown =
        cv::Rect(cv::Point(lower(tiles_.x, tiles.x), lower(tiles_.y, tiles.y)),
                 cv::Point(upper(tiles_.br().x, tiles.br().x),
                           upper(tiles_.br().y, tiles.br().y)));
  }
  std::vector<std::shared_ptr<Tile>> table(
      static_cast<std::size_t>(grown.width) * grown.height);
  for (int y = 0; y < tiles_.height; ++y) {
    const auto row =
        table_.begin() + static_cast<std::size_t>(y) * tiles_.width;
    std::move(
        row, row + tiles_.width,
        table.begin() +
            static_cast<std::size_t>(y + tiles_.y - grown.y) * grown.width +
            (tiles_.x - grown.x));
  }
  tiles_ = grown;
  table_ = std::move(table);
}

}  // namespace vfh_astar
