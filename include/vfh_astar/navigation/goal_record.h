#ifndef VFH_ASTAR_NAVIGATION_GOAL_RECORD_H_
#define VFH_ASTAR_NAVIGATION_GOAL_RECORD_H_

#include <deque>
#include <optional>
#include <string>

#include "vfh_astar/geometry.h"
#include "vfh_astar/outcome.h"

namespace vfh_astar {

struct Goal {
  std::string id;
  Pose2D pose;  ///< map frame.
};

struct GoalResult {
  std::string goal_id;
  Outcome outcome = Outcome::kSuccess;
  std::string message;
};

/// The books on the goals: which one is pursued, how often it has been planned
/// for, whether the robot still follows the trajectory of the one before, and
/// how those that are over have ended.
class GoalRecord {
 public:
  /// Opens the books on a new goal.
  void Begin(const Goal& goal);

  /// Of the goal that was begun last, also after its end.
  const Goal& goal() const { return goal_; }

  /// Notes that a plan has been asked for.
  void NotePlanning() { ++plannings_; }

  /// Plans asked for since the goal came in, without the first; 0 or more.
  int Replans() const;

  /// Notes that the trajectory to the present goal is being followed.
  void NoteFollowing() { followed_number_ = number_; }

  /// True when no trajectory has been followed to the present goal yet.
  bool IsFollowingOld() const { return followed_number_ != number_; }

  /// Notes how the present goal has ended.
  void End(Outcome outcome, const std::string& message);

  /// Hands out each result once, the oldest first.
  std::optional<GoalResult> TakeResult();

 private:
  Goal goal_;
  int number_ = 0;
  int followed_number_ = 0;
  int plannings_ = 0;
  std::deque<GoalResult> results_;
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_NAVIGATION_GOAL_RECORD_H_
