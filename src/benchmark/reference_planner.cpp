#include "benchmark/reference_planner.h"

#include <functional>
#include <limits>
#include <queue>
#include <tuple>
#include <vector>

#include "vfh_astar/planning/passage_check.h"
#include "vfh_astar/planning/start_clearing.h"

namespace vfh_astar {

ReferencePlanner::ReferencePlanner(const PathPlannerParameters& parameters,
                                   const OccupancyGrid& map)
    : parameters_(parameters),
      clearance_(parameters.occupied_threshold, ClearanceReach(parameters)),
      costs_(CostModelFor(parameters)) {
  clearance_.SetMap(map);
  costs_.SetMap(clearance_);
}

double ReferencePlanner::Cost(const PlanRequest& request) {
  using Sum = std::uint64_t;
  using Entry = std::tuple<Sum, int, int>;
  const GridGeometry& geometry = clearance_.geometry();
  const StartClearing clearing(parameters_.footprint, request.start, clearance_,
                               costs_);
  const PassageCheck passages(PassageFootprint(parameters_), request.start,
                              clearance_);
  const Cell start = geometry.ToCell(request.start.position());
  const Cell goal = geometry.ToCell(request.goal.position());
  Grid<Sum> sums(geometry, std::numeric_limits<Sum>::max());
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  sums[start] = 0;
  open.emplace(0, start.x, start.y);
  while (!open.empty()) {
    const auto [sum, x, y] = open.top();
    open.pop();
    const Cell cell{x, y};
    if (sum > sums[cell]) continue;
    if (cell == goal) return sum * (geometry.resolution / kFreeStep);
    for (int direction = 0; direction < kDirections; ++direction) {
      if (!costs_.IsOpen(cell, direction)) continue;
      const Cell next{x + kSteps[direction].x, y + kSteps[direction].y};
      if (!passages.Fits(next, direction)) continue;
      const Sum to = sum + CostOfStep(costs_[cell], costs_[next], direction);
      if (to >= sums[next]) continue;
      sums[next] = to;
      open.emplace(to, next.x, next.y);
    }
  }
  return std::numeric_limits<double>::infinity();
}

}  // namespace vfh_astar
