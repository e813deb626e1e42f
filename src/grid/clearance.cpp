#include "vfh_astar/grid/clearance.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

namespace vfh_astar {
namespace {

// The distance transform is worked out in blocks: its single-precision
// intersections are exact only while squared lengths stay far below 2^24.
constexpr int kBlock = 256;

// Changes are gathered in tiles, so that a few flipped cells far apart do not
// recompute all that lies between them.
constexpr int kTile = 32;

int DivideUp(int numerator, int denominator) {
  return (numerator + denominator - 1) / denominator;
}

cv::Rect Grow(const cv::Rect& rect, int cells) {
  return {rect.x - cells, rect.y - cells, rect.width + 2 * cells,
          rect.height + 2 * cells};
}

}  // namespace

/// Tiles of a grid that need recomputing.
class ClearanceMap::TileSet {
 public:
  explicit TileSet(const cv::Rect& bounds)
      : bounds_(bounds),
        columns_(DivideUp(bounds.width, kTile)),
        rows_(DivideUp(bounds.height, kTile)),
        marked_(static_cast<std::size_t>(columns_) * rows_, 0) {}

  /// Marks every tile that the cells of a rectangle lie in.
  void Mark(const cv::Rect& cells) {
    const cv::Rect inside = cells & bounds_;
    if (inside.empty()) return;
    for (int y = inside.y / kTile; y <= (inside.br().y - 1) / kTile; ++y) {
      for (int x = inside.x / kTile; x <= (inside.br().x - 1) / kTile; ++x) {
        marked_[static_cast<std::size_t>(y) * columns_ + x] = 1;
      }
    }
  }

  /// The marked tiles as few rectangles of cells: runs along a row of tiles,
  /// joined with an equal run below.
  std::vector<cv::Rect> Rectangles() const {
    std::vector<cv::Rect> runs;
    for (int y = 0; y < rows_; ++y) {
      for (int x = 0; x < columns_; ++x) {
        if (!IsMarked(x, y)) continue;
        const int first = x;
        while (x < columns_ && IsMarked(x, y)) ++x;
        Append({first, y, x - first, 1}, runs);
      }
    }
    for (cv::Rect& run : runs) {
      run = cv::Rect(run.x * kTile, run.y * kTile, run.width * kTile,
                     run.height * kTile) &
            bounds_;
    }
    return runs;
  }

 private:
  bool IsMarked(int x, int y) const {
    return marked_[static_cast<std::size_t>(y) * columns_ + x] != 0;
  }

  static void Append(const cv::Rect& run, std::vector<cv::Rect>& runs) {
    for (cv::Rect& above : runs) {
      if (above.x == run.x && above.width == run.width &&
          above.br().y == run.y) {
        ++above.height;
        return;
      }
    }
    runs.push_back(run);
  }

