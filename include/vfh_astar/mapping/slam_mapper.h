#ifndef VFH_ASTAR_MAPPING_SLAM_MAPPER_H_
#define VFH_ASTAR_MAPPING_SLAM_MAPPER_H_

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "vfh_astar/geometry.h"
#include "vfh_astar/laser_scan.h"
#include "vfh_astar/mapping/grid_mapper.h"
#include "vfh_astar/mapping/localizer.h"
#include "vfh_astar/mapping/map_agreement.h"
#include "vfh_astar/mapping/odometry_guard.h"
#include "vfh_astar/mapping/slam.h"
#include "vfh_astar/parameters.h"
#include "vfh_astar/tracking/obstacle_tracker.h"

namespace vfh_astar {

struct SlamMapperParameters {
  GridMapperParameters grid;
  std::string localization = "slam";  ///< or odometry: poses are taken as
                                      ///< odometry gives them.
  int seed = 1;                       ///< of the particle filter.
  TrackerParameters movers;           ///< what moves is left out of the map.
  SlamParameters slam;
  LocalizerParameters localizer;
  double lost_near_share = 0.35;     ///< of the hits, fewer of which lie on the
                                     ///< map, and
  double lost_pierced_share = 0.25;  ///< more of which lie behind its walls,
                                     ///< when a pose is doubted.

  /// What Slam takes for granted suits logs that are thinned. A robot's scans
  /// come dense, and each then adds its pull towards odometry: with a wheel
  /// that is measured wrong by 3 % that bends a map, so here odometry counts
  /// little.
  SlamMapperParameters() {
    slam.linear_update = 0.2;
    slam.motion.srr = 0.3;
    slam.motion.linear_floor = 0.1;
  }

  void Read(ParameterReader& reader);
};

/// How sure the pose is.
struct Localization {
  bool is_lost = false;
  MapAgreement agreement;  ///< of the last scan that was compared.
  int odometry_jumps = 0;  ///< that were left out.
};

/// The map and the robot's pose in it, from scans and odometry.
///
/// Without a map it begins one and corrects its poses by Slam. With a map it
/// follows its pose there by a Localizer, and still enters into the map what it
/// sees. Either way scans go into an occupancy map by GridMapper; when Slam
/// finds out later where the robot has been, that map is made anew.
///
/// Scans that contradict the map are kept out of it; a robot whose scans keep
/// doing so is lost: it is looked for around its last pose until it is found or
/// a pose is given.
class SlamMapper {
 public:
  /// @param[in] start of the base in the map, at the first scan.
  SlamMapper(const SlamMapperParameters& parameters, const Pose2D& start);

  /// Begins with a map (cells 0 to 100 or kUnknown), which also gives the
  /// geometry. Before the first scan.
  void SetMap(const OccupancyGrid& map);

  /// Puts the robot somewhere else in the map, about right: somebody knows
  /// better.
  void SetPose(const Pose2D& map_from_base);

  /// The map begins anew: with the map given, or empty. The pose stays; in an
  /// empty map nobody is lost.
  void Forget();

  /// Takes in a scan.
  /// @param[in] scan without defect (see DescribeDefect); stamps rise.
  /// @param[in] base_from_laser the laser in the base's frame.
  /// @param[in] odom_from_base odometry when the scan was taken.
  MapChange AddScan(const LaserScan& scan, const Pose2D& base_from_laser,
                    const Pose2D& odom_from_base);

  /// The two parts of AddScan, one after the other: where the robot is, and
  /// what it sees into the map.
  void Locate(const LaserScan& scan, const Pose2D& base_from_laser,
              const Pose2D& odom_from_base);
  MapChange Enter();

  /// Where odometry's frame lies in the map; before the first scan as if
  /// odometry began at the start.
  const Pose2D& map_from_odom() const { return map_from_odom_; }

  const Localization& localization() const { return localization_; }
  const GridMapper& grid_mapper() const { return grid_; }

 private:
  struct KeptScan {
    LaserScan scan;
    Pose2D base_from_laser;
  };

  LaserScan WithoutMovers(const LaserScan& scan, const Pose2D& odom_from_laser);
  Pose2D Localize();
  void FollowInMap();
  bool IsDoubtful();
  void Doubt();
  void Trust();
  void BeginSlam();
  void LocalizeFrom(const Pose2D& pose);
  bool IsToRebuild() const { return slam_ && slam_->revision() != revision_; }
  MapChange Rebuild();

  SlamMapperParameters parameters_;
  ScanMatcher matcher_;
  ObstacleTracker tracker_;
  Pose2D start_;
  std::optional<OccupancyGrid> known_map_;
  GridMapper grid_;
  OdometryGuard guard_;
  Pose2D odometry_;          ///< of the newest scan,
  Pose2D guarded_odometry_;  ///< and without jumps.
  // One of the two localises, or none with odometry alone.
  std::unique_ptr<Slam> slam_;
  std::unique_ptr<Localizer> localizer_;
  Pose2D localized_odometry_;  ///< guarded, when the localizer last looked,
  std::optional<double> localized_at_;  ///< s, and when that was.
  KeptScan newest_;                     ///< without what moves.
  std::vector<KeptScan> kept_;          ///< one for each pose of slam_.
  int revision_ = 0;  ///< of slam_ that the map was made from.
  Pose2D pose_;       ///< of the base in the map, at the last scan.
  Pose2D map_from_guarded_;
  Pose2D map_from_odom_;
  bool has_begun_ = false;
  Localization localization_;
  int doubts_ = 0;              ///< scans in a row,
  double doubted_since_ = 0.0;  ///< s, and when the first of them was taken.
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_MAPPING_SLAM_MAPPER_H_
