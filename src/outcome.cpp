#include "vfh_astar/outcome.h"

namespace vfh_astar {

const char* ToString(Outcome outcome) {
  switch (outcome) {
    case Outcome::kSuccess:
      return "success";
    case Outcome::kFailure:
      return "failure";
    case Outcome::kCancelled:
      return "cancelled";
    case Outcome::kInvalidGoal:
      return "invalid goal";
    case Outcome::kNoPath:
      return "no path";
    case Outcome::kGoalOutsideMap:
      return "goal outside the map";
    case Outcome::kGoalBlocked:
      return "goal blocked";
    case Outcome::kStartOutsideMap:
      return "start outside the map";
    case Outcome::kStartBlocked:
      return "start blocked";
    case Outcome::kNoMap:
      return "no map";
    case Outcome::kNoTrajectory:
      return "no trajectory";
    case Outcome::kStuck:
      return "robot stuck";
    case Outcome::kOscillation:
      return "oscillation";
    case Outcome::kCollision:
      return "collision";
    case Outcome::kLocalizationLost:
      return "localisation lost";
    case Outcome::kNoScan:
      return "no scan";
    case Outcome::kNoOdometry:
      return "no odometry";
    case Outcome::kTransformError:
      return "transform error";
    case Outcome::kTimeout:
      return "timeout";
  }
  return "unknown outcome";
}

}  // namespace vfh_astar
