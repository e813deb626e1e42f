#ifndef VFH_ASTAR_BENCHMARK_DRIVE_COMMAND_H_
#define VFH_ASTAR_BENCHMARK_DRIVE_COMMAND_H_

#include <string>
#include <vector>

namespace vfh_astar {

/// `drive --world FILE [--start X,Y,YAW] [--goal X,Y,YAW] [--config FILE]
/// [--laser NAME] [--noise NAME] [--seed N] [--time-limit S] [--trace CSV]`:
/// one drive, its result as JSON on standard output.
/// @return the exit status: 0 when the drive could be made, whatever came of
///   it; 2 for unusable arguments.
/// @throws WorldFileError, MapFileError, ParameterError for unusable files.
int RunDriveCommand(const std::vector<std::string>& arguments);

}  // namespace vfh_astar

#endif  // VFH_ASTAR_BENCHMARK_DRIVE_COMMAND_H_
