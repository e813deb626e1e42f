#include "vfh_astar/navigation/goal_record.h"

#include <algorithm>
#include <utility>

namespace vfh_astar {

void GoalRecord::Begin(const Goal& goal) {
  goal_ = goal;
  ++number_;
  plannings_ = 0;
}

int GoalRecord::Replans() const { return std::max(0, plannings_ - 1); }

void GoalRecord::End(Outcome outcome, const std::string& message) {
  results_.push_back({goal_.id, outcome, message});
}

std::optional<GoalResult> GoalRecord::TakeResult() {
  if (results_.empty()) return std::nullopt;
  GoalResult result = std::move(results_.front());
  results_.pop_front();
  return result;
}

}  // namespace vfh_astar
