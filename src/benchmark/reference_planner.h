#ifndef VFH_ASTAR_BENCHMARK_REFERENCE_PLANNER_H_
#define VFH_ASTAR_BENCHMARK_REFERENCE_PLANNER_H_

#include "vfh_astar/grid/clearance.h"
#include "vfh_astar/planning/cost_map.h"
#include "vfh_astar/planning/path_planner.h"

namespace vfh_astar {

/// What a PathPlanner's answer should cost, by Dijkstra's algorithm.
class ReferencePlanner {
 public:
  ReferencePlanner(const PathPlannerParameters& parameters,
                   const OccupancyGrid& map);

  /// @param[in] request whose start and goal lie within the map.
  /// @return m, weighted; infinite when there is no path.
  double Cost(const PlanRequest& request);

 private:
  PathPlannerParameters parameters_;
  ClearanceMap clearance_;
  CostMap costs_;
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_BENCHMARK_REFERENCE_PLANNER_H_
