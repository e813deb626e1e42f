#include "vfh_astar/mapping/map_agreement.h"

#include <cmath>

#include "vfh_astar/grid/ray_traversal.h"

namespace vfh_astar {
namespace {

bool IsOccupied(const LogOddsGrid& map, const Cell& cell) {
  return map.geometry().Contains(cell) && map[cell] > kEvenOdds;
}

bool HasOccupiedNear(const LogOddsGrid& map, const Cell& cell, int reach) {
  for (int y = cell.y - reach; y <= cell.y + reach; ++y) {
    for (int x = cell.x - reach; x <= cell.x + reach; ++x) {
      if (IsOccupied(map, {x, y})) return true;
    }
  }
  return false;
}

/// True when the line from the laser to the hit meets something occupied before
/// its last `reach` m.
bool Pierces(const LogOddsGrid& map, const Eigen::Vector2d& laser,
             const Eigen::Vector2d& hit, double reach) {
  const Eigen::Vector2d way = hit - laser;
  const double length = way.norm();
  if (length <= reach) return false;
  const Eigen::Vector2d end = hit - reach / length * way;
  return !TraverseCells(
      ToCellUnits(map.geometry(), laser), ToCellUnits(map.geometry(), end),
      [&map](const Cell& cell) { return !IsOccupied(map, cell); });
}

}  // namespace

MapAgreement CompareWithMap(const LogOddsGrid& map,
                            const std::vector<Eigen::Vector2d>& points,
                            const Eigen::Vector2d& laser, const Pose2D& pose,
                            double reach) {
  const GridGeometry& geometry = map.geometry();
  const int cells = static_cast<int>(std::ceil(reach / geometry.resolution));
  const Eigen::Vector2d from = pose * laser;
  MapAgreement agreement;
  for (const Eigen::Vector2d& point : points) {
    const Eigen::Vector2d hit = pose * point;
    const Cell cell = geometry.ToCell(hit);
    const bool is_near = HasOccupiedNear(map, cell, cells);
    const bool pierces = !is_near && Pierces(map, from, hit, reach);
    const bool is_explored =
        geometry.Contains(cell) && map[cell] != kUnexplored;
    agreement.known += is_near || pierces || is_explored ? 1 : 0;
    agreement.near += is_near ? 1 : 0;
    agreement.pierced += pierces ? 1 : 0;
  }
  return agreement;
}

}  // namespace vfh_astar
