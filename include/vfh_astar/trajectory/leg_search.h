#ifndef VFH_ASTAR_TRAJECTORY_LEG_SEARCH_H_
#define VFH_ASTAR_TRAJECTORY_LEG_SEARCH_H_

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "vfh_astar/geometry.h"
#include "vfh_astar/trajectory/leg_fitter.h"
#include "vfh_astar/trajectory/manoeuvre.h"
#include "vfh_astar/trajectory/path_shortening.h"
#include "vfh_astar/trajectory/polyline.h"
#include "vfh_astar/trajectory/pose_check.h"
#include "vfh_astar/trajectory/spline_curve.h"

namespace vfh_astar {

/// The end of a leg along a line, with the line's own heading (rad, of travel)
/// if none is given.
CurveEnd EndAlong(const Polyline& line,
                  std::optional<double> heading = std::nullopt);

/// Legs and turns that are free, for whoever tries one after another: it
/// remembers which ends of legs have failed, and how much has been tried, so
/// that a hopeless search ends soon.
class LegSearch {
 public:
  /// Keeps a reference to `check`.
  /// @param[in] fast_room m; see LegFitter.
  LegSearch(const PoseCheck& check, double fast_room);

  /// A leg along a line; nothing when there is none, or no effort left.
  /// @param[in] start, end headings are those of travel.
  std::optional<Leg> FitLeg(const Polyline& line, const CurveEnd& start,
                            const CurveEnd& end, bool reverse);

  /// True when a leg with these ends is known to fail at one of them.
  bool IsHopeless(const Polyline& line, const CurveEnd& start,
                  const CurveEnd& end, bool reverse) const;

  /// Turns on the spot to a heading (rad), the short way round or else the long
  /// one; nothing when neither is free.
  std::optional<Turn> FindTurn(const Pose2D& pose, double heading) const;

  /// See ShortenPath.
  Polyline Shorten(const Polyline& path) const;

  /// rad, in which a shortened path leaves its first point, and about in which
  /// it comes to its last one.
  double DirectionFrom(const Polyline& path) const;
  double DirectionInto(const Polyline& path) const;

  /// Begins a search that may fit curves of `effort` metres.
  void Begin(double effort) { effort_left_ = effort; }
  bool IsExhausted() const;

  /// Takes back what all searches together have used.
  void RenewEffort();

  /// Where the footprint did not fit in the first leg that failed, m: the most
  /// natural one.
  const std::optional<Eigen::Vector2d>& first_blocked() const {
    return first_blocked_;
  }
  /// And in the last one.
  const Eigen::Vector2d& last_blocked() const { return last_blocked_; }

  const PoseCheck& check() const { return check_; }

 private:
  struct LegEnd {
    CurveEnd end;
    Eigen::Vector2d beyond;  ///< m, the line's point a little inward.
    bool is_start;
    bool reverse;
  };
  static std::vector<LegEnd> EndsOf(const Polyline& line, const CurveEnd& start,
                                    const CurveEnd& end, bool reverse);
  bool IsHopeless(const LegEnd& end) const;
  ShorteningLimits Limits() const;
  void NoteBlocked(const Eigen::Vector2d& place);

  const PoseCheck& check_;
  double fast_room_;
  LegFitter fitter_;
  std::vector<LegEnd> hopeless_;
  double effort_left_;        ///< m of curves, of this search.
  double total_effort_left_;  ///< m, of all together.
  std::optional<Eigen::Vector2d> first_blocked_;
  Eigen::Vector2d last_blocked_ = Eigen::Vector2d::Zero();
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_TRAJECTORY_LEG_SEARCH_H_
