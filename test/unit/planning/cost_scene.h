#ifndef VFH_ASTAR_TEST_UNIT_PLANNING_COST_SCENE_H_
#define VFH_ASTAR_TEST_UNIT_PLANNING_COST_SCENE_H_

#include <gtest/gtest.h>

#include <limits>
#include <set>
#include <tuple>

#include "vfh_astar/footprint.h"
#include "vfh_astar/grid/clearance.h"
#include "vfh_astar/planning/cost_map.h"
#include "vfh_astar/planning/passage_check.h"
#include "vfh_astar/planning/search_result.h"

namespace vfh_astar {

inline ClearanceMap ClearanceOf(const OccupancyGrid& map) {
  ClearanceMap clearance(65, 3.0);
  clearance.SetMap(map);
  return clearance;
}

/// What a search needs to know.
struct Scene {
  Scene(const OccupancyGrid& map, const CostModel& model,
        const Footprint& footprint)
      : clearance(ClearanceOf(map)),
        costs(model),
        passages(footprint, {-100.0, -100.0, 0.0}, clearance) {
    costs.SetMap(clearance);
  }

  ClearanceMap clearance;
  CostMap costs;
  PassageCheck passages;
};

inline const Footprint kSmall{0.1, 0.1, 0.1};

inline CostModel Uniform() {
  CostModel model;
  model.lethal_clearance = 0.5;
  model.weight = 1.0;
  return model;
}

/// Dijkstra's algorithm as in the textbook.
inline StepCost Dijkstra(const Scene& scene, const Cell& start,
                         const Cell& goal) {
  constexpr StepCost kNone = std::numeric_limits<StepCost>::max();
  Grid<StepCost> costs(scene.costs.geometry(), kNone);
  std::set<std::tuple<StepCost, int, int>> open = {{0, start.x, start.y}};
  costs[start] = 0;
  while (!open.empty()) {
    const auto [cost, x, y] = *open.begin();
    open.erase(open.begin());
    for (int direction = 0; direction < kDirections; ++direction) {
      const Cell next{x + kSteps[direction].x, y + kSteps[direction].y};
      if (!scene.costs.IsOpen({x, y}, direction)) continue;
      if (!scene.passages.Fits(next, direction)) continue;
      const StepCost sum =
          cost + CostOfStep(scene.costs[{x, y}], scene.costs[next], direction);
      if (sum >= costs[next]) continue;
      open.erase({costs[next], next.x, next.y});
      costs[next] = sum;
      open.emplace(sum, next.x, next.y);
    }
  }
  return costs[goal];
}

/// A cost that is really that of the path, along open steps.
inline void ExpectValidPath(const Scene& scene, const SearchResult& result) {
  StepCost sum = 0;
  for (std::size_t i = 1; i < result.cells.size(); ++i) {
    const Cell& from = result.cells[i - 1];
    const Cell& to = result.cells[i];
    int direction = 0;
    while (direction < kDirections &&
           kSteps[direction] != Cell{to.x - from.x, to.y - from.y}) {
      ++direction;
    }
    ASSERT_LT(direction, kDirections);
    EXPECT_TRUE(scene.costs.IsOpen(from, direction));
    EXPECT_TRUE(scene.passages.Fits(to, direction));
    sum += CostOfStep(scene.costs[from], scene.costs[to], direction);
  }
  EXPECT_EQ(sum, result.cost);
}

}  // namespace vfh_astar

#endif  // VFH_ASTAR_TEST_UNIT_PLANNING_COST_SCENE_H_
