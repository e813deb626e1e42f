#ifndef VFH_ASTAR_BENCHMARK_POSE_OPTION_H_
#define VFH_ASTAR_BENCHMARK_POSE_OPTION_H_

#include <string>

#include "vfh_astar/geometry.h"

namespace vfh_astar {

/// Reads a pose from the command line.
/// @param[in] option its name, for the message.
/// @param[in] text X,Y,YAW (m, m, rad).
/// @throws OptionError
Pose2D ParsePoseOption(const std::string& option, const std::string& text);

}  // namespace vfh_astar

#endif  // VFH_ASTAR_BENCHMARK_POSE_OPTION_H_
