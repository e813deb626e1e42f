#include "vfh_astar/planning/known_path.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace vfh_astar {
namespace {

int SquaredDistance(const Cell& a, const Cell& b) {
  return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y);
}

/// The direction of a step between neighbours, or -1.
int DirectionBetween(const Cell& from, const Cell& to) {
  const Cell step{to.x - from.x, to.y - from.y};
  const auto found = std::find(kSteps.begin(), kSteps.end(), step);
  return found == kSteps.end() ? -1 : static_cast<int>(found - kSteps.begin());
}

/// Appends the cells of a straight line after the first one.
void AppendLine(const Cell& from, const Cell& to, std::vector<Cell>& cells) {
  const int steps = std::max(std::abs(to.x - from.x), std::abs(to.y - from.y));
  for (int i = 1; i <= steps; ++i) {
    const double part = static_cast<double>(i) / steps;
    cells.push_back(
        {from.x + static_cast<int>(std::lround(part * (to.x - from.x))),
         from.y + static_cast<int>(std::lround(part * (to.y - from.y)))});
  }
}

}  // namespace

std::optional<KnownPath> FollowPath(
    const std::vector<Eigen::Vector2d>& previous, const Cell& start,
    const Cell& goal, const CostMap& costs, const PassageCheck& passages) {
  std::vector<Cell> old;
  for (const Eigen::Vector2d& point : previous) {
    const Cell cell = costs.geometry().ToCell(point);
    if (!costs.geometry().Contains(cell)) return std::nullopt;
    if (old.empty() || old.back() != cell) old.push_back(cell);
  }
  if (old.empty() || old.back() != goal) return std::nullopt;
  const auto nearest = std::min_element(
      old.begin(), old.end(), [&start](const Cell& a, const Cell& b) {
        return SquaredDistance(a, start) < SquaredDistance(b, start);
      });

  KnownPath path;
  path.cells = {start};
  AppendLine(start, *nearest, path.cells);
  path.cells.insert(path.cells.end(), nearest + 1, old.end());
  const int tight_level = passages.TightLevel(costs);
  for (std::size_t i = 1; i < path.cells.size(); ++i) {
    const Cell& from = path.cells[i - 1];
    const Cell& to = path.cells[i];
    const int direction = DirectionBetween(from, to);
    if (direction < 0 || !costs.IsOpen(from, direction)) return std::nullopt;
    if (costs[to] >= tight_level && !passages.Fits(to, direction)) {
      return std::nullopt;
    }
    path.cost += CostOfStep(costs[from], costs[to], direction);
  }
  return path;
}

}  // namespace vfh_astar
