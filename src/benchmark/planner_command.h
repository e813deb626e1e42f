#ifndef VFH_ASTAR_BENCHMARK_PLANNER_COMMAND_H_
#define VFH_ASTAR_BENCHMARK_PLANNER_COMMAND_H_

#include "benchmark/command.h"

namespace vfh_astar {

/// `planner`: the queries of a MovingAI scenario, or random ones on a
/// map_server map. Its run throws MovingAiError or MapFileError for unusable
/// files and WorldPlannerError for an unusable map.
Command PlannerCommand();

}  // namespace vfh_astar

#endif  // VFH_ASTAR_BENCHMARK_PLANNER_COMMAND_H_
