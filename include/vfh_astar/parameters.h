#ifndef VFH_ASTAR_PARAMETERS_H_
#define VFH_ASTAR_PARAMETERS_H_

#include <memory>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace vfh_astar {

/// A parameter that cannot be used; the message names it, its value and what is
/// allowed.
class ParameterError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Fills parameter structs from a source of named values (a YAML file, the
/// parameter server). A struct has its defaults beside its members and one
/// method `void Read(ParameterReader&)` that names each member and its range;
/// so checking and naming exist once, whatever the source is.
///
/// A name that the source does not have leaves the default in place. Every
/// method throws ParameterError for a value of the wrong type or out of range.
class ParameterReader {
 public:
  virtual ~ParameterReader() = default;

  void Number(const std::string& name, double& value, double min, double max);
  void Integer(const std::string& name, int& value, int min, int max);
  void Flag(const std::string& name, bool& value);
  void Text(const std::string& name, std::string& value);
  /// A text out of a fixed list.
  void Choice(const std::string& name, std::string& value,
              const std::vector<std::string>& allowed);

  /// Reads a struct whose names lie below `name`.
  template <typename Parameters>
  void Group(const std::string& name, Parameters& parameters) {
    const std::string outer = prefix_;
    prefix_ += name + "/";
    parameters.Read(*this);
    prefix_ = outer;
  }

  /// The full names asked for so far, groups separated by '/'.
  const std::set<std::string>& names() const { return names_; }

 protected:
  /// Each returns nothing when the source has no such name and throws
  /// ParameterError when it has one of another type. Whole numbers are numbers.
  virtual std::optional<double> FindNumber(const std::string& name) = 0;
  virtual std::optional<int> FindInteger(const std::string& name) = 0;
  virtual std::optional<bool> FindFlag(const std::string& name) = 0;
  virtual std::optional<std::string> FindText(const std::string& name) = 0;

 private:
  std::string Qualify(const std::string& name);

  std::string prefix_;
  std::set<std::string> names_;
};

/// A ParameterReader over one section of a YAML configuration file. The top
/// level of such a file has a section for each component: grid_mapper,
/// path_planner, trajectory_fitter, navigator.
class YamlParameterReader : public ParameterReader {
 public:
  /// A file without the section reads as an empty one.
  /// @throws ParameterError when the file cannot be read or parsed.
  YamlParameterReader(const std::string& file, const std::string& section);
  ~YamlParameterReader() override;

  /// @throws ParameterError naming the first entry of the section that nobody
  ///   asked for: most often a misspelt name.
  void RefuseUnknownNames() const;

 protected:
  std::optional<double> FindNumber(const std::string& name) override;
  std::optional<int> FindInteger(const std::string& name) override;
  std::optional<bool> FindFlag(const std::string& name) override;
  std::optional<std::string> FindText(const std::string& name) override;

 private:
  struct Source;
  std::unique_ptr<Source> source_;
};

/// Reads one component's parameters from a configuration file.
/// @throws ParameterError as YamlParameterReader does, and for unknown names.
template <typename Parameters>
Parameters LoadParameters(const std::string& file, const std::string& section) {
  YamlParameterReader reader(file, section);
  Parameters parameters;
  parameters.Read(reader);
  reader.RefuseUnknownNames();
  return parameters;
}

}  // namespace vfh_astar

#endif  // VFH_ASTAR_PARAMETERS_H_
