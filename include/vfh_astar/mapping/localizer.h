#ifndef VFH_ASTAR_MAPPING_LOCALIZER_H_
#define VFH_ASTAR_MAPPING_LOCALIZER_H_

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "vfh_astar/geometry.h"
#include "vfh_astar/mapping/hit_field.h"
#include "vfh_astar/mapping/log_odds_grid.h"
#include "vfh_astar/mapping/motion_model.h"
#include "vfh_astar/mapping/scan_matcher.h"
#include "vfh_astar/parameters.h"

namespace vfh_astar {

struct LocalizerParameters {
  double start_distance = 0.5;  ///< m by which a given pose may be off,
  double start_angle = 0.3;     ///< rad likewise.
  double lost_distance = 3.0;   ///< m around the last pose in which a lost
  double lost_angle = 0.8;      ///< robot is looked for; rad likewise.
  double found_share = 0.85;    ///< of the hits that have to lie on the map for
                                ///< a lost robot to count as found.

  void Read(ParameterReader& reader);
};

/// Follows a robot's pose in a map that was made before, by scan matching. The
/// map's own walls stay what they are; where the map knows nothing, what the
/// robot sees is added to what scans are matched with, so that it may drive on
/// beyond.
class Localizer {
 public:
  /// @param[in] map copied; it shares tiles with the original.
  /// @param[in] pose of the base in the map, about right.
  Localizer(const LocalizerParameters& parameters, const ScanMatcher& matcher,
            const MotionModelParameters& motion_model, const LogOddsGrid& map,
            const Pose2D& pose);

  /// Takes in a scan.
  /// @param[in] shape as ScanMatcher::Shape gives it.
  /// @param[in] motion of the base since the last scan, by odometry.
  void AddScan(const ScanShape& shape, const Pose2D& motion);

  /// Looks for the robot in a wide window around its pose.
  /// @param[in] points m, in the base's frame.
  /// @param[in] laser m, where they were seen from, likewise.
  /// @param[in] motion as in AddScan.
  /// @return false when it fits nowhere well enough.
  bool FindAgain(const std::vector<Eigen::Vector2d>& points,
                 const Eigen::Vector2d& laser, const Pose2D& motion);

  const Pose2D& pose() const { return pose_; }

 private:
  std::optional<Pose2D> Search(const std::vector<Eigen::Vector2d>& points,
                               const Pose2D& centre, double distance,
                               double angle, double least_score) const;
  void AddUnknown(const std::vector<Eigen::Vector2d>& walls);

  LocalizerParameters parameters_;
  ScanMatcher matcher_;
  MotionModelParameters motion_model_;
  LogOddsGrid map_;
  HitField field_;
  Pose2D pose_;
  bool is_settled_ = false;  ///< the pose has been matched once.
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_MAPPING_LOCALIZER_H_
