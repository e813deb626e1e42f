#include "vfh_astar/yaml_field.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>

namespace vfh_astar {
namespace {

constexpr std::size_t kLongestQuote = 40;

std::string Join(const std::vector<std::string>& parts) {
  std::string joined;
  for (const std::string& part : parts) {
    joined += (joined.empty() ? "" : ", ") + part;
  }
  return joined;
}

std::string NumberRange(const std::string& kind, double min, double max) {
  std::ostringstream text;
  text << kind << " from " << min << " to " << max;
  return text.str();
}

std::string Quote(const std::string& text) {
  return "'" +
         (text.size() > kLongestQuote ? text.substr(0, kLongestQuote) + "..."
                                      : text) +
         "'";
}

/// The line, from 1, of the first tab that indents something; 0 for none.
int FindIndentingTab(const std::string& text) {
  std::istringstream lines(text);
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    const std::size_t entry = line.find_first_not_of(" \t\r");
    if (entry != std::string::npos && line.find('\t') < entry) return number;
  }
  return 0;
}

/// Why a text that yaml-cpp has refused is no YAML, and where.
std::string DescribeDefect(const std::string& text,
                           const YAML::Exception& error) {
  if (text.find('\0') != std::string::npos) {
    return ":1: bytes that are no text; expected a YAML document";
  }
  if (const int line = FindIndentingTab(text)) {
    return ":" + std::to_string(line) +
           ": a tab before an entry; expected spaces";
  }
  return ":" + std::to_string(error.mark.line + 1) + ": " + error.msg +
         "; expected a YAML document";
}

}  // namespace

YamlField YamlField::LoadFile(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  // A folder can be opened; only reading from it fails.
  stream.peek();
  if (!stream.is_open() || stream.bad()) {
    throw YamlFieldError(file + ": cannot be read; expected a readable file");
  }
  const std::string text((std::istreambuf_iterator<char>(stream)),
                         std::istreambuf_iterator<char>());
  YamlField root(file, "", 1);
  try {
    root.node_.emplace(YAML::Load(text));
  } catch (const YAML::Exception& error) {
    throw YamlFieldError(file + DescribeDefect(text, error));
  }
  return root;
}

YamlField YamlField::Child(const std::string& path,
                           const YAML::Node& node) const {
  YamlField child(file_, path, line_);
  if (node.IsDefined()) {
    child.node_.emplace(node);
    if (!node.Mark().is_null()) child.line_ = node.Mark().line + 1;
  }
  return child;
}

YamlField YamlField::operator[](const std::string& key) const {
  const std::string path = path_.empty() ? key : path_ + "." + key;
  if (!Exists()) return YamlField(file_, path, line_);
  if (!node_->IsMap()) Fail("entries with names");
  // Subscripting a node that is not const would add the key.
  const YAML::Node& constant = *node_;
  return Child(path, constant[key]);
}

std::vector<YamlField> YamlField::Items() const {
  std::vector<YamlField> items;
  if (!Exists()) return items;
  if (!node_->IsSequence()) Fail("a list");
  for (std::size_t i = 0; i < node_->size(); ++i) {
    const YAML::Node& constant = *node_;
    items.push_back(Child(path_ + "[" + std::to_string(i) + "]", constant[i]));
  }
  return items;
}

std::size_t YamlField::size() const {
  return Exists() && node_->IsSequence() ? node_->size() : 0;
}

void YamlField::AllowOnly(const std::vector<std::string>& known) const {
  if (!Exists() || !node_->IsMap()) Fail("entries out of " + Join(known));
  std::set<std::string> seen;
  for (const auto& entry : *node_) {
    const std::string key = entry.first.IsScalar() ? entry.first.Scalar()
                                                   : "a key of several parts";
    YamlField place(file_, path_, entry.first.Mark().line + 1);
    place.node_.emplace(entry.first);
    if (std::find(known.begin(), known.end(), key) == known.end()) {
      place.Fail("one of " + Join(known));
    }
    if (!seen.insert(key).second) place.Fail("each entry once");
  }
}

double YamlField::Number(double min, double max) const {
  double value = NAN;
  if (!node_ || !node_->IsScalar() ||
      !YAML::convert<double>::decode(*node_, value) ||
      !(min <= value && value <= max)) {
    Fail(NumberRange("a number", min, max));
  }
  return value;
}

int YamlField::Integer(int min, int max) const {
  int value = 0;
  if (!node_ || !node_->IsScalar() ||
      !YAML::convert<int>::decode(*node_, value) || value < min ||
      value > max) {
    Fail(NumberRange("a whole number", min, max));
  }
  return value;
}

bool YamlField::Flag() const {
  bool value = false;
  if (node_ && node_->IsScalar()) {
    if (node_->Scalar() == "0") return false;
    if (node_->Scalar() == "1") return true;
    if (YAML::convert<bool>::decode(*node_, value)) return value;
  }
  Fail("true or false");
}

std::string YamlField::Text() const {
  if (!node_ || !node_->IsScalar() || node_->Scalar().empty()) Fail("a text");
  return node_->Scalar();
}

std::string YamlField::Choice(const std::vector<std::string>& allowed) const {
  if (!node_ || !node_->IsScalar() ||
      std::find(allowed.begin(), allowed.end(), node_->Scalar()) ==
          allowed.end()) {
    Fail("one of " + Join(allowed));
  }
  return node_->Scalar();
}

std::vector<double> YamlField::Numbers(std::size_t count, double limit,
                                       const std::string& form) const {
  if (!Exists() || !node_->IsSequence() || node_->size() != count) Fail(form);
  std::vector<double> numbers;
  for (const YamlField& item : Items()) {
    numbers.push_back(item.Number(-limit, limit));
  }
  return numbers;
}

std::string YamlField::Found() const {
  if (!Exists()) return "missing";
  if (node_->IsScalar()) return Quote(node_->Scalar());
  if (node_->IsMap()) return "a group of entries";
  std::string list;
  for (const auto& item : *node_) {
    list += (list.empty() ? "" : ", ") +
            (item.IsScalar() ? item.Scalar() : std::string("..."));
    if (list.size() > kLongestQuote) return Quote("[" + list);
  }
  return "[" + list + "]";
}

void YamlField::Fail(const std::string& expected) const {
  throw YamlFieldError(file_ + ":" + std::to_string(line_) + ": " +
                       (path_.empty() ? "" : path_ + ": ") + Found() +
                       "; expected " + expected);
}

}  // namespace vfh_astar
