#ifndef VFH_ASTAR_OUTCOME_H_
#define VFH_ASTAR_OUTCOME_H_

namespace vfh_astar {

/// How a goal, or one stage of it, ended; values in the manner of
/// mbf_msgs/MoveBaseResult, so that clients can tell them apart.
enum class Outcome {
  kSuccess = 0,
  kFailure = 10,
  kCancelled = 11,
  kInvalidGoal = 12,
  kNoPath = 50,
  kGoalOutsideMap = 51,
  kGoalBlocked = 52,
  kStartOutsideMap = 53,
  kStartBlocked = 54,
  kNoMap = 55,
  kNoTrajectory = 60,
  kStuck = 100,
  kOscillation = 101,
  kCollision = 102,
  kLocalizationLost = 103,
  kNoScan = 104,
  kNoOdometry = 105,
  kTransformError = 106,
  kTimeout = 107,
};

/// The outcome in words, e.g. "no path".
const char* ToString(Outcome outcome);

}  // namespace vfh_astar

#endif  // VFH_ASTAR_OUTCOME_H_
