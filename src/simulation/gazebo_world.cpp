#include "vfh_astar/simulation/gazebo_world.h"

#include <cmath>
#include <map>
#include <set>

#include "vfh_astar/simulation/sdf_element.h"

namespace vfh_astar {
namespace {

/// m; a Jackal with its laser is lower.
constexpr double kRobotHeight = 0.5;

bool IsInTheWay(double z, double height) {
  return z + 0.5 * height > 0.0 && z - 0.5 * height < kRobotHeight;
}

/// The shapes of one collision: one or none.
std::vector<Shape> ReadCollision(const SdfElement& collision,
                                 const UprightPose& link) {
  const UprightPose place = link * collision.Pose();
  for (const SdfElement& geometry : collision.Child("geometry").Children()) {
    if (geometry.tag() == "box") {
      const SdfElement size = geometry.Child("size");
      const std::vector<double> n = size.Numbers(3);
      if (n[0] <= 0.0 || n[1] <= 0.0 || n[2] <= 0.0) {
        size.Fail("'" + size.Text() + "'", "three lengths above 0 m");
      }
      if (!IsInTheWay(place.z, n[2])) return {};
      return {MakeBox(place.pose, Eigen::Vector2d(n[0], n[1]))};
    }
    if (geometry.tag() == "cylinder") {
      const double radius = geometry.Child("radius").Length();
      const double length = geometry.Child("length").Length();
      if (!IsInTheWay(place.z, length)) return {};
      return {MakeDisc(place.pose.position(), radius)};
    }
    if (geometry.tag() != "plane" && geometry.tag() != "empty") {
      geometry.Fail("a shape that has no counterpart here",
                    "a box, a cylinder or a plane");
    }
  }
  return {};
}

std::vector<Shape> ReadLink(const SdfElement& link, const UprightPose& model) {
  const UprightPose place = model * link.Pose();
  std::vector<Shape> shapes;
  for (const SdfElement& collision : link.Children("collision")) {
    for (Shape& shape : ReadCollision(collision, place)) {
      shapes.push_back(std::move(shape));
    }
  }
  return shapes;
}

/// The shapes of a model and of the models in it.
std::vector<Shape> ReadModel(const SdfElement& model, const UprightPose& place,
                             bool outer_is_static) {
  for (const SdfElement& child : model.Children("include")) {
    child.Fail("another file", "models written out in full");
  }
  const bool is_static =
      outer_is_static || (model.Has("static") && model.Child("static").Flag());
  std::vector<Shape> shapes;
  for (const SdfElement& link : model.Children("link")) {
    for (Shape& shape : ReadLink(link, place)) {
      shapes.push_back(std::move(shape));
    }
  }
  for (const SdfElement& inner : model.Children("model")) {
    for (Shape& shape : ReadModel(inner, place * inner.Pose(), is_static)) {
      shapes.push_back(std::move(shape));
    }
  }
  if (!shapes.empty() && !is_static) {
    model.Fail("'" + model.name() + "' is not static", "<static>1</static>");
  }
  if (!shapes.empty() && model.Has("plugin")) {
    model.Child("plugin").Fail("a program that may move the model",
                               "models that stand still");
  }
  return shapes;
}

/// Where the models were when the world was saved, by name.
std::map<std::string, UprightPose> ReadSavedPoses(const SdfElement& world) {
  std::map<std::string, UprightPose> poses;
  for (const SdfElement& state : world.Children("state")) {
    for (const SdfElement& inserted : state.Children("insertions")) {
      inserted.Fail("models", "them in <world>, not in <state>");
    }
    for (const SdfElement& model : state.Children("model")) {
      if (model.Has("scale")) {
        const SdfElement scale = model.Child("scale");
        const std::vector<double> n = scale.Numbers(3);
        if (n[0] != 1.0 || n[1] != 1.0 || n[2] != 1.0) {
          scale.Fail("'" + scale.Text() + "'", "a scale of 1 1 1");
        }
      }
      if (model.Has("pose")) poses[model.name()] = model.Pose();
    }
  }
  return poses;
}

void RefuseOthers(const SdfElement& world) {
  for (const SdfElement& include : world.Children("include")) {
    const std::string uri = include.Child("uri").Text();
    if (uri != "model://ground_plane" && uri != "model://sun") {
      include.Fail("'" + uri + "'", "models written out in full");
    }
  }
  for (const char* const tag : {"actor", "population"}) {
    if (world.Has(tag)) {
      world.Child(tag).Fail("no counterpart here", "static models");
    }
  }
}

}  // namespace

World LoadGazeboWorld(const std::string& file) {
  tinyxml2::XMLDocument document;
  if (document.LoadFile(file.c_str()) != tinyxml2::XML_SUCCESS) {
    throw WorldFileError(file + ":" + std::to_string(document.ErrorLineNum()) +
                         ": " + document.ErrorName() +
                         "; expected well-formed XML");
  }
  if (document.RootElement() == nullptr) {
    throw WorldFileError(file + ":1: no element; expected <sdf>");
  }
  const SdfElement root(file, document.RootElement());
  if (root.tag() != "sdf") root.Fail("the outermost element", "<sdf>");
  const SdfElement world_element = root.Child("world");
  RefuseOthers(world_element);
  const std::map<std::string, UprightPose> saved =
      ReadSavedPoses(world_element);
  World world;
  std::set<std::string> names = {kOnlyRobot};
  for (const SdfElement& model : world_element.Children("model")) {
    const std::string name = model.name();
    const auto found = saved.find(name);
    std::vector<Shape> shapes = ReadModel(
        model, found == saved.end() ? model.Pose() : found->second, false);
    if (shapes.empty()) continue;
    if (!names.insert(name).second) {
      model.Fail("'" + name + "'", "a name that nothing else has");
    }
    world.obstacles.push_back({name, std::move(shapes)});
  }
  return world;
}

}  // namespace vfh_astar
