#include "vfh_astar/planning/uniform_search.h"

#include <algorithm>
#include <cstdlib>

namespace vfh_astar {

bool UniformSearch::IsDense(const Cell& start, const Cell& goal) const {
  // Single cells blocked at random, 8 in a hundred, change this often.
  constexpr double kDenseChanges = 0.15;  // per cell
  const int dx = goal.x - start.x;
  const int dy = goal.y - start.y;
  const int steps = std::max(std::abs(dx), std::abs(dy));
  int changes = 0;
  bool was_blocked = false;
  for (int i = 1; i <= steps; ++i) {
    const double part = static_cast<double>(i) / steps;
    const bool is_blocked = IsBlocked({start.x + static_cast<int>(part * dx),
                                       start.y + static_cast<int>(part * dy)});
    changes += is_blocked != was_blocked ? 1 : 0;
    was_blocked = is_blocked;
  }
  return changes > kDenseChanges * steps;
}

}  // namespace vfh_astar
