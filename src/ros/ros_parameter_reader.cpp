#include "vfh_astar/ros/ros_parameter_reader.h"

#include <sstream>
#include <utility>

namespace vfh_astar {
namespace {

using XmlRpc::XmlRpcValue;

XmlRpcValue FetchNamespace(const ros::NodeHandle& node) {
  XmlRpcValue parameters;
  node.getParam(node.getNamespace(), parameters);
  return parameters;
}

void AddUnknown(const XmlRpcValue& parameters, const std::string& prefix,
                const std::set<std::string>& known,
                std::vector<std::string>& unknown) {
  for (const auto& entry : parameters) {
    const std::string name = prefix + entry.first;
    if (known.count(name) != 0) continue;
    const auto group = known.lower_bound(name + "/");
    const bool is_group =
        group != known.end() && group->rfind(name + "/", 0) == 0;
    if (is_group && entry.second.getType() == XmlRpcValue::TypeStruct) {
      AddUnknown(entry.second, name + "/", known, unknown);
    } else {
      unknown.push_back(name);
    }
  }
}

}  // namespace

RosParameterReader::RosParameterReader(const ros::NodeHandle& node)
    : RosParameterReader(FetchNamespace(node), node.getNamespace()) {}

RosParameterReader::RosParameterReader(const XmlRpcValue& parameters,
                                       std::string prefix)
    : parameters_(parameters), prefix_(std::move(prefix)) {}

std::vector<std::string> RosParameterReader::UnknownNames() const {
  std::vector<std::string> unknown;
  if (parameters_.getType() == XmlRpcValue::TypeStruct) {
    AddUnknown(parameters_, "", names(), unknown);
  }
  return unknown;
}

std::optional<XmlRpcValue> RosParameterReader::Find(
    const std::string& name) const {
  XmlRpcValue at = parameters_;
  std::istringstream parts(name);
  for (std::string part; std::getline(parts, part, '/');) {
    if (at.getType() != XmlRpcValue::TypeStruct || !at.hasMember(part)) {
      return std::nullopt;
    }
    const XmlRpcValue next = at[part];
    at = next;
  }
  return at;
}

void RosParameterReader::Refuse(const std::string& name,
                                const XmlRpcValue& value,
                                const std::string& expected) const {
  std::ostringstream found;
  value.write(found);
  throw ParameterError("parameter " + prefix_ + "/" + name + " is " +
                       found.str() + "; expected " + expected);
}

std::optional<double> RosParameterReader::FindNumber(const std::string& name) {
  std::optional<XmlRpcValue> found = Find(name);
  if (!found) return std::nullopt;
  if (found->getType() == XmlRpcValue::TypeInt) {
    return static_cast<int>(*found);
  }
  if (found->getType() == XmlRpcValue::TypeDouble) {
    return static_cast<double>(*found);
  }
  Refuse(name, *found, "a number");
}

std::optional<int> RosParameterReader::FindInteger(const std::string& name) {
  std::optional<XmlRpcValue> found = Find(name);
  if (!found) return std::nullopt;
  if (found->getType() == XmlRpcValue::TypeInt) {
    return static_cast<int>(*found);
  }
  Refuse(name, *found, "a whole number");
}

std::optional<bool> RosParameterReader::FindFlag(const std::string& name) {
  std::optional<XmlRpcValue> found = Find(name);
  if (!found) return std::nullopt;
  if (found->getType() == XmlRpcValue::TypeBoolean) {
    return static_cast<bool>(*found);
  }
  Refuse(name, *found, "true or false");
}

std::optional<std::string> RosParameterReader::FindText(
    const std::string& name) {
  std::optional<XmlRpcValue> found = Find(name);
  if (!found) return std::nullopt;
  if (found->getType() == XmlRpcValue::TypeString) {
    return static_cast<std::string>(*found);
  }
  Refuse(name, *found, "a text");
}

}  // namespace vfh_astar
