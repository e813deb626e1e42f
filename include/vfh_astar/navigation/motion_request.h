#ifndef VFH_ASTAR_NAVIGATION_MOTION_REQUEST_H_
#define VFH_ASTAR_NAVIGATION_MOTION_REQUEST_H_

#include <optional>
#include <string>

#include "vfh_astar/geometry.h"
#include "vfh_astar/outcome.h"
#include "vfh_astar/trajectory/trajectory.h"

namespace vfh_astar {

/// Which question; an answer carries that of its question. The numbers begin
/// anew with every navigator, the goals of two are different.
struct MotionRequestId {
  int number = 0;
  std::string goal_id;

  bool operator==(const MotionRequestId& other) const {
    return number == other.number && goal_id == other.goal_id;
  }
  bool operator!=(const MotionRequestId& other) const {
    return !(*this == other);
  }
};

/// A question to the planner and the fitter.
struct MotionRequest {
  MotionRequestId id;
  double start_time = 0.0;  ///< s, when the robot will be at `start`.
  Reference start;          ///< map frame.
  Pose2D goal;              ///< map frame.
  double tolerance = 0.0;   ///< m, see PlanRequest.
};

/// The answer: a trajectory, or why there is none.
struct MotionAnswer {
  MotionRequestId id;
  Outcome outcome = Outcome::kSuccess;
  std::string message;
  Trajectory trajectory;  ///< empty on failure.
};

/// Decides when a question may be asked and which answer counts: one question
/// at a time, no faster than a period, and an answer must come in time.
class MotionRequestSchedule {
 public:
  /// @param[in] period s between two questions at least.
  /// @param[in] timeout s after which a question without answer has failed.
  MotionRequestSchedule(double period, double timeout)
      : period_(period), timeout_(timeout) {}

  /// Asks for a question to be sent, `delay` seconds from `time` at the
  /// earliest; an answer to the one that is out no longer counts.
  void Want(double time, double delay);

  /// Withdraws everything.
  void Clear();

  /// True when a question is wanted and due.
  bool IsDue(double time) const;

  /// Notes that the question is being sent.
  /// @param[in] goal_id the goal that it serves.
  /// @param[in] join the clock of the trajectory it joins, see
  ///   TrajectoryFollower::Follow.
  /// @return its id.
  MotionRequestId Send(const std::string& goal_id, double time,
                       double start_time, std::optional<double> join);

  /// True when the answer is to the question that is out, which is then
  /// settled.
  bool Accept(const MotionRequestId& id);

  /// True when the question that is out has waited too long; it is then
  /// settled.
  bool HasTimedOut(double time);

  /// Of the question last sent.
  double start_time() const { return start_time_; }
  std::optional<double> join() const { return join_; }

 private:
  double period_;
  double timeout_;
  std::optional<double> wanted_at_;
  std::optional<double> sent_at_;
  bool waiting_ = false;
  MotionRequestId id_;
  double start_time_ = 0.0;
  std::optional<double> join_;
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_NAVIGATION_MOTION_REQUEST_H_
