#include "vfh_astar/simulation/yaml_world.h"

#include <algorithm>
#include <cctype>
#include <set>

#include "vfh_astar/simulation/jackal.h"
#include "vfh_astar/simulation/mover_fields.h"
#include "vfh_astar/simulation/solid_fields.h"
#include "vfh_astar/simulation/world_fields.h"

namespace vfh_astar {
namespace {

/// The names of a world, robots' among them.
class Names {
 public:
  void Reserve(const std::string& name) { taken_.insert(name); }

  /// The entry's name, else its kind and its place in the list, from 1.
  std::string Read(const YamlField& field, const std::string& kind,
                   std::size_t place) {
    const YamlField given = field["name"];
    const std::string name =
        given.Exists() ? given.Text() : kind + "_" + std::to_string(place + 1);
    if (!taken_.insert(name).second) {
      (given.Exists() ? given : field)
          .Fail("a name that nothing else has; there is a '" + name +
                "' already");
    }
    return name;
  }

 private:
  std::set<std::string> taken_;
};

std::vector<std::string> WithName(std::vector<std::string> keys) {
  keys.insert(keys.begin(), "name");
  return keys;
}

std::vector<StaticObstacle> ReadObstacles(const YamlField& root,
                                          const WorldLoadOptions& options,
                                          Names* names) {
  std::vector<StaticObstacle> obstacles;
  for (const SolidKind& kind : SolidKinds()) {
    const std::vector<YamlField> items = root[kind.plural].Items();
    for (std::size_t i = 0; i < items.size(); ++i) {
      items[i].AllowOnly(WithName(kind.keys));
      obstacles.push_back(
          {names->Read(items[i], kind.name, i), kind.read(items[i], options)});
    }
  }
  return obstacles;
}

/// Names become namespaces.
bool IsNamespace(const std::string& name) {
  return std::isalpha(static_cast<unsigned char>(name[0])) != 0 &&
         std::all_of(name.begin(), name.end(), [](unsigned char c) {
           return std::isalnum(c) != 0 || c == '_';
         });
}

std::vector<RobotStart> ReadRobots(const YamlField& field, Names* names) {
  std::vector<RobotStart> robots;
  const std::vector<YamlField> items = field.Items();
  for (std::size_t i = 0; i < items.size(); ++i) {
    items[i].AllowOnly({"name", "start", "goal", "laser"});
    RobotStart robot;
    robot.name = names->Read(items[i], "robot", i);
    robot.pose = ReadPose(items[i]["start"]);
    if (items[i]["goal"].Exists()) {
      robot.goal = ReadGoal(items[i]["goal"], robot.pose);
    }
    if (items[i]["laser"].Exists()) {
      robot.laser = LaserPreset(items[i]["laser"].Choice(LaserPresetNames()));
    }
    if (!IsNamespace(robot.name)) {
      items[i]["name"].Fail("a letter, then letters, digits or _");
    }
    robots.push_back(robot);
  }
  return robots;
}

std::vector<Mover> ReadMovers(const YamlField& field, Names* names) {
  std::vector<Mover> movers;
  const std::vector<YamlField> items = field.Items();
  for (std::size_t i = 0; i < items.size(); ++i) {
    movers.push_back(ReadMover(items[i], names->Read(items[i], "mover", i)));
  }
  return movers;
}

Eigen::Vector2d MiddleOf(const std::vector<Shape>& shapes) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (const Shape& shape : shapes) sum += shape.center;
  return sum / static_cast<double>(shapes.size());
}

PopUp ReadPopUp(const YamlField& field, const std::string& name,
                const WorldLoadOptions& options) {
  field.AllowOnly({"name", "shape", "time", "approach"});
  PopUp pop_up;
  pop_up.name = name;
  pop_up.shapes = ReadSolid(field["shape"], options);
  const YamlField approach = field["approach"];
  if (field["time"].Exists() == approach.Exists()) {
    field.Fail("either time or approach");
  }
  if (field["time"].Exists()) {
    pop_up.time = field["time"].Number(0.0, kLongestTime);
    return pop_up;
  }
  approach.AllowOnly({"distance", "point"});
  pop_up.approach_distance =
      approach["distance"].Number(kSmallestSize, kFarthestPlace);
  pop_up.approach_point = approach["point"].Exists()
                              ? ReadPoint(approach["point"])
                              : MiddleOf(pop_up.shapes);
  return pop_up;
}

std::vector<PopUp> ReadPopUps(const YamlField& field,
                              const WorldLoadOptions& options, Names* names) {
  std::vector<PopUp> pop_ups;
  const std::vector<YamlField> items = field.Items();
  for (std::size_t i = 0; i < items.size(); ++i) {
    pop_ups.push_back(
        ReadPopUp(items[i], names->Read(items[i], "pop_up", i), options));
  }
  return pop_ups;
}

Walker ReadWalker(const YamlField& field, const std::string& name) {
  field.AllowOnly({"name", "position", "radius", "speed", "notice", "ahead",
                   "keep", "stand", "times"});
  Walker walker;
  walker.name = name;
  walker.home = ReadPoint(field["position"]);
  const auto read = [&field](const std::string& key, double min, double max,
                             double* value) {
    if (field[key].Exists()) *value = field[key].Number(min, max);
  };
  read("radius", kSmallestSize, kLargestSize, &walker.radius);
  read("speed", 0.01, 10.0, &walker.speed);
  read("notice", 0.0, kFarthestPlace, &walker.notice);
  read("ahead", 0.0, kFarthestPlace, &walker.ahead);
  read("keep", 0.05, kFarthestPlace, &walker.keep);
  read("stand", 0.0, kLongestTime, &walker.stand);
  if (field["times"].Exists()) {
    walker.times = field["times"].Integer(1, 1000);
  }
  return walker;
}

std::vector<Walker> ReadWalkers(const YamlField& field, Names* names) {
  std::vector<Walker> walkers;
  const std::vector<YamlField> items = field.Items();
  for (std::size_t i = 0; i < items.size(); ++i) {
    walkers.push_back(ReadWalker(items[i], names->Read(items[i], "walker", i)));
  }
  return walkers;
}

std::vector<GroundPatch> ReadGround(const YamlField& field,
                                    const WorldLoadOptions& options) {
  std::vector<GroundPatch> ground;
  for (const YamlField& item : field.Items()) {
    item.AllowOnly({"shape", "friction", "tyre_slip_stiffness"});
    const JackalModel usual;
    GroundPatch patch{ReadSolid(item["shape"], options), usual.friction,
                      usual.tyre_slip_stiffness};
    if (item["friction"].Exists()) {
      patch.friction = item["friction"].Number(0.01, 10.0);
    }
    if (item["tyre_slip_stiffness"].Exists()) {
      patch.tyre_slip_stiffness =
          item["tyre_slip_stiffness"].Number(1.0, 10000.0);
    }
    ground.push_back(patch);
  }
  return ground;
}

}  // namespace

