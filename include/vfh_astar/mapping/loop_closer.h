#ifndef VFH_ASTAR_MAPPING_LOOP_CLOSER_H_
#define VFH_ASTAR_MAPPING_LOOP_CLOSER_H_

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "vfh_astar/geometry.h"
#include "vfh_astar/mapping/pose_graph.h"
#include "vfh_astar/mapping/scan_matcher.h"

namespace vfh_astar {

struct LoopCloserParameters {
  int recent_scans = 10;       ///< that a scan is tied to as its predecessors.
  int gap_scans = 30;          ///< between a scan and what counts as old.
  double gap_distance = 10.0;  ///< m of path between them.
  double near_radius = 8.0;    ///< m around a scan in which old ones are used.
  int near_scans = 15;         ///< old ones at most.
  double near_window = 0.4;    ///< m
  double near_angle = 0.15;    ///< rad
  double near_path = 15.0;     ///< m of path since the last loop, at most.
  double near_fit = 0.6;       ///< 0 to 1, at least; see Alignment::fit.
  double far_fit = 0.65;       ///< the same for the wide search.
  double drift = 0.03;         ///< m per m of path, widens the wide search.
  double widest_window = 6.0;  ///< m
  double loop_weight = 0.3;    ///< of a loop's information, as scans repeat
                               ///< what they say.
};

/// A scan that is kept, with its place in the graph.
struct SlamNode {
  ScanShape shape;
  double path = 0.0;  ///< m driven until then; turning counts too.
};

/// Finds constraints between a scan and earlier ones: its predecessors, and old
/// ones that it meets again. Looks in a small window while the last loop is not
/// long ago. After that it looks as far as the pose may have drifted, and then
/// with the newest scans together, as one scan alone fits in many places; and
/// two such searches in a row have to agree.
class LoopCloser {
 public:
  LoopCloser(const LoopCloserParameters& parameters, const ScanMatcher& matcher)
      : parameters_(parameters), matcher_(matcher) {}

  /// The constraint from the scan before to the newest.
  /// @param[in] nodes all scans.
  /// @param[in] poses theirs, of all but the newest.
  /// @param[in] prior where odometry sees the newest.
  /// @param[in] start a pose near which it was found already.
  PoseConstraint TieToPredecessor(const std::vector<SlamNode>& nodes,
                                  const std::vector<Pose2D>& poses,
                                  const PoseBelief& prior,
                                  const Pose2D& start) const;

  /// A constraint from an old scan to the newest, if one is found.
  /// @param[in] poses of all scans.
  /// @param[in] guess of the newest pose, to look around.
  std::optional<PoseConstraint> FindLoop(const std::vector<SlamNode>& nodes,
                                         const std::vector<Pose2D>& poses,
                                         const Pose2D& guess);

 private:
  struct Window {
    double linear;     ///< m to all four sides.
    double angular;    ///< rad to both sides.
    double penalty;    ///< of the fit, at an edge of the window.
    double least_fit;  ///< less the penalty.
  };
  std::optional<PoseConstraint> FindNear(const std::vector<SlamNode>& nodes,
                                         const std::vector<Pose2D>& poses,
                                         const Pose2D& guess) const;
  std::optional<PoseConstraint> FindFar(const std::vector<SlamNode>& nodes,
                                        const std::vector<Pose2D>& poses,
                                        const Pose2D& guess,
                                        double path_since_loop) const;
  /// Lets a wide search's result pass when it agrees with the one before.
  std::optional<PoseConstraint> Confirm(
      const std::optional<PoseConstraint>& found,
      const std::vector<Pose2D>& poses);
  bool IsOld(const std::vector<SlamNode>& nodes, int index) const;
  std::optional<PoseConstraint> Match(
      const HitField& field, const std::vector<Eigen::Vector2d>& points,
      const Pose2D& guess, const Window& window, int anchor,
      const std::vector<Pose2D>& poses) const;

  LoopCloserParameters parameters_;
  ScanMatcher matcher_;
  double last_loop_path_ = 0.0;
  std::optional<PoseConstraint> unconfirmed_;  ///< of the last wide search.
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_MAPPING_LOOP_CLOSER_H_
