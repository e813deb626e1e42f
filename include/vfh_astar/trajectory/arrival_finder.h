#ifndef VFH_ASTAR_TRAJECTORY_ARRIVAL_FINDER_H_
#define VFH_ASTAR_TRAJECTORY_ARRIVAL_FINDER_H_

#include <optional>

#include "vfh_astar/geometry.h"
#include "vfh_astar/trajectory/leg_search.h"
#include "vfh_astar/trajectory/manoeuvre.h"
#include "vfh_astar/trajectory/manoeuvre_finder.h"
#include "vfh_astar/trajectory/polyline.h"

namespace vfh_astar {

struct Arrival {
  Manoeuvre manoeuvre;
  bool has_heading = true;  ///< false when there was no room to take the goal's
                            ///< heading: it ends with the path's.
};

/// Finds how to get along a path and end in a goal's pose. It tries, in this
/// order: to bend into the goal's heading, where that is not far off the path;
/// to turn on the spot at the goal; to bend however far off it is; to turn
/// before or behind the goal and drive straight in, forward or in reverse; to
/// turn where along the path there is room and drive the rest in reverse.
class ArrivalFinder {
 public:
  /// A goal nearer than this (m) is reached already.
  static constexpr double kArrived = 0.02;

  /// Keeps a reference to `search`.
  ArrivalFinder(LegSearch& search, const ManoeuvreParameters& parameters);

  /// @param[in] path from the departure's place to the goal's.
  /// @return nothing when the goal's place cannot be reached, or when the robot
  ///   stands there and has no room to turn.
  std::optional<Arrival> Find(const Departure& departure, const Polyline& path,
                              const Pose2D& goal);

 private:
  bool AddTurn(const Pose2D& pose, double heading, Manoeuvre& manoeuvre) const;
  std::optional<Manoeuvre> WithHeading(const Departure& departure,
                                       const Polyline& path,
                                       const Pose2D& goal);
  std::optional<Manoeuvre> StraightIn(const Departure& departure,
                                      const Polyline& path, const Pose2D& goal);
  std::optional<Manoeuvre> TailFirst(const Departure& departure,
                                     const Polyline& path, double heading);

  LegSearch& search_;
  ManoeuvreParameters parameters_;
  ManoeuvreFinder finder_;
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_TRAJECTORY_ARRIVAL_FINDER_H_
