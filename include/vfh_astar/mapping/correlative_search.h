#ifndef VFH_ASTAR_MAPPING_CORRELATIVE_SEARCH_H_
#define VFH_ASTAR_MAPPING_CORRELATIVE_SEARCH_H_

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "vfh_astar/geometry.h"
#include "vfh_astar/mapping/hit_field.h"

namespace vfh_astar {

/// Where a scan is looked for, around a pose that is thought likely.
struct SearchWindow {
  double linear = 0.5;         ///< m to all four sides.
  double angular = 0.4;        ///< rad to both sides.
  double angular_step = 0.01;  ///< rad
  /// What a candidate loses per squared distance (m^-2, rad^-2) from the centre
  /// of the window, so that of equal ones (a corridor) the likely one wins.
  double linear_penalty = 0.0;
  double angular_penalty = 0.0;
};

struct SearchResult {
  Pose2D pose;
  double score = 0.0;  ///< the mean of the field at the points' cells, 0 to 1.
  double value = 0.0;  ///< the score less the penalties.
};

/// Looks for the pose at which a scan fits a field best, among all poses of a
/// window: shifts of the centre by whole cells, and turns by whole steps.
/// Exact, by branch and bound over maxima of the field (Olson, "Real-time
/// correlative scan matching", ICRA 2009; Hess et al., "Real-time loop closure
/// in 2D lidar SLAM", ICRA 2016).
/// @param[in] points m, in the scan's frame.
/// @param[in] centre the scan's likely pose.
/// @param[in] min_value nothing with a smaller value is wanted.
/// @return nothing when there is none.
std::optional<SearchResult> SearchPose(
    const HitField& field, const std::vector<Eigen::Vector2d>& points,
    const Pose2D& centre, const SearchWindow& window, double min_value);

}  // namespace vfh_astar

#endif  // VFH_ASTAR_MAPPING_CORRELATIVE_SEARCH_H_
