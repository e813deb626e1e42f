#ifndef VFH_ASTAR_NAVIGATION_FAILURE_RECORD_H_
#define VFH_ASTAR_NAVIGATION_FAILURE_RECORD_H_

#include <optional>
#include <string>

#include "vfh_astar/outcome.h"

namespace vfh_astar {

/// What went wrong last with the present goal, and since when planning has been
/// failing.
class FailureRecord {
 public:
  /// For a new goal.
  void Clear() { *this = FailureRecord(); }

  /// Planning has failed at `time` (s).
  void NotePlanning(double time, Outcome outcome, const std::string& message);

  /// Something else has gone wrong.
  void Note(Outcome outcome, const std::string& message);

  /// Planning has succeeded.
  void Recovered() { planning_since_.reset(); }

  Outcome outcome() const { return outcome_; }
  const std::string& message() const { return message_; }

  /// True when what failed may pass by itself (a moving obstacle, a map that
  /// still grows) and planning has failed for less than `patience` seconds.
  bool MayPass(double time, double patience) const;

  /// True when moving the robot a little may undo what failed.
  bool MovingMayHelp() const;

 private:
  Outcome outcome_ = Outcome::kSuccess;
  std::string message_;
  std::optional<double> planning_since_;
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_NAVIGATION_FAILURE_RECORD_H_
