#ifndef VFH_ASTAR_ROS_ROS_PARAMETER_READER_H_
#define VFH_ASTAR_ROS_ROS_PARAMETER_READER_H_

#include <XmlRpcValue.h>
#include <ros/console.h>
#include <ros/node_handle.h>

#include <optional>
#include <string>
#include <vector>

#include "vfh_astar/parameters.h"

namespace vfh_astar {

/// A ParameterReader over a namespace of the parameter server. Reads it once,
/// when constructed.
class RosParameterReader : public ParameterReader {
 public:
  /// @param[in] node whose namespace is read: a nodelet's private handle.
  explicit RosParameterReader(const ros::NodeHandle& node);

  /// @param[in] parameters a struct, or invalid for none at all.
  /// @param[in] prefix of the names in messages, e.g. "/navigator".
  RosParameterReader(const XmlRpc::XmlRpcValue& parameters, std::string prefix);

  /// The names in the namespace that nobody asked for: most often misspelt
  /// ones.
  std::vector<std::string> UnknownNames() const;

 protected:
  std::optional<double> FindNumber(const std::string& name) override;
  std::optional<int> FindInteger(const std::string& name) override;
  std::optional<bool> FindFlag(const std::string& name) override;
  std::optional<std::string> FindText(const std::string& name) override;

 private:
  std::optional<XmlRpc::XmlRpcValue> Find(const std::string& name) const;
  [[noreturn]] void Refuse(const std::string& name,
                           const XmlRpc::XmlRpcValue& value,
                           const std::string& expected) const;

  XmlRpc::XmlRpcValue parameters_;
  std::string prefix_;
};

/// Reads the private parameters of a nodelet. Unknown names are warned about.
/// @throws ParameterError as ParameterReader does, after saying so in the log;
///   thrown on, it keeps the nodelet from starting.
template <typename Parameters>
Parameters ReadParameters(const ros::NodeHandle& private_node) {
  RosParameterReader reader(private_node);
  Parameters parameters;
  try {
    parameters.Read(reader);
  } catch (const ParameterError& error) {
    ROS_FATAL("%s: %s", private_node.getNamespace().c_str(), error.what());
    throw;
  }
  for (const std::string& name : reader.UnknownNames()) {
    ROS_WARN("unknown parameter %s/%s", private_node.getNamespace().c_str(),
             name.c_str());
  }
  return parameters;
}

}  // namespace vfh_astar

#endif  // VFH_ASTAR_ROS_ROS_PARAMETER_READER_H_
