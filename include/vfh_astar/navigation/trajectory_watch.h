#ifndef VFH_ASTAR_NAVIGATION_TRAJECTORY_WATCH_H_
#define VFH_ASTAR_NAVIGATION_TRAJECTORY_WATCH_H_

#include <optional>
#include <string>

#include "vfh_astar/navigation/arrival.h"
#include "vfh_astar/navigation/navigator_parameters.h"
#include "vfh_astar/navigation/observation.h"
#include "vfh_astar/navigation/progress_monitor.h"
#include "vfh_astar/navigation/state_machine.h"
#include "vfh_astar/navigation/trajectory_follower.h"

namespace vfh_astar {

/// Something that was noticed, and the numbers behind it for people.
struct Notice {
  Event event;
  std::string detail;
};

/// Watches a trajectory being driven: arrival, obstacles on it, deviation from
/// it, its end, and whether the robot moves at all.
class TrajectoryWatch {
 public:
  /// @param[in] parameters kept by reference: changes count at once.
  explicit TrajectoryWatch(const NavigatorParameters& parameters);

  /// Begins with a new trajectory.
  void Reset();

  /// Begins with counting progress anew.
  void ResetProgress() { progress_.Reset(); }

  /// One cycle in TRACKING, AVOIDING or REPLANNING.
  /// @return what calls for a transition, the most pressing first.
  std::optional<Notice> Update(State state, const Observation& observation,
                               const TrajectoryFollower& follower);

  /// True while an obstacle is too close for tracking.
  bool avoiding() const { return avoiding_since_.has_value(); }

  /// True while something that moves is among what is being avoided.
  bool avoiding_movers() const { return avoiding() && has_mover_ahead_; }

  /// True once the robot has been at the trajectory's end.
  bool at_end() const { return arrival_.latched(); }

 private:
  std::optional<Notice> WatchObstacles(const Observation& observation,
                                       double time_to_collision);
  bool IsMoverAhead(const Observation& observation,
                    const TrajectoryFollower& follower) const;
  std::optional<Notice> WatchBlockage(bool avoiding, double time,
                                      double time_to_collision);
  std::optional<Notice> WatchEnd(double time,
                                 const TrajectoryFollower& follower);
  std::optional<Notice> WatchError(bool avoiding,
                                   const Observation& observation,
                                   const TrajectoryFollower& follower) const;

  const NavigatorParameters& parameters_;
  Arrival arrival_;
  ProgressMonitor progress_;
  std::optional<double> blocked_since_;
  std::optional<double> ended_since_;
  std::optional<double> avoiding_since_;
  bool has_mover_ahead_ = false;
  double mover_seen_ahead_ = 0.0;  ///< s, when there was one last.
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_NAVIGATION_TRAJECTORY_WATCH_H_
