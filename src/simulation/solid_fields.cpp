#include "vfh_astar/simulation/solid_fields.h"

#include <filesystem>

#include "vfh_astar/simulation/bitmap_world.h"
#include "vfh_astar/simulation/world_fields.h"

namespace vfh_astar {
namespace {

constexpr double kUsualWallThickness = 0.1;  // m

std::vector<Shape> ReadBox(const YamlField& field, const WorldLoadOptions&) {
  return {MakeBox(ReadPose(field["pose"]), ReadSize(field["size"]))};
}

std::vector<Shape> ReadCylinder(const YamlField& field,
                                const WorldLoadOptions&) {
  return {MakeDisc(ReadPoint(field["position"]),
                   field["radius"].Number(kSmallestSize, kLargestSize))};
}

std::vector<Eigen::Vector2d> ReadPoints(const YamlField& field,
                                        std::size_t least) {
  std::vector<Eigen::Vector2d> points;
  for (const YamlField& item : field.Items()) {
    points.push_back(ReadPoint(item));
  }
  if (points.size() < least) {
    field.Fail(std::to_string(least) + " points [x, y] in m or more");
  }
  return points;
}

std::vector<Shape> ReadPolygon(const YamlField& field,
                               const WorldLoadOptions&) {
  std::vector<Shape> shapes = MakePolygon(ReadPoints(field["outline"], 3));
  if (shapes.empty()) {
    field["outline"].Fail("an outline with an area that never crosses itself");
  }
  return shapes;
}

std::vector<Shape> ReadWall(const YamlField& field, const WorldLoadOptions&) {
  const bool closed = field["closed"].Exists() && field["closed"].Flag();
  const double thickness =
      field["thickness"].Exists()
          ? field["thickness"].Number(kSmallestSize, kLargestSize)
          : kUsualWallThickness;
  const std::vector<Eigen::Vector2d> points =
      ReadPoints(field["points"], closed ? 3 : 2);
  for (std::size_t i = closed ? 0 : 1; i < points.size(); ++i) {
    const Eigen::Vector2d& before = points[i == 0 ? points.size() - 1 : i - 1];
    if ((points[i] - before).norm() < kSmallestSize) {
      field["points"].Items()[i].Fail("another place than the point before");
    }
  }
  return MakeWall(points, thickness, closed);
}

std::vector<Shape> ReadBitmap(const YamlField& field,
                              const WorldLoadOptions& options) {
  const int solid_below = field["solid_below"].Exists()
                              ? field["solid_below"].Integer(0, 256)
                              : options.solid_below;
  const std::filesystem::path folder =
      std::filesystem::path(field.file()).parent_path();
  const std::filesystem::path map = folder / field["map"].Text();
  if (!std::filesystem::is_regular_file(map)) {
    field["map"].Fail("a map's yaml file, from the folder of this file on");
  }
  return LoadBitmapShapes(map.string(), solid_below);
}

}  // namespace

const std::vector<SolidKind>& SolidKinds() {
  static const std::vector<SolidKind> kKinds = {
      {"box", "boxes", {"pose", "size"}, ReadBox},
      {"cylinder", "cylinders", {"position", "radius"}, ReadCylinder},
      {"polygon", "polygons", {"outline"}, ReadPolygon},
      {"wall", "walls", {"points", "thickness", "closed"}, ReadWall},
      {"bitmap", "bitmaps", {"map", "solid_below"}, ReadBitmap}};
  return kKinds;
}

std::vector<Shape> ReadSolid(const YamlField& group,
                             const WorldLoadOptions& options) {
  std::vector<std::string> names;
  const SolidKind* found = nullptr;
  int count = 0;
  for (const SolidKind& kind : SolidKinds()) {
    names.push_back(kind.name);
    if (!group[kind.name].Exists()) continue;
    found = &kind;
    ++count;
  }
  group.AllowOnly(names);
  if (count != 1) group.Fail("one solid, such as cylinder: {...}");
  const YamlField solid = group[found->name];
  solid.AllowOnly(found->keys);
  return found->read(solid, options);
}

}  // namespace vfh_astar
