#include "vfh_astar/parameters.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace vfh_astar {
namespace {

template <typename T>
void CheckRange(const std::string& name, T value, T min, T max) {
  // Written so that NaN fails.
  if (min <= value && value <= max) return;
  std::ostringstream message;
  message << "parameter " << name << " is " << value << "; expected " << min
          << " to " << max;
  throw ParameterError(message.str());
}

}  // namespace

std::string ParameterReader::Qualify(const std::string& name) {
  const std::string full = prefix_ + name;
  names_.insert(full);
  return full;
}

void ParameterReader::Number(const std::string& name, double& value, double min,
                             double max) {
  const std::string full = Qualify(name);
  const std::optional<double> found = FindNumber(full);
  if (!found) return;
  CheckRange(full, *found, min, max);
  value = *found;
}

void ParameterReader::Integer(const std::string& name, int& value, int min,
                              int max) {
  const std::string full = Qualify(name);
  const std::optional<int> found = FindInteger(full);
  if (!found) return;
  CheckRange(full, *found, min, max);
  value = *found;
}

void ParameterReader::Flag(const std::string& name, bool& value) {
  value = FindFlag(Qualify(name)).value_or(value);
}

void ParameterReader::Text(const std::string& name, std::string& value) {
  value = FindText(Qualify(name)).value_or(value);
}

void ParameterReader::Choice(const std::string& name, std::string& value,
                             const std::vector<std::string>& allowed) {
  const std::string full = Qualify(name);
  const std::optional<std::string> found = FindText(full);
  if (!found) return;
  if (std::find(allowed.begin(), allowed.end(), *found) == allowed.end()) {
    std::string list;
    for (const std::string& choice : allowed) {
      list += (list.empty() ? "" : ", ") + choice;
    }
    throw ParameterError("parameter " + full + " is '" + *found +
                         "'; expected one of " + list);
  }
  value = *found;
}

struct YamlParameterReader::Source {
  std::string file;
  std::string section;
  YAML::Node node;

  /// The entry with a name like "vfh/sector_angle", or nothing.
  std::optional<YAML::Node> Find(const std::string& name) const {
    YAML::Node at;
    at.reset(node);
    std::istringstream parts(name);
    for (std::string part; std::getline(parts, part, '/');) {
      if (!at.IsMap()) return std::nullopt;
      const YAML::Node& constant = at;
      const YAML::Node next = constant[part];
      if (!next.IsDefined()) return std::nullopt;
      at.reset(next);
    }
    return at;
  }

  template <typename T>
  std::optional<T> Convert(const std::string& name,
                           const std::string& expected) const {
    const std::optional<YAML::Node> found = Find(name);
    if (!found) return std::nullopt;
    try {
      return found->as<T>();
    } catch (const YAML::Exception&) {
      throw ParameterError(
          file + ":" + std::to_string(found->Mark().line + 1) + ": parameter " +
          section + "/" + name + " is '" +
          (found->IsScalar() ? found->Scalar() : "not a single value") +
          "'; expected " + expected);
    }
  }

  void RefuseUnknown(const YAML::Node& map, const std::string& prefix,
                     const std::set<std::string>& known) const {
    for (const auto& entry : map) {
      const std::string name = prefix + entry.first.as<std::string>();
      if (known.count(name) != 0) continue;
      const auto group = known.lower_bound(name + "/");
      const bool is_group =
          group != known.end() && group->rfind(name + "/", 0) == 0;
      if (!is_group || !entry.second.IsMap()) {
        throw ParameterError(file + ":" +
                             std::to_string(entry.first.Mark().line + 1) +
                             ": unknown parameter " + section + "/" + name);
      }
      RefuseUnknown(entry.second, name + "/", known);
    }
  }
};

YamlParameterReader::YamlParameterReader(const std::string& file,
                                         const std::string& section)
    : source_(std::make_unique<Source>()) {
  source_->file = file;
  source_->section = section;
  try {
    const YAML::Node root = YAML::LoadFile(file);
    if (root.IsMap() && root[section].IsDefined()) {
      source_->node.reset(root[section]);
    }
  } catch (const YAML::BadFile&) {
    throw ParameterError("cannot read the configuration file " + file);
  } catch (const YAML::Exception& error) {
    throw ParameterError(file + ":" + std::to_string(error.mark.line + 1) +
                         ": " + error.msg);
  }
}

YamlParameterReader::~YamlParameterReader() = default;

void YamlParameterReader::RefuseUnknownNames() const {
  if (source_->node.IsMap()) {
    source_->RefuseUnknown(source_->node, "", names());
  }
}

std::optional<double> YamlParameterReader::FindNumber(const std::string& name) {
  return source_->Convert<double>(name, "a number");
}

std::optional<int> YamlParameterReader::FindInteger(const std::string& name) {
  return source_->Convert<int>(name, "a whole number");
}

std::optional<bool> YamlParameterReader::FindFlag(const std::string& name) {
  return source_->Convert<bool>(name, "true or false");
}

std::optional<std::string> YamlParameterReader::FindText(
    const std::string& name) {
  return source_->Convert<std::string>(name, "a text");
}

}  // namespace vfh_astar
