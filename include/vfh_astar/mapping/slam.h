#ifndef VFH_ASTAR_MAPPING_SLAM_H_
#define VFH_ASTAR_MAPPING_SLAM_H_

#include <cstdint>
#include <vector>

#include "vfh_astar/geometry.h"
#include "vfh_astar/laser_scan.h"
#include "vfh_astar/mapping/loop_closer.h"
#include "vfh_astar/mapping/motion_model.h"
#include "vfh_astar/mapping/particle_filter.h"
#include "vfh_astar/mapping/pose_graph.h"
#include "vfh_astar/mapping/scan_matcher.h"
#include "vfh_astar/parameters.h"

namespace vfh_astar {

struct SlamParameters {
  double linear_update = 0.4;    ///< m driven until the next scan is used.
  double angular_update = 0.3;   ///< rad turned until the next scan is used.
  double temporal_update = 1.0;  ///< s until the pose is matched anyway.
  /// False leaves the particles alone with the map, as gmapping does.
  bool loop_closure = true;
  ScanMatcherParameters matcher;
  MotionModelParameters motion;
  ParticleFilterParameters filter;
  LoopCloserParameters loops;
  PoseGraphParameters graph;

  void Read(ParameterReader& reader);
};

/// Simultaneous localisation and mapping with a planar laser and odometry.
///
/// A particle filter over hit fields follows the scans. Over it stands a graph
/// of the scans' poses: each scan is tied to its predecessors and, where the
/// filter finds itself among old scans, to those. When these ties disagree with
/// the poses, the graph is solved, and the filter goes on from its solution.
class Slam {
 public:
  /// @param[in] start of the base in the map, at the first scan.
  Slam(const SlamParameters& parameters, std::uint32_t seed,
       const Pose2D& start = Pose2D());

  /// Takes in a scan, if the robot has moved far enough since the last. Else
  /// now and then the scan still says where the robot is, as odometry wears off
  /// while it stands, too.
  /// @param[in] scan without defect (see DescribeDefect).
  /// @param[in] base_from_laser the laser in the base's frame.
  /// @param[in] odometry the base in a frame that only drifts.
  /// @return whether the scan was used; it then has the last place in the
  ///   trajectory.
  bool AddScan(const LaserScan& scan, const Pose2D& base_from_laser,
               const Pose2D& odometry);

  /// The base in the map for every scan used, the first at the start. What is
  /// found later moves earlier poses; revision() tells.
  const std::vector<Pose2D>& trajectory() const { return trajectory_; }

  /// Changes whenever poses before the newest have changed: then a map made
  /// from the scans has to be made anew.
  int revision() const { return revision_; }

  /// The base in the map now. Not before the first scan.
  /// @param[in] odometry as in AddScan, at the time asked for.
  Pose2D PoseAt(const Pose2D& odometry) const {
    return trajectory_.back() * (last_odometry_.Inverse() * odometry);
  }

  /// Solves the graph once more with all that is known; for the end of a run.
  void Finish();

  const ParticleFilter& filter() const { return filter_; }
  const std::vector<PoseConstraint>& constraints() const {
    return constraints_;
  }

 private:
  bool IsDue(const Pose2D& motion) const;
  void Track(const LaserScan& scan, const Pose2D& base_from_laser,
             const Pose2D& odometry);
  void ExtendGraph(const Pose2D& motion);
  void FindLoops();
  void Solve();
  void FollowFilter();

  SlamParameters parameters_;
  ScanMatcher matcher_;
  ParticleFilter filter_;
  LoopCloser loop_closer_;
  std::vector<SlamNode> nodes_;
  std::vector<Pose2D> trajectory_;
  std::vector<PoseConstraint> constraints_;
  Pose2D last_odometry_;  ///< at the newest pose, less what has drifted since.
  double matched_at_ = 0.0;  ///< s
  int revision_ = 0;
  bool is_unsettled_ = false;  ///< a tie disagrees with the poses.
  std::size_t solved_at_ = 0;  ///< scans when the graph was last solved.
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_MAPPING_SLAM_H_
