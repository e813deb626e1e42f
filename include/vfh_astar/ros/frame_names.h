#ifndef VFH_ASTAR_ROS_FRAME_NAMES_H_
#define VFH_ASTAR_ROS_FRAME_NAMES_H_

#include <string>

#include "vfh_astar/parameters.h"

namespace vfh_astar {

/// The frames of REP-105, by their names on tf.
struct FrameNames {
  std::string map_frame = "map";
  std::string odom_frame = "odom";
  std::string base_frame = "base_link";

  /// @throws ParameterError for a name that is empty or begins with a slash.
  void Read(ParameterReader& reader) {
    ReadName(reader, "map_frame", map_frame);
    ReadName(reader, "odom_frame", odom_frame);
    ReadName(reader, "base_frame", base_frame);
  }

 private:
  static void ReadName(ParameterReader& reader, const std::string& parameter,
                       std::string& frame) {
    reader.Text(parameter, frame);
    if (frame.empty() || frame[0] == '/') {
      throw ParameterError("parameter " + parameter + " is '" + frame +
                           "'; expected a frame id without a leading slash");
    }
  }
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_ROS_FRAME_NAMES_H_
