#ifndef VFH_ASTAR_TRACKING_OBSTACLE_TRACKER_H_
#define VFH_ASTAR_TRACKING_OBSTACLE_TRACKER_H_

#include <optional>
#include <vector>

#include "vfh_astar/geometry.h"
#include "vfh_astar/laser_scan.h"
#include "vfh_astar/parameters.h"
#include "vfh_astar/tracking/moving_obstacle.h"
#include "vfh_astar/tracking/obstacle_track.h"
#include "vfh_astar/tracking/scan_clusters.h"
#include "vfh_astar/tracking/scan_memory.h"

namespace vfh_astar {

struct TrackerParameters {
  double max_range = 10.0;  ///< m, farther hits are not tracked; 0: nothing is.
  double max_extent = 1.6;  ///< m; what is larger is structure.
  double min_speed = 0.25;  ///< m/s; what is slower stands.
  double memory = 0.8;  ///< s for which it is known where there was nothing.
  double coast_time = 2.0;  ///< s for which what is out of sight is believed to
                            ///< go on as it did.

  void Read(ParameterReader& reader);
};

/// Finds what moves in a sequence of scans.
///
/// Clusters of hits are followed from scan to scan. One moves when its speed
/// stands out from the filter's error and part of it lies where an earlier scan
/// saw through, or it has left where it was: a wall that comes into view bit by
/// bit seems to move too, but what appears of it was hidden before.
class ObstacleTracker {
 public:
  explicit ObstacleTracker(const TrackerParameters& parameters);

  /// Takes in a scan; one that is not newer than the last is left out.
  /// @param[in] laser_pose in a frame that does not jump, such as odometry's.
  void AddScan(const LaserScan& scan, const Pose2D& laser_pose);

  /// What moves, in the frame of the poses, at the time of the last scan.
  std::vector<MovingObstacle> Moving() const;

  /// True when beams of the last scan hit something that moves.
  bool HitsMovers() const { return !moving_beams_.empty(); }

  /// The scan last given, with NaN where beams hit something that moves,
  LaserScan Without(LaserScan scan) const;
  /// and with NaN everywhere else.
  LaserScan Only(const LaserScan& scan) const;

  const std::vector<ObstacleTrack>& tracks() const { return tracks_; }

 private:
  TrackMeasurement Measure(const ScanCluster& cluster,
                           const ObstacleTrack* track) const;
  void Follow(const std::vector<ScanCluster>& clusters);
  void RememberPoints(const ScanCluster& cluster, ObstacleTrack& track) const;
  void Judge(ObstacleTrack& track, const ScanCluster& cluster);
  void DropLost();

  TrackerParameters parameters_;
  ScanMemory memory_;
  PlacedScan last_;
  bool has_scan_ = false;
  std::vector<ObstacleTrack> tracks_;
  std::vector<std::size_t> moving_beams_;
  int next_id_ = 1;
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_TRACKING_OBSTACLE_TRACKER_H_
