#ifndef VFH_ASTAR_PLANNING_START_CLEARING_H_
#define VFH_ASTAR_PLANNING_START_CLEARING_H_

#include <cstdint>
#include <opencv2/core/types.hpp>
#include <vector>

#include "vfh_astar/footprint.h"
#include "vfh_astar/geometry.h"
#include "vfh_astar/grid/clearance.h"
#include "vfh_astar/planning/cost_map.h"

namespace vfh_astar {

/// For as long as it lives, the cells that the robot stands on are passable:
/// what is occupied among them is taken for free, with the clearance around it,
/// and what is lethal has the highest cost. Nothing else is cleared, and all is
/// as before afterwards.
class StartClearing {
 public:
  /// @param[in] footprint of the robot itself, without a margin.
  /// @param[in] start within the map.
  /// @param[in,out] clearance, costs of the same map; outlive this object.
  StartClearing(const Footprint& footprint, const Pose2D& start,
                ClearanceMap& clearance, CostMap& costs);
  ~StartClearing();

  StartClearing(const StartClearing&) = delete;
  StartClearing& operator=(const StartClearing&) = delete;

 private:
  struct Replaced {
    Cell cell;
    CostMap::Level level;
  };

  void SetValues(const std::vector<std::int8_t>& values);

  ClearanceMap& clearance_;
  CostMap& costs_;
  cv::Rect window_;
  std::vector<std::int8_t> values_;  ///< of the window; empty when unchanged.
  std::vector<Replaced> levels_;
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_PLANNING_START_CLEARING_H_
