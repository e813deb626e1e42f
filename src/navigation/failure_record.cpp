#include "vfh_astar/navigation/failure_record.h"

namespace vfh_astar {

void FailureRecord::NotePlanning(double time, Outcome outcome,
                                 const std::string& message) {
  Note(outcome, message);
  if (!planning_since_) planning_since_ = time;
}

void FailureRecord::Note(Outcome outcome, const std::string& message) {
  outcome_ = outcome;
  message_ = message;
}

bool FailureRecord::MayPass(double time, double patience) const {
  if (!planning_since_ || time - *planning_since_ >= patience) return false;
  switch (outcome_) {
    case Outcome::kNoPath:
    case Outcome::kGoalBlocked:
    case Outcome::kStartBlocked:
    case Outcome::kNoMap:
    case Outcome::kNoTrajectory:
    case Outcome::kTimeout:
      return true;
    default:
      return false;
  }
}

bool FailureRecord::MovingMayHelp() const {
  return outcome_ == Outcome::kStuck || outcome_ == Outcome::kOscillation ||
         outcome_ == Outcome::kStartBlocked ||
         outcome_ == Outcome::kNoTrajectory;
}

}  // namespace vfh_astar
