#ifndef VFH_ASTAR_MAPPING_SCAN_MATCHER_H_
#define VFH_ASTAR_MAPPING_SCAN_MATCHER_H_

#include <Eigen/Core>
#include <vector>

#include "vfh_astar/geometry.h"
#include "vfh_astar/laser_scan.h"
#include "vfh_astar/mapping/hit_field.h"
#include "vfh_astar/mapping/scan_alignment.h"
#include "vfh_astar/parameters.h"

namespace vfh_astar {

/// A scan as SLAM keeps it, in m, in the frame of the base.
struct ScanShape {
  std::vector<Eigen::Vector2d> probes;  ///< what is matched against a field.
  std::vector<Eigen::Vector2d> walls;   ///< what is put into one.
};

struct ScanMatcherParameters {
  double max_range = 20.0;     ///< m; farther hits are not matched.
  double point_spacing = 0.1;  ///< m between the points kept of a scan.
  double resolution = 0.05;    ///< m per cell of a field.
  double sigma = 0.05;         ///< m, of a hit in a field.
  double gain = 0.5;           ///< what a hit adds, of what is missing to 1.
  /// Nats that a point on a wall is better than one far from all. Less than
  /// sigma over the laser's noise, squared, would give, as neighbours err
  /// alike.
  double point_weight = 0.5;
  double linear_window = 0.5;   ///< m to each side, of the coarse search.
  double angular_window = 0.4;  ///< rad to each side.
  double angular_step = 0.01;   ///< rad

  void Read(ParameterReader& reader);
};

/// Finds where scans fit into fields: coarse by exhaustive correlation, then
/// fine by the gradient. Holds no state but its parameters.
class ScanMatcher {
 public:
  explicit ScanMatcher(const ScanMatcherParameters& parameters)
      : parameters_(parameters) {}

  const ScanMatcherParameters& parameters() const { return parameters_; }

  /// A field without hits.
  HitField MakeField() const {
    return HitField(parameters_.resolution, parameters_.sigma,
                    parameters_.gain);
  }

  /// The hits of a scan that count. The probes are thinned, so that a near wall
  /// does not outvote a far one. The walls have points at even distances, also
  /// between neighbouring hits on one surface (see IsOneSurface): else the next
  /// scan would be drawn to where this one's beams happened to fall.
  /// @param[in] base_from_laser the laser in the base's frame.
  ScanShape Shape(const LaserScan& scan, const Pose2D& base_from_laser) const;

  /// The coarse search around where odometry leads.
  /// @param[in] prior its information bounds how far a match may lie.
  /// @return the prior's mean when nothing fits.
  Pose2D FindCoarse(const HitField& field,
                    const std::vector<Eigen::Vector2d>& points,
                    const PoseBelief& prior) const;

  /// From a start that is right to about a cell to the best place near it.
  Alignment Align(const HitField& field,
                  const std::vector<Eigen::Vector2d>& points,
                  const Pose2D& start, const PoseBelief& prior) const {
    return AlignScan(field, points, start, prior, parameters_.point_weight,
                     parameters_.sigma);
  }

 private:
  ScanMatcherParameters parameters_;
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_MAPPING_SCAN_MATCHER_H_
