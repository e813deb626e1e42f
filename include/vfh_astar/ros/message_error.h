#ifndef VFH_ASTAR_ROS_MESSAGE_ERROR_H_
#define VFH_ASTAR_ROS_MESSAGE_ERROR_H_

#include <stdexcept>

namespace vfh_astar {

/// A message that cannot be used; the text names the field, its value and what
/// was expected.
class MessageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_ROS_MESSAGE_ERROR_H_
