#include "vfh_astar/simulation/sdf_element.h"

#include <cmath>
#include <cstdio>
#include <locale>
#include <sstream>

#include "vfh_astar/simulation/world.h"

namespace vfh_astar {
namespace {

// Saved worlds have such tilts where a body had come to rest.
constexpr double kLargestTilt = 1e-3;  // rad
constexpr double kFarthest = 1e5;      // m

}  // namespace

std::string SdfElement::name() const {
  const char* name = element_->Attribute("name");
  if (name == nullptr || *name == '\0') Fail("no name", "a name");
  return name;
}

SdfElement SdfElement::Child(const char* tag) const {
  const tinyxml2::XMLElement* child = element_->FirstChildElement(tag);
  if (child == nullptr) {
    Fail("no <" + std::string(tag) + "> in it", "a <" + std::string(tag) + ">");
  }
  return SdfElement(file_, child);
}

std::vector<SdfElement> SdfElement::Children(const char* tag) const {
  std::vector<SdfElement> children;
  for (const auto* child = element_->FirstChildElement(tag); child != nullptr;
       child = child->NextSiblingElement(tag)) {
    children.emplace_back(file_, child);
  }
  return children;
}

std::string SdfElement::Text() const {
  const char* text = element_->GetText();
  const std::string whole = text == nullptr ? "" : text;
  const char* const space = " \t\r\n";
  const std::size_t begin = whole.find_first_not_of(space);
  if (begin == std::string::npos) return "";
  return whole.substr(begin, whole.find_last_not_of(space) - begin + 1);
}

std::vector<double> SdfElement::Numbers(std::size_t count) const {
  std::istringstream text(Text());
  std::vector<double> numbers;
  bool all_good = true;
  for (std::string word; text >> word;) {
    std::istringstream stream(word);
    stream.imbue(std::locale::classic());
    double number = 0.0;
    all_good = all_good && stream >> number && stream.peek() == EOF &&
               std::abs(number) <= kFarthest;
    numbers.push_back(number);
  }
  if (!all_good || numbers.size() != count) {
    Fail("'" + Text() + "'",
         count == 1 ? "a number" : std::to_string(count) + " numbers");
  }
  return numbers;
}

double SdfElement::Length() const {
  const double length = Numbers(1)[0];
  if (length <= 0.0) Fail("'" + Text() + "'", "a length above 0 m");
  return length;
}

bool SdfElement::Flag() const {
  const std::string text = Text();
  if (text == "1" || text == "true") return true;
  if (text == "0" || text == "false") return false;
  Fail("'" + text + "'", "true, false, 1 or 0");
}

UprightPose SdfElement::Pose() const {
  if (!Has("pose")) return {};
  const SdfElement pose = Child("pose");
  for (const auto* attribute = pose.element_->FirstAttribute();
       attribute != nullptr; attribute = attribute->Next()) {
    if (*attribute->Value() != '\0') {
      pose.Fail(
          std::string(attribute->Name()) + "='" + attribute->Value() + "'",
          "a pose relative to its parent, in m and rad");
    }
  }
  const std::vector<double> n = pose.Numbers(6);
  if (std::abs(n[3]) > kLargestTilt || std::abs(n[4]) > kLargestTilt) {
    pose.Fail("'" + pose.Text() + "'", "roll and pitch of 0");
  }
  return {Pose2D(n[0], n[1], NormalizeAngle(n[5])), n[2]};
}

void SdfElement::Fail(const std::string& found,
                      const std::string& expected) const {
  throw WorldFileError(file_ + ":" + std::to_string(element_->GetLineNum()) +
                       ": <" + element_->Name() + ">: " + found +
                       "; expected " + expected);
}

}  // namespace vfh_astar
