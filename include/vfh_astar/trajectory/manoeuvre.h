#ifndef VFH_ASTAR_TRAJECTORY_MANOEUVRE_H_
#define VFH_ASTAR_TRAJECTORY_MANOEUVRE_H_

#include <Eigen/Core>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "vfh_astar/geometry.h"
#include "vfh_astar/trajectory/leg_fitter.h"
#include "vfh_astar/trajectory/path_shortening.h"
#include "vfh_astar/trajectory/pose_check.h"
#include "vfh_astar/trajectory/spline_curve.h"

namespace vfh_astar {

/// A drive without a stop, as LegFitter made it.
struct Leg {
  std::vector<CurvePoint> points;
  bool reverse = false;
};

/// A turn on the spot.
struct Turn {
  Pose2D pose;         ///< before it.
  double angle = 0.0;  ///< rad, signed.
};

/// What the robot does, without time: legs and turns in order, each starting
/// where the one before it ends. Between two stages it stands.
using Manoeuvre = std::vector<std::variant<Leg, Turn>>;

/// The pose in which a manoeuvre that is not empty ends.
Pose2D EndOf(const Manoeuvre& manoeuvre);

/// How a manoeuvre begins.
struct Departure {
  Pose2D pose;
  bool moving = false;     ///< forward; then it has to begin with a drive along
                           ///< the heading,
  double curvature = 0.0;  ///< 1/m, with this curvature,
  Polyline lead;           ///< along these points before it takes to the path.
};

struct ManoeuvreParameters {
  double turn_threshold = 0.6;  ///< rad; see TrajectoryFitterParameters.
  double fast_room = 0.6;       ///< m; see LegFitter.
  bool may_reverse = true;
};

/// Finds how to get along a path: smooth legs where they fit, and turns on the
/// spot and reverse legs where nothing else does.
class ManoeuvreFinder {
 public:
  /// Keeps a reference to `check`.
  ManoeuvreFinder(const PoseCheck& check,
                  const ManoeuvreParameters& parameters);

  /// From rest or in motion to the path's last point.
  /// @param[in] path from the departure's place on, longer than 0.
  /// @param[in] end_heading rad, of the robot at the end; free when not set.
  std::optional<Manoeuvre> Find(const Departure& departure,
                                const Polyline& path,
                                std::optional<double> end_heading);

  /// Turns on the spot, the short way round or else the long one.
  std::optional<Turn> FindTurn(const Pose2D& pose, double heading) const;

  /// Drives back into the path's last point to end with `heading`, from
  /// wherever along the path there is room to turn first.
  std::optional<Manoeuvre> FindTailFirst(const Departure& departure,
                                         const Polyline& path, double heading);

  /// Drives straight into `goal`, forward or back, after a turn at a place
  /// before or behind it where there is room for one.
  std::optional<Manoeuvre> FindStraightIn(const Departure& departure,
                                          const Polyline& path,
                                          const Pose2D& goal);

  /// A leg along a line. The ends' headings are those of the travel.
  std::optional<Leg> FitLeg(const Polyline& line, const CurveEnd& start,
                            const CurveEnd& end, bool reverse);

  Polyline Shorten(const Polyline& path) const;

  /// Where the footprint did not fit in the last leg that failed, m.
  const std::optional<Eigen::Vector2d>& blocked_at() const {
    return blocked_at_;
  }

 private:
  std::optional<Manoeuvre> Drive(const Departure& departure,
                                 const Polyline& path,
                                 std::optional<double> end_heading);
  std::optional<Manoeuvre> DriveWithStop(const Departure& departure,
                                         const Polyline& path,
                                         std::optional<double> end_heading);
  std::optional<Manoeuvre> TurnThenDrive(const Pose2D& pose,
                                         const Polyline& path,
                                         std::optional<double> end_heading);
  std::optional<Manoeuvre> BackOutThenDrive(const Pose2D& pose,
                                            const Polyline& path,
                                            std::optional<double> end_heading);
  std::optional<Manoeuvre> ShiftThenDrive(const Pose2D& pose,
                                          const Polyline& path,
                                          std::optional<double> end_heading);

  /// An end of a leg near which a fit was not free.
  struct LegEnd {
    CurveEnd end;
    Eigen::Vector2d beyond;  ///< m, the line's point a little inward.
    bool is_start;
    bool reverse;
  };
  static LegEnd StartOf(const Polyline& line, const CurveEnd& start,
                        bool reverse);
  static LegEnd EndOf(const Polyline& line, const CurveEnd& end, bool reverse);
  bool IsHopeless(const LegEnd& end) const;

  const PoseCheck& check_;
  ManoeuvreParameters parameters_;
  LegFitter fitter_;
  std::vector<LegEnd> hopeless_;
  double effort_left_;        ///< m of curves, of this Find; see LegResult.
  double total_effort_left_;  ///< m, of all together.
  std::optional<Eigen::Vector2d> blocked_at_;
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_TRAJECTORY_MANOEUVRE_H_
