#include "vfh_astar/planning/start_clearing.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace vfh_astar {
namespace {

/// The cells of the map around a footprint.
cv::Rect WindowAround(const Footprint& footprint, const Pose2D& start,
                      const GridGeometry& geometry) {
  Eigen::AlignedBox2d box(start.position());
  for (const Eigen::Vector2d& corner : footprint.Corners()) {
    box.extend(start * corner);
  }
  const Cell low = geometry.ToCell(box.min());
  const Cell high = geometry.ToCell(box.max());
  return cv::Rect(low.x, low.y, high.x - low.x + 1, high.y - low.y + 1) &
         geometry.Bounds();
}

/// The cells of a window whose centres lie in the footprint.
std::vector<Cell> CellsUnder(const Footprint& footprint, const Pose2D& start,
                             const GridGeometry& geometry,
                             const cv::Rect& window) {
  const Pose2D to_robot = start.Inverse();
  // A robot smaller than a cell stands on one all the same.
  const Cell centre = geometry.ToCell(start.position());
  std::vector<Cell> cells;
  for (int y = window.y; y < window.br().y; ++y) {
    for (int x = window.x; x < window.br().x; ++x) {
      const Cell cell{x, y};
      if (cell == centre ||
          footprint.Contains(to_robot * geometry.ToWorld(cell))) {
        cells.push_back(cell);
      }
    }
  }
  return cells;
}

}  // namespace

StartClearing::StartClearing(const Footprint& footprint, const Pose2D& start,
                             ClearanceMap& clearance, CostMap& costs)
    : clearance_(clearance),
      costs_(costs),
      window_(WindowAround(footprint, start, clearance.geometry())) {
  const std::vector<Cell> standing =
      CellsUnder(footprint, start, clearance.geometry(), window_);
  const auto is_occupied = [&](const Cell& cell) {
    return clearance.IsOccupied(cell);
  };
  if (std::any_of(standing.begin(), standing.end(), is_occupied)) {
    for (int y = window_.y; y < window_.br().y; ++y) {
      for (int x = window_.x; x < window_.br().x; ++x) {
        values_.push_back(clearance.map()[{x, y}]);
      }
    }
    std::vector<std::int8_t> cleared = values_;
    for (const Cell& cell : standing) {
      if (!is_occupied(cell)) continue;
      cleared[(cell.y - window_.y) * window_.width + cell.x - window_.x] = 0;
    }
    SetValues(cleared);
  }
  for (const Cell& cell : standing) {
    if (!costs.IsLethal(cell)) continue;
    levels_.push_back({cell, costs[cell]});
    costs.Set(cell, CostMap::kMaxLevel);
  }
}

StartClearing::~StartClearing() {
  for (const Replaced& replaced : levels_) {
    costs_.Set(replaced.cell, replaced.level);
  }
  if (!values_.empty()) SetValues(values_);
}

void StartClearing::SetValues(const std::vector<std::int8_t>& values) {
  for (const cv::Rect& changed : clearance_.Update(window_, values)) {
    costs_.Update(clearance_, changed);
  }
}

}  // namespace vfh_astar
