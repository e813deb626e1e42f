#ifndef VFH_ASTAR_PLANNING_PASSAGE_CHECK_H_
#define VFH_ASTAR_PLANNING_PASSAGE_CHECK_H_

#include <array>
#include <vector>

#include "vfh_astar/footprint.h"
#include "vfh_astar/geometry.h"
#include "vfh_astar/grid/clearance.h"
#include "vfh_astar/planning/cost_map.h"

namespace vfh_astar {

/// Whether the robot's rectangle fits where its circumscribed circle does not.
///
/// A step of the grid stands for headings up to half the angle between two
/// directions to either side of it, since a path at any other angle is a
/// mixture of two directions. The rectangle fits when it does so at one of
/// these headings; a passage too narrow for the rectangle along it is refused.
class PassageCheck {
 public:
  /// @param[in] footprint with what margin is wanted.
  /// @param[in] start the robot's present pose: where it stands it fits.
  /// @param[in] clearance has its map, and outlives this object.
  PassageCheck(const Footprint& footprint, const Pose2D& start,
               const ClearanceMap& clearance);

  /// @param[in] cell where the step ends, within the map.
  /// @param[in] direction of the step, see kSteps.
  bool Fits(const Cell& cell, int direction) const;

  /// Cells of a lower level have room for the circumscribed circle; above
  /// CostMap::kMaxLevel when every cell that is not lethal has.
  int TightLevel(const CostMap& costs) const {
    const double radius = footprint_.CircumscribedRadius();
    if (radius <= costs.model().lethal_clearance) return CostMap::kMaxLevel + 1;
    return costs.LevelOf(radius);
  }

 private:
  /// A cell under the rectangle, from the one under its centre.
  struct Covered {
    Cell offset;
    float distance;  ///< m between the two cells' centres.
  };

  // Headings of a quarter of the angle between two directions.
  static constexpr int kHeadingsPerDirection = 4;
  static constexpr int kHeadings = kDirections * kHeadingsPerDirection;

  bool FitsAt(const Cell& cell, int heading) const;

  Footprint footprint_;
  float circumscribed_radius_;
  PointTransform
      to_robot_;  ///< from the map's frame to that of the robot at the start.
  const ClearanceMap& clearance_;
  /// By heading, over a cell's centre, the farthest cells first.
  std::array<std::vector<Covered>, kHeadings> covered_;
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_PLANNING_PASSAGE_CHECK_H_
