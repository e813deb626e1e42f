#include "vfh_astar/planning/cost_map.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace vfh_astar {
namespace {

// Distances are sums of single-precision roundings; a cell exactly at the
// limit is free.
constexpr double kRounding = 1e-5;

}  // namespace

CostMap::CostMap(const CostModel& model) : model_(model) {
  assert(1.0 <= model.weight && model.weight <= 10.0);
  assert(0.0 <= model.unknown_price && model.unknown_price <= 5.0);
}

CostMap::Level CostMap::LevelOf(double clearance) const {
  if (clearance < model_.lethal_clearance - kRounding) return kLethal;
  const double ramp = model_.inflation_clearance - model_.lethal_clearance;
  if (clearance >= model_.inflation_clearance || ramp <= 0.0) return kUnit;
  const double depth =
      std::min(1.0, (model_.inflation_clearance - clearance) / ramp);
  const double factor = 1.0 + (model_.weight - 1.0) * depth * depth;
  return static_cast<Level>(factor * kUnit + 0.5);
}

void CostMap::SetMap(const ClearanceMap& clearance) {
  geometry_ = clearance.geometry();
  levels_.assign(static_cast<std::size_t>(stride()) * rows(), kLethal);
  Update(clearance, geometry_.Bounds());
}

void CostMap::Update(const ClearanceMap& clearance, const cv::Rect& window) {
  assert(clearance.geometry() == geometry_);
  const auto price =
      static_cast<Level>(std::lround(model_.unknown_price * kUnit));
  for (int y = window.y; y < window.br().y; ++y) {
    std::size_t index = Index({window.x, y});
    for (int x = window.x; x < window.br().x; ++x, ++index) {
      const Cell cell{x, y};
      Level level = LevelOf(clearance.At(cell));
      if (clearance.map()[cell] == kUnknown) {
        if (model_.unknown == UnknownSpace::kForbidden) level = kLethal;
        if (model_.unknown == UnknownSpace::kPriced && level != kLethal) {
          level = static_cast<Level>(std::min(level + price, int{kMaxLevel}));
        }
      }
      levels_[index] = level;
    }
  }
}

bool CostMap::IsOpen(const Cell& cell, int direction) const {
  const Cell step = kSteps[direction];
  if (IsLethal({cell.x + step.x, cell.y + step.y})) return false;
  return direction % 2 == 0 || (!IsLethal({cell.x + step.x, cell.y}) &&
                                !IsLethal({cell.x, cell.y + step.y}));
}

}  // namespace vfh_astar
