#ifndef VFH_ASTAR_SIMULATION_SDF_ELEMENT_H_
#define VFH_ASTAR_SIMULATION_SDF_ELEMENT_H_

#include <tinyxml2.h>

#include <cstddef>
#include <string>
#include <vector>

#include "vfh_astar/geometry.h"

namespace vfh_astar {

/// A pose in the plane with its height above the ground.
struct UprightPose {
  Pose2D pose;
  double z = 0.0;  ///< m

  UprightPose operator*(const UprightPose& other) const {
    return {pose * other.pose, z + other.z};
  }
};

/// An element of an SDF file that knows its file and line. Every method throws
/// WorldFileError for what it cannot give.
class SdfElement {
 public:
  /// @param[in] element not null; outlived by its document.
  SdfElement(std::string file, const tinyxml2::XMLElement* element)
      : file_(std::move(file)), element_(element) {}

  std::string tag() const { return element_->Name(); }

  /// The attribute `name`, which must be there and not empty.
  std::string name() const;

  bool Has(const char* tag) const {
    return element_->FirstChildElement(tag) != nullptr;
  }
  /// The first child of a tag.
  SdfElement Child(const char* tag) const;
  /// All children of a tag; of any tag when it is null.
  std::vector<SdfElement> Children(const char* tag = nullptr) const;

  /// The text without white space around it; empty when there is none.
  std::string Text() const;
  /// Finite numbers, as many as `count`.
  std::vector<double> Numbers(std::size_t count) const;
  /// A number above 0.
  double Length() const;
  bool Flag() const;

  /// The child <pose>; the origin where there is none. It must be upright and
  /// relative to the parent.
  UprightPose Pose() const;

  /// @throws WorldFileError `file:line: <tag>: found; expected ...`.
  [[noreturn]] void Fail(const std::string& found,
                         const std::string& expected) const;

 private:
  std::string file_;
  const tinyxml2::XMLElement* element_;
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_SIMULATION_SDF_ELEMENT_H_
