#include "benchmark/pose_option.h"

#include <sstream>

#include "benchmark/command.h"

namespace vfh_astar {

Pose2D ParsePoseOption(const std::string& option, const std::string& text) {
  Pose2D pose;
  char comma1 = 0;
  char comma2 = 0;
  std::istringstream stream(text);
  stream >> pose.x >> comma1 >> pose.y >> comma2 >> pose.theta;
  if (!stream || comma1 != ',' || comma2 != ',' || !stream.eof()) {
    throw OptionError("--" + option + " is '" + text + "'; expected X,Y,YAW");
  }
  return pose;
}

}  // namespace vfh_astar
