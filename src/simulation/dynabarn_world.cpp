#include "vfh_astar/simulation/dynabarn_world.h"

#include <set>
#include <string>

#include "vfh_astar/simulation/world_fields.h"

namespace vfh_astar {
namespace {

constexpr double kArenaSize = 20.0;     // m
constexpr double kWallThickness = 0.5;  // m

StaticObstacle MakeArenaWall(const std::string& name, double x, double y,
                             const Eigen::Vector2d& size) {
  return {name, {MakeBox(Pose2D(x, y, 0.0), size)}};
}

Mover ReadMover(const YamlField& field, std::set<std::string>* names) {
  Mover mover;
  mover.name = field["name"].Text();
  if (!names->insert(mover.name).second) {
    field["name"].Fail("a name that nothing else has");
  }
  field["shape"].Choice({"cylinder"});
  mover.shape = MakeDisc(Eigen::Vector2d::Zero(),
                         field["radius"].Number(kSmallestSize, kLargestSize));
  mover.keyframes = ReadKeyframes(field["keyframes_t_x_y"]);
  mover.period = ReadPeriod(field["period_s"], mover.keyframes);
  return mover;
}

}  // namespace

World ReadDynabarnWorld(const YamlField& root) {
  World world;
  const double side = 0.5 * kArenaSize;
  const Eigen::Vector2d along_x(kArenaSize, kWallThickness);
  const Eigen::Vector2d along_y(kWallThickness, kArenaSize);
  world.obstacles = {MakeArenaWall("back_wall", -side, 0.0, along_y),
                     MakeArenaWall("top_wall", 0.0, side, along_x),
                     MakeArenaWall("bottom_wall", 0.0, -side, along_x)};
  std::set<std::string> names = {kOnlyRobot};
  for (const StaticObstacle& wall : world.obstacles) names.insert(wall.name);
  for (const YamlField& obstacle : root["obstacles"].Items()) {
    world.movers.push_back(ReadMover(obstacle, &names));
  }
  world.robots.push_back({kOnlyRobot, ReadPose(root["start"])});
  world.goal = ReadGoal(root["goal"], world.robots[0].pose);
  return world;
}

}  // namespace vfh_astar