  cv::Rect bounds_;
  int columns_;
  int rows_;
  std::vector<std::uint8_t> marked_;
};

ClearanceMap::ClearanceMap(int occupied_threshold, double max_distance)
    : occupied_threshold_(occupied_threshold), max_distance_(max_distance) {
  assert(0 < occupied_threshold && occupied_threshold <= 100);
  assert(max_distance > 0.0);
}

int ClearanceMap::Reach() const {
  return static_cast<int>(std::ceil(max_distance_ / geometry().resolution));
}

void ClearanceMap::SetMap(const OccupancyGrid& map) {
  map_ = map;
  distance_ = Grid<float>(map.geometry(), static_cast<float>(max_distance_));
  if (!map.geometry().Bounds().empty()) Recompute(map.geometry().Bounds());
}

std::vector<cv::Rect> ClearanceMap::Update(
    const std::vector<MapWindow>& windows) {
  TileSet dirty(geometry().Bounds());
  for (const MapWindow& window : windows) {
    Enter(window.cells, window.values, dirty);
  }
  return Recompute(dirty);
}

std::vector<cv::Rect> ClearanceMap::Update(
    const cv::Rect& window, const std::vector<std::int8_t>& values) {
  TileSet dirty(geometry().Bounds());
  Enter(window, values, dirty);
  return Recompute(dirty);
}

std::vector<cv::Rect> ClearanceMap::Recompute(const TileSet& dirty) {
  const std::vector<cv::Rect> changed = dirty.Rectangles();
  for (const cv::Rect& rect : changed) Recompute(rect);
  return changed;
}

void ClearanceMap::Enter(const cv::Rect& window,
                         const std::vector<std::int8_t>& values,
                         TileSet& dirty) {
  assert((window & geometry().Bounds()) == window);
  assert(values.size() == static_cast<std::size_t>(window.area()));
  const int reach = Reach();
  auto value = values.begin();
  for (int y = window.y; y < window.br().y; ++y) {
    const auto row = map_.cells().begin() + geometry().Index({0, y});
    int first_flip = window.br().x;
    int last_flip = -1;
    for (int x = window.x; x < window.br().x; ++x, ++value) {
      if ((row[x] >= occupied_threshold_) == (*value >= occupied_threshold_)) {
        continue;
      }
      if (last_flip >= 0 && x - last_flip > kTile) {
        dirty.Mark(Grow({first_flip, y, last_flip - first_flip + 1, 1}, reach));
        first_flip = x;
      }
      first_flip = std::min(first_flip, x);
      last_flip = x;
    }
    std::copy(value - window.width, value, row + window.x);
    if (last_flip >= 0) {
      dirty.Mark(Grow({first_flip, y, last_flip - first_flip + 1, 1}, reach));
    }
  }
}

void ClearanceMap::Recompute(const cv::Rect& window) {
  const float limit = static_cast<float>(max_distance_);
  const float resolution = static_cast<float>(geometry().resolution);
  const cv::Mat map(geometry().height, geometry().width, CV_8S,
                    map_.cells().data());
  cv::Mat distance(geometry().height, geometry().width, CV_32F,
                   distance_.cells().data());
  cv::Mat open;
  cv::Mat cells;
  for (int y = window.y; y < window.br().y; y += kBlock) {
    for (int x = window.x; x < window.br().x; x += kBlock) {
      const cv::Rect block = cv::Rect(x, y, kBlock, kBlock) & window;
      const cv::Rect seen = Grow(block, Reach()) & geometry().Bounds();
      cv::compare(map(seen), occupied_threshold_, open, cv::CMP_LT);
      cv::Mat target = distance(block);
      if (cv::countNonZero(open) == seen.area()) {
        target.setTo(limit);
        continue;
      }
      cv::distanceTransform(open, cells, cv::DIST_L2, cv::DIST_MASK_PRECISE);
      target = cells(block - seen.tl()) * resolution;
      cv::min(target, limit, target);
    }
  }
}

bool ClearanceMap::IsRowFree(const CellRow& row) const {
  if (row.y < 0 || row.y >= geometry().height) return true;
  const float* const clear =
      distance_.cells().data() + geometry().Index({0, row.y});
  const float cells_per_metre = static_cast<float>(1.0 / geometry().resolution);
  const int last = std::min(row.last, geometry().width - 1);
  for (int x = std::max(row.first, 0); x <= last;) {
    if (clear[x] <= 0.0f) return false;
    // No cell nearer than the clearance is occupied: go on where one may be.
    x += std::max(1, static_cast<int>(clear[x] * cells_per_metre + 0.999f));
  }
  return true;
}

bool ClearanceMap::IsFree(const Footprint& footprint, const Pose2D& pose,
                          double margin) const {
  const Footprint grown = footprint.Grown(margin);
  const Cell cell = geometry().ToCell(pose.position());
  const Eigen::Vector2d offset = pose.position() - geometry().ToWorld(cell);
  if (geometry().Contains(cell)) {
    // The clearance holds for the cell's centre, the pose lies off it.
    const double clear = At(cell);
    if (clear - offset.norm() > grown.CircumscribedRadius()) return true;
    const bool is_saturated = clear >= static_cast<float>(max_distance_);
    if (!is_saturated && clear + offset.norm() < grown.InscribedRadius()) {
      return false;
    }
  }
  return VisitFootprintRows(
      grown, {offset, pose.theta}, geometry().resolution,
      [this, &cell](const CellRow& row) {
        return IsRowFree(
            {row.y + cell.y, row.first + cell.x, row.last + cell.x});
      });
}

}  // namespace vfh_astar
