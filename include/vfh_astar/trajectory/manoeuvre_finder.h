#ifndef VFH_ASTAR_TRAJECTORY_MANOEUVRE_FINDER_H_
#define VFH_ASTAR_TRAJECTORY_MANOEUVRE_FINDER_H_

#include <optional>

#include "vfh_astar/geometry.h"
#include "vfh_astar/trajectory/leg_search.h"
#include "vfh_astar/trajectory/manoeuvre.h"
#include "vfh_astar/trajectory/polyline.h"

namespace vfh_astar {

struct ManoeuvreParameters {
  double turn_threshold = 0.6;  ///< rad; see TrajectoryFitterParameters.
  bool may_reverse = true;
};

/// Finds how to get along a path: smooth legs where they fit, and turns on the
/// spot and reverse legs where nothing else does. It tries, in this order: to
/// drive off bending into the path; to turn, then drive; to drive the first
/// part in reverse to where there is room to turn; to shift a little along an
/// arc to such a place.
class ManoeuvreFinder {
 public:
  /// Keeps a reference to `search`.
  ManoeuvreFinder(LegSearch& search, const ManoeuvreParameters& parameters);

  /// From rest or in motion to the path's last point.
  /// @param[in] path from the departure's place on, longer than 0.
  /// @param[in] end_heading rad, of the robot at the end; free when not set.
  std::optional<Manoeuvre> Find(const Departure& departure,
                                const Polyline& path,
                                std::optional<double> end_heading);

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
  /// A short drive along an arc, to where there is room to turn.
  std::optional<Leg> FitShift(const Pose2D& from, const ArcShape& arc,
                              const Polyline& path);

  LegSearch& search_;
  ManoeuvreParameters parameters_;
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_TRAJECTORY_MANOEUVRE_FINDER_H_
