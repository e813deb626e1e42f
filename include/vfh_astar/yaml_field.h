#ifndef VFH_ASTAR_YAML_FIELD_H_
#define VFH_ASTAR_YAML_FIELD_H_

#include <yaml-cpp/yaml.h>

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace vfh_astar {

/// An entry of a YAML file that cannot be used. The message reads
/// `file:line: field: found; expected ...`.
class YamlFieldError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// An entry of a YAML (or JSON) document that knows where it stands: its file,
/// line and path, such as `movers[0].speed`. It may be missing; whoever asks
/// for its value then gets the error that tells so. Every conversion throws
/// YamlFieldError when the entry is missing, of another type or out of range.
class YamlField {
 public:
  /// The root of the document in a file.
  /// @throws YamlFieldError when the file cannot be read or is no YAML.
  static YamlField LoadFile(const std::string& file);

  /// False for an entry that the document does not have, or has without a
  /// value.
  bool Exists() const { return node_.has_value() && !node_->IsNull(); }

  /// The entry `key` below this one, perhaps missing.
  /// @throws YamlFieldError when this exists and is no map.
  YamlField operator[](const std::string& key) const;

  /// The entries of a list; none when it is missing.
  std::vector<YamlField> Items() const;

  /// @throws YamlFieldError for a key that is not in `known` or stands twice.
  void AllowOnly(const std::vector<std::string>& known) const;

  /// A finite number within min and max.
  double Number(double min, double max) const;
  int Integer(int min, int max) const;
  /// true or false, also as 1 or 0.
  bool Flag() const;
  /// A text that is not empty.
  std::string Text() const;
  /// A text out of a fixed list.
  std::string Choice(const std::vector<std::string>& allowed) const;
  /// A list of `count` numbers, each within +-limit.
  /// @param[in] form what is expected, for the error, such as "[x, y]".
  std::vector<double> Numbers(std::size_t count, double limit,
                              const std::string& form) const;
  /// How many entries a list has; 0 when it is missing or no list.
  std::size_t size() const;

  /// @throws YamlFieldError with this entry's place, what was found in it, and
  ///   `expected`.
  [[noreturn]] void Fail(const std::string& expected) const;

  const std::string& file() const { return file_; }

 private:
  YamlField(std::string file, std::string path, int line)
      : file_(std::move(file)), path_(std::move(path)), line_(line) {}

  YamlField Child(const std::string& path, const YAML::Node& node) const;
  std::string Found() const;

  std::string file_;
  std::string path_;  // empty for the root.
  int line_;          // from 1; of the nearest entry that exists.
  std::optional<YAML::Node> node_;
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_YAML_FIELD_H_