World ReadYamlWorld(const YamlField& root, const WorldLoadOptions& options) {
  if (root["version"].Text() != "1") root["version"].Fail("1");
  std::vector<std::string> keys = {"version", "name",    "goal",    "robots",
                                   "movers",  "pop_ups", "walkers", "ground"};
  for (const SolidKind& kind : SolidKinds()) keys.push_back(kind.plural);
  root.AllowOnly(keys);

  World world;
  Names names;
  if (root["robots"].Items().empty()) names.Reserve(kOnlyRobot);
  if (root["name"].Exists()) world.name = root["name"].Text();
  world.obstacles = ReadObstacles(root, options, &names);
  world.movers = ReadMovers(root["movers"], &names);
  world.pop_ups = ReadPopUps(root["pop_ups"], options, &names);
  world.walkers = ReadWalkers(root["walkers"], &names);
  world.ground = ReadGround(root["ground"], options);
  world.robots = ReadRobots(root["robots"], &names);
  if (root["goal"].Exists()) {
    const Pose2D start = world.robots.empty() ? Pose2D() : world.robots[0].pose;
    world.goal = ReadGoal(root["goal"], start);
  } else if (!world.robots.empty()) {
    world.goal = world.robots[0].goal;
  }
  return world;
}

}  // namespace vfh_astar
