#include "vfh_astar/simulation/world.h"

#include <algorithm>
#include <cassert>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "vfh_astar/simulation/bitmap_world.h"
#include "vfh_astar/simulation/dynabarn_world.h"
#include "vfh_astar/simulation/gazebo_world.h"
#include "vfh_astar/simulation/yaml_world.h"
#include "vfh_astar/yaml_field.h"

namespace vfh_astar {
namespace {

/// XML begins with '<', perhaps after a byte order mark, and YAML never does.
bool IsXml(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  char first = '\0';
  while (stream.get(first)) {
    const bool in_mark = static_cast<unsigned char>(first) >= 0x80;
    if (!std::isspace(static_cast<unsigned char>(first)) && !in_mark) break;
  }
  return first == '<';
}

World LoadByContent(const std::string& file, const WorldLoadOptions& options) {
  if (IsXml(file)) return LoadGazeboWorld(file);
  const YamlField root = YamlField::LoadFile(file);
  if (root["version"].Exists()) return ReadYamlWorld(root, options);
  if (root["obstacles"].Exists()) return ReadDynabarnWorld(root);
  if (root["image"].Exists()) return LoadBitmapWorld(file, options.solid_below);
  root.Fail(
      "a world (with `version`), a DynaBARN world (with `obstacles`) or a map "
      "(with `image`)");
}

}  // namespace

Eigen::Vector2d Mover::PositionAt(double time) const {
  assert(!keyframes.empty());
  if (period > 0.0) time -= period * std::floor(time / period);
  const auto after = std::upper_bound(
      keyframes.begin(), keyframes.end(), time,
      [](double t, const Keyframe& keyframe) { return t < keyframe.time; });
  if (after == keyframes.begin()) return keyframes.front().position;
  if (after == keyframes.end()) return keyframes.back().position;
  const Keyframe& before = *(after - 1);
  const double part = (time - before.time) / (after->time - before.time);
  return before.position + part * (after->position - before.position);
}

World LoadWorld(const std::string& file, const WorldLoadOptions& options) {
  World world;
  try {
    world = LoadByContent(file, options);
  } catch (const YamlFieldError& error) {
    throw WorldFileError(error.what());
  }
  if (world.name.empty()) {
    world.name = std::filesystem::path(file).stem().string();
  }
  if (world.robots.empty()) world.robots.push_back({kOnlyRobot, Pose2D()});
  return world;
}

}  // namespace vfh_astar
