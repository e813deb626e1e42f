#ifndef VFH_ASTAR_PLANNING_KNOWN_PATH_H_
#define VFH_ASTAR_PLANNING_KNOWN_PATH_H_

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "vfh_astar/planning/cost_map.h"
#include "vfh_astar/planning/passage_check.h"

namespace vfh_astar {

struct KnownPath {
  std::vector<Cell> cells;
  StepCost cost = 0;
};

/// What is left of a path planned earlier, on the map as it is now: straight
/// from the start's cell to the nearest cell of the path, then along it.
/// @param[in] previous points of the map's frame, successive ones in the same
///   cell or in neighbouring ones.
/// @return nothing when the path no longer ends in the goal's cell or a step of
///   it is no longer open.
std::optional<KnownPath> FollowPath(
    const std::vector<Eigen::Vector2d>& previous, const Cell& start,
    const Cell& goal, const CostMap& costs, const PassageCheck& passages);

}  // namespace vfh_astar

#endif  // VFH_ASTAR_PLANNING_KNOWN_PATH_H_
