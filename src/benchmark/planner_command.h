#ifndef VFH_ASTAR_BENCHMARK_PLANNER_COMMAND_H_
#define VFH_ASTAR_BENCHMARK_PLANNER_COMMAND_H_

#include <string>
#include <vector>

namespace vfh_astar {

/// `planner --map M.map --scen M.map.scen [--limit N] [--longest N]`: the
/// queries of a MovingAI scenario, their figures as JSON on standard output.
/// @return the exit status: 0 when the queries were run, 2 for unusable
///   arguments.
/// @throws MovingAiError for unusable files.
int RunPlannerCommand(const std::vector<std::string>& arguments);

}  // namespace vfh_astar

#endif  // VFH_ASTAR_BENCHMARK_PLANNER_COMMAND_H_
