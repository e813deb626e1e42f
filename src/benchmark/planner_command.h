#ifndef VFH_ASTAR_BENCHMARK_PLANNER_COMMAND_H_
#define VFH_ASTAR_BENCHMARK_PLANNER_COMMAND_H_

#include "benchmark/command.h"

namespace vfh_astar {

/// `planner`: the queries of a MovingAI scenario.
/// Its run throws MovingAiError for unusable files.
Command PlannerCommand();

}  // namespace vfh_astar

#endif  // VFH_ASTAR_BENCHMARK_PLANNER_COMMAND_H_
