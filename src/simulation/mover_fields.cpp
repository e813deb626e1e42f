#include "vfh_astar/simulation/mover_fields.h"

#include <vector>

#include "vfh_astar/simulation/world_fields.h"

namespace vfh_astar {
namespace {

constexpr double kSlowest = 1e-3;  // m/s
constexpr double kFastest = 100.0;

Shape ReadMoverShape(const YamlField& group) {
  group.AllowOnly({"box", "cylinder"});
  const YamlField box = group["box"];
  const YamlField cylinder = group["cylinder"];
  if (box.Exists() == cylinder.Exists()) group.Fail("either box or cylinder");
  if (cylinder.Exists()) {
    cylinder.AllowOnly({"radius"});
    return MakeDisc(Eigen::Vector2d::Zero(),
                    cylinder["radius"].Number(kSmallestSize, kLargestSize));
  }
  box.AllowOnly({"size", "yaw"});
  const double yaw =
      box["yaw"].Exists() ? box["yaw"].Number(-2.0 * kPi, 2.0 * kPi) : 0.0;
  return MakeBox(Pose2D(0.0, 0.0, yaw), ReadSize(box["size"]));
}

/// The corners of the whole way, in order.
std::vector<Eigen::Vector2d> ReadWay(const YamlField& waypoints,
                                     const std::string& cycle) {
  std::vector<Eigen::Vector2d> way;
  for (const YamlField& item : waypoints.Items()) {
    const Eigen::Vector2d point = ReadPoint(item);
    if (!way.empty() && (point - way.back()).norm() < kSmallestSize) {
      item.Fail("another place than the waypoint before");
    }
    way.push_back(point);
  }
  if (way.size() < 2) waypoints.Fail("two waypoints [x, y] in m or more");
  if (cycle == "to_and_fro") {
    for (std::size_t i = way.size() - 1; i-- > 0;) way.push_back(way[i]);
  } else if (cycle == "loop") {
    if ((way.front() - way.back()).norm() < kSmallestSize) {
      waypoints.Fail("a last waypoint that is not the first one");
    }
    way.push_back(way.front());
  }
  return way;
}

void ReadWaypoints(const YamlField& field, Mover& mover) {
  const std::string cycle =
      field["cycle"].Exists()
          ? field["cycle"].Choice({"to_and_fro", "loop", "once"})
          : "to_and_fro";
  const double speed = field["speed"].Number(kSlowest, kFastest);
  double time = 0.0;
  for (const Eigen::Vector2d& place : ReadWay(field["waypoints"], cycle)) {
    if (!mover.keyframes.empty()) {
      time += (place - mover.keyframes.back().position).norm() / speed;
    }
    mover.keyframes.push_back({time, place});
  }
  mover.period = cycle == "once" ? 0.0 : time;
}

}  // namespace

Mover ReadMover(const YamlField& field, const std::string& name) {
  Mover mover;
  mover.name = name;
  if (field["waypoints"].Exists() == field["keyframes"].Exists()) {
    field.Fail("either waypoints or keyframes");
  }
  if (field["waypoints"].Exists()) {
    field.AllowOnly({"name", "shape", "waypoints", "speed", "cycle"});
    ReadWaypoints(field, mover);
  } else {
    field.AllowOnly({"name", "shape", "keyframes", "period"});
    mover.keyframes = ReadKeyframes(field["keyframes"]);
    if (field["period"].Exists()) {
      mover.period = ReadPeriod(field["period"], mover.keyframes);
    }
  }
  mover.shape = ReadMoverShape(field["shape"]);
  return mover;
}

}  // namespace vfh_astar
