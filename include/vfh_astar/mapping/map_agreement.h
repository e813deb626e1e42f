#ifndef VFH_ASTAR_MAPPING_MAP_AGREEMENT_H_
#define VFH_ASTAR_MAPPING_MAP_AGREEMENT_H_

#include <Eigen/Core>
#include <vector>

#include "vfh_astar/geometry.h"
#include "vfh_astar/mapping/log_odds_grid.h"

namespace vfh_astar {

/// What a map says of a scan's hits.
struct MapAgreement {
  int known = 0;    ///< hits of which the map says something: of these
  int near = 0;     ///< so many lie at something occupied,
  int pierced = 0;  ///< and so many lie behind something occupied.

  /// 0 to 1; something new in front of the walls makes hits that are not near,
  /// but only a wrong pose, or walls that are gone, make hits pierce walls.
  double near_share() const { return Share(near); }
  double pierced_share() const { return Share(pierced); }

 private:
  double Share(int part) const {
    return known > 0 ? static_cast<double>(part) / known : 0.0;
  }
};

/// Compares hits with a map.
/// @param[in] points m, in the base's frame.
/// @param[in] laser where they were seen from, likewise.
/// @param[in] pose of the base in the map's frame.
/// @param[in] reach m within which an occupied cell explains a hit; a hit has
///   to lie farther than this behind one to pierce it.
MapAgreement CompareWithMap(const LogOddsGrid& map,
                            const std::vector<Eigen::Vector2d>& points,
                            const Eigen::Vector2d& laser, const Pose2D& pose,
                            double reach);

}  // namespace vfh_astar

#endif  // VFH_ASTAR_MAPPING_MAP_AGREEMENT_H_
