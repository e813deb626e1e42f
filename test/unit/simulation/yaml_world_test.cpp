#include "vfh_astar/simulation/yaml_world.h"

#include <gtest/gtest.h>

#include "temporary_folder.h"
#include "vfh_astar/simulation/jackal.h"

namespace vfh_astar {
namespace {

World Read(const std::string& entries) {
  const TemporaryFolder folder;
  return LoadWorld(folder.Write("w.yaml", "version: 1\n" + entries));
}

/// What is wrong with a world of these entries, from line 2 on.
std::string ErrorOf(const std::string& entries) {
  const TemporaryFolder folder;
  const std::string file = folder.Write("w.yaml", "version: 1\n" + entries);
  try {
    LoadWorld(file);
  } catch (const WorldFileError& error) {
    const std::string message = error.what();
    EXPECT_EQ(message.rfind(file + ":", 0), 0u) << message;
    return message.substr(file.size() + 1);
  }
  return "no error";
}

std::string MoverError(const std::string& way) {
  return ErrorOf("movers:\n  - shape: {cylinder: {radius: 1}}\n" + way);
}

TEST(YamlWorld, ReadsBoxes) {
  const World world = Read(
      "boxes:\n"
      "  - {name: crate, pose: [1, 2, 1.5707963267948966], size: [4, 1]}\n"
      "  - {pose: [9, 9, 0], size: [1, 1]}\n");
  ASSERT_EQ(world.obstacles.size(), 2u);
  EXPECT_EQ(world.obstacles[0].name, "crate");
  EXPECT_EQ(world.obstacles[1].name, "box_2");
  ASSERT_EQ(world.obstacles[0].shapes.size(), 1u);
  const Shape& crate = world.obstacles[0].shapes[0];
  EXPECT_TRUE(Contains(crate, {1.4, 3.9}));
  EXPECT_FALSE(Contains(crate, {1.6, 2.0}));
  EXPECT_FALSE(Contains(crate, {1.0, 4.1}));
}

TEST(YamlWorld, ReadsCylinders) {
  const World world = Read("cylinders: [{position: [3, -2], radius: 0.25}]\n");
  ASSERT_EQ(world.obstacles.size(), 1u);
  EXPECT_EQ(world.obstacles[0].name, "cylinder_1");
  EXPECT_TRUE(world.obstacles[0].shapes[0].IsDisc());
  EXPECT_EQ(world.obstacles[0].shapes[0].center, Eigen::Vector2d(3.0, -2.0));
  EXPECT_EQ(world.obstacles[0].shapes[0].radius, 0.25);
}

TEST(YamlWorld, ReadsPolygons) {
  // An L.
  const World world = Read(
      "polygons: [{outline: [[0, 0], [2, 0], [2, 1], [1, 1], [1, 3], [0, "
      "3]]}]\n");
  ASSERT_EQ(world.obstacles.size(), 1u);
  const auto is_solid = [&world](double x, double y) {
    for (const Shape& shape : world.obstacles[0].shapes) {
      if (Contains(shape, {x, y})) return true;
    }
    return false;
  };
  EXPECT_TRUE(is_solid(1.9, 0.9));
  EXPECT_TRUE(is_solid(0.9, 2.9));
  EXPECT_FALSE(is_solid(1.1, 1.1));
}

TEST(YamlWorld, ReadsWalls) {
  const World world = Read(
      "walls:\n"
      "  - {points: [[0, 0], [4, 0], [4, 3]]}\n"
      "  - {points: [[0, 0], [4, 0], [4, 3]], thickness: 0.5, closed: true}\n");
  ASSERT_EQ(world.obstacles.size(), 2u);
  EXPECT_EQ(world.obstacles[0].shapes.size(), 2u);
  EXPECT_EQ(world.obstacles[1].shapes.size(), 3u);
  EXPECT_TRUE(Contains(world.obstacles[0].shapes[0], {2.0, 0.049}));
  EXPECT_FALSE(Contains(world.obstacles[0].shapes[0], {2.0, 0.051}));
  EXPECT_TRUE(Contains(world.obstacles[1].shapes[2], {2.0, 1.5}));
}

TEST(YamlWorld, ReadsBitmapsBesideTheFile) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.Path("maps"));
  folder.Write("maps/m.pgm", std::string("P5\n2 1\n255\n\xcc\xfe", 13));
  folder.Write("maps/m.yaml",
               "{image: m.pgm, resolution: 1.0, origin: [0, 0, 0], negate: 0, "
               "occupied_thresh: 0.65, free_thresh: 0.196}");
  const auto shapes = [&folder](const std::string& more) {
    const World world = LoadWorld(folder.Write(
        "w.yaml", "version: 1\nbitmaps: [{map: maps/m.yaml" + more + "}]\n"));
    return world.obstacles[0].shapes.size();
  };
  EXPECT_EQ(shapes(""), 1u);
  EXPECT_EQ(shapes(", solid_below: 100"), 0u);
}

TEST(YamlWorld, ReadsWaypoints) {
  const std::string way =
      "movers:\n"
      "  - shape: {box: {size: [1, 2], yaw: 0.5}}\n"
      "    waypoints: [[0, 0], [4, 0], [4, 2]]\n"
      "    speed: 2\n";
  const Mover to_and_fro = Read(way).movers[0];
  EXPECT_EQ(to_and_fro.name, "mover_1");
  EXPECT_EQ(to_and_fro.period, 6.0);
  EXPECT_EQ(to_and_fro.PositionAt(2.5), Eigen::Vector2d(4.0, 1.0));
  EXPECT_EQ(to_and_fro.PositionAt(5.0), Eigen::Vector2d(2.0, 0.0));
  EXPECT_EQ(to_and_fro.PositionAt(7.0), Eigen::Vector2d(2.0, 0.0));

  const Mover once = Read(way + "    cycle: once\n").movers[0];
  EXPECT_EQ(once.period, 0.0);
  EXPECT_EQ(once.PositionAt(50.0), Eigen::Vector2d(4.0, 2.0));

  const Mover loop = Read(
                         "movers:\n"
                         "  - shape: {cylinder: {radius: 0.3}}\n"
                         "    waypoints: [[0, 0], [4, 0], [4, 3]]\n"
                         "    speed: 1\n"
                         "    cycle: loop\n")
                         .movers[0];
  EXPECT_EQ(loop.period, 12.0);
  EXPECT_TRUE(loop.PositionAt(9.5).isApprox(Eigen::Vector2d(2.0, 1.5)));
}

TEST(YamlWorld, ReadsKeyframes) {
  const std::string keyframes =
      "movers:\n"
      "  - shape: {cylinder: {radius: 0.3}}\n"
      "    keyframes: [[0, 1, 2], [2, 5, 2]]\n";
  EXPECT_EQ(Read(keyframes).movers[0].period, 0.0);
  const Mover mover = Read(keyframes + "    period: 2.5\n").movers[0];
  EXPECT_EQ(mover.PositionAt(3.5), Eigen::Vector2d(3.0, 2.0));
}

TEST(YamlWorld, ReadsPopUps) {
  const World world = Read(
      "pop_ups:\n"
      "  - {shape: {cylinder: {position: [1, 2], radius: 1}}, time: 5}\n"
      "  - {shape: {box: {pose: [3, 4, 0], size: [1, 1]}},\n"
      "     approach: {distance: 2}}\n"
      "  - {shape: {wall: {points: [[0, 0], [2, 0]]}},\n"
      "     approach: {distance: 1, point: [7, 8]}}\n");
  ASSERT_EQ(world.pop_ups.size(), 3u);
  EXPECT_EQ(world.pop_ups[0].time, 5.0);
  EXPECT_FALSE(world.pop_ups[0].approach_distance.has_value());
  EXPECT_FALSE(world.pop_ups[1].time.has_value());
  EXPECT_EQ(world.pop_ups[1].approach_distance, 2.0);
  EXPECT_EQ(world.pop_ups[1].approach_point, Eigen::Vector2d(3.0, 4.0));
  EXPECT_EQ(world.pop_ups[2].approach_point, Eigen::Vector2d(7.0, 8.0));
}

TEST(YamlWorld, ReadsRobotsAndGoal) {
  const World world = Read(
      "name: two robots\n"
      "robots: [{name: anna, start: [1, 1, 0.5]}, {start: [2, 2, 0]}]\n"
      "goal: [1, 4]\n");
  EXPECT_EQ(world.name, "two robots");
  ASSERT_EQ(world.robots.size(), 2u);
  EXPECT_EQ(world.robots[0].name, "anna");
  EXPECT_EQ(world.robots[0].pose.theta, 0.5);
  EXPECT_EQ(world.robots[1].name, "robot_2");
  // Without a yaw the goal looks the way one comes from the first start.
  EXPECT_NEAR(world.goal->theta, 0.5 * kPi, 1e-12);
  EXPECT_EQ(Read("goal: [1, 4, 1.25]\n").goal->theta, 1.25);
}

TEST(YamlWorld, ErrorsNameLineAndField) {
  EXPECT_EQ(
      ErrorOf("boxs: []\n"),
      "2: 'boxs'; expected one of version, name, goal, robots, movers, "
      "pop_ups, walkers, ground, boxes, cylinders, polygons, walls, bitmaps");
  EXPECT_EQ(ErrorOf("goal: [1, 2]\ngoal: [1, 2]\n"),
            "3: 'goal'; expected each entry once");
  EXPECT_EQ(ErrorOf("boxes: {}\n"),
            "2: boxes: a group of entries; expected a "
            "list");
  EXPECT_EQ(ErrorOf("boxes:\n  - pose: [0, 0, 0]\n    sise: [1, 1]\n"),
            "4: boxes[0]: 'sise'; expected one of name, pose, size");
  EXPECT_EQ(ErrorOf("boxes:\n  - pose: [0, 0, 0]\n"),
            "3: boxes[0].size: missing; expected [length, width] in m");
  EXPECT_EQ(ErrorOf("boxes:\n  - pose: [0, 0, 0]\n    size: [1, -1]\n"),
            "4: boxes[0].size[1]: '-1'; expected a number from 0.001 to "
            "10000");
  EXPECT_EQ(ErrorOf("cylinders: [{position: [.inf, 0], radius: 1}]\n"),
            "2: cylinders[0].position[0]: '.inf'; expected a number from "
            "-100000 to 100000");
  EXPECT_EQ(ErrorOf("cylinders: [{position: [0, 0], radius: wide}]\n"),
            "2: cylinders[0].radius: 'wide'; expected a number from 0.001 to "
            "10000");
  EXPECT_EQ(ErrorOf("walls: [{points: [[0, 0], [1, 1]], closed: true}]\n"),
            "2: walls[0].points: [..., ...]; expected 3 points [x, y] in m or "
            "more");
  EXPECT_EQ(ErrorOf("polygons: [{outline: [[0, 0], [1, 1], [1, 0], [0, 1]]}]"),
            "2: polygons[0].outline: [..., ..., ..., ...]; expected an outline "
            "with an area that never crosses itself");
  EXPECT_EQ(ErrorOf("robots: [{start: [0, 0]}]\n"),
            "2: robots[0].start: [0, 0]; expected [x, y, yaw] in m and rad");
  EXPECT_EQ(ErrorOf("robots: [{name: 3d, start: [0, 0, 0]}]\n"),
            "2: robots[0].name: '3d'; expected a letter, then letters, digits "
            "or _");
  EXPECT_EQ(ErrorOf("goal: there\n"),
            "2: goal: 'there'; expected [x, y] in m, or [x, y, yaw] in m and "
            "rad");
  EXPECT_EQ(ErrorOf("goal: [1, 2, 3, 4]\n"),
            "2: goal: [1, 2, 3, 4]; expected [x, y] in m, or [x, y, yaw] in m "
            "and rad");
  EXPECT_NE(ErrorOf("walls: [\n").find("; expected a YAML document"),
            std::string::npos);
}

TEST(YamlWorld, ErrorsInSolids) {
  EXPECT_EQ(ErrorOf("boxes: [{pose: [0, 0, 0], size: 3}]\n"),
            "2: boxes[0].size: '3'; expected [length, width] in m");
  EXPECT_EQ(ErrorOf("walls:\n  - points: [[0, 0], [1, 0],\n      [1, 0]]\n"),
            "4: walls[0].points[2]: [1, 0]; expected another place than the "
            "point before");
  EXPECT_EQ(ErrorOf("walls:\n"
                    "  - points: [[0, 0], [1, 0], [0, 0]]\n"
                    "    closed: true\n"),
            "3: walls[0].points[0]: [0, 0]; expected another place than the "
            "point before");
  EXPECT_EQ(ErrorOf("bitmaps:\n  - map: nowhere.yaml\n"),
            "3: bitmaps[0].map: 'nowhere.yaml'; expected a map's yaml file, "
            "from the folder of this file on");
}

TEST(YamlWorld, WhatIsNoYamlIsTold) {
  EXPECT_EQ(ErrorOf("boxes:\n\t- {pose: [0, 0, 0], size: [1, 1]}\n"),
            "3: a tab before an entry; expected spaces");
  EXPECT_EQ(ErrorOf(std::string("name: \"\\\0\"", 10)),
            "1: bytes that are no text; expected a YAML document");
  EXPECT_EQ(ErrorOf("walls: [\n"),
            "3: end of sequence flow not found; expected a YAML document");
}

TEST(YamlWorld, ErrorsInMovers) {
  EXPECT_EQ(MoverError(""),
            "3: movers[0]: a group of entries; expected either "
            "waypoints or keyframes");
  EXPECT_EQ(MoverError("    waypoints: [[0, 0]]\n    speed: 1\n"),
            "4: movers[0].waypoints: [...]; expected two waypoints [x, y] in m "
            "or more");
  EXPECT_EQ(MoverError("    waypoints: [[0, 0], [0, 0]]\n    speed: 1\n"),
            "4: movers[0].waypoints[1]: [0, 0]; expected another place than "
            "the waypoint before");
  EXPECT_EQ(MoverError("    waypoints: [[0, 0], [1, 0]]\n    speed: 0\n"),
            "5: movers[0].speed: '0'; expected a number from 0.001 to 100");
  EXPECT_EQ(MoverError("    keyframes: [[1, 0, 0],\n      [1, 0, 0]]\n"),
            "5: movers[0].keyframes[1]: [1, 0, 0]; expected a later time than "
            "the keyframe before");
  EXPECT_EQ(MoverError("    keyframes: [[4, 0, 0]]\n    period: 3\n"),
            "5: movers[0].period: '3'; expected 0 or no less than the time of "
            "the last keyframe");
  EXPECT_EQ(ErrorOf("movers:\n"
                    "  - shape: {polygon: {}}\n"
                    "    keyframes: [[0, 0, 0]]\n"),
            "3: movers[0].shape: 'polygon'; expected one of box, cylinder");
}

TEST(YamlWorld, ErrorsInPopUps) {
  const std::string shape = "{cylinder: {position: [0, 0], radius: 1}}";
  EXPECT_EQ(ErrorOf("pop_ups: [{shape: " + shape + "}]\n"),
            "2: pop_ups[0]: a group of entries; expected either time or "
            "approach");
  EXPECT_EQ(ErrorOf("pop_ups: [{time: 1}]\n"),
            "2: pop_ups[0].shape: missing; expected entries out of box, "
            "cylinder, polygon, wall, bitmap");
  EXPECT_EQ(ErrorOf("pop_ups: [{shape: {}, time: 1}]\n"),
            "2: pop_ups[0].shape: a group of entries; expected one solid, such "
            "as cylinder: {...}");
  EXPECT_EQ(ErrorOf("pop_ups: [{shape: " + shape + ", time: -1}]\n"),
            "2: pop_ups[0].time: '-1'; expected a number from 0 to 1e+06");
}

TEST(YamlWorld, OtherVersionsAreRefused) {
  const TemporaryFolder folder;
  const std::string file = folder.Write("w.yaml", "version: 2\n");
  try {
    LoadWorld(file);
    FAIL();
  } catch (const WorldFileError& error) {
    EXPECT_EQ(error.what(), file + ":1: version: '2'; expected 1");
  }
}

TEST(YamlWorld, ReadsWalkers) {
  const World world = Read(
      "walkers:\n"
      "  - {name: operator, position: [1, 2], radius: 0.3, speed: 1.5,\n"
      "     notice: 5, ahead: 1.5, keep: 0.4, stand: 3, times: 7}\n"
      "  - position: [3, 4]\n");
  ASSERT_EQ(world.walkers.size(), 2u);
  EXPECT_EQ(world.walkers[0].name, "operator");
  EXPECT_EQ(world.walkers[0].home, Eigen::Vector2d(1.0, 2.0));
  EXPECT_EQ(world.walkers[0].radius, 0.3);
  EXPECT_EQ(world.walkers[0].speed, 1.5);
  EXPECT_EQ(world.walkers[0].notice, 5.0);
  EXPECT_EQ(world.walkers[0].ahead, 1.5);
  EXPECT_EQ(world.walkers[0].keep, 0.4);
  EXPECT_EQ(world.walkers[0].stand, 3.0);
  EXPECT_EQ(world.walkers[0].times, 7);
  EXPECT_EQ(world.walkers[1].name, "walker_2");
  EXPECT_EQ(world.walkers[1].speed, Walker().speed);
}

TEST(YamlWorld, ErrorsInWalkers) {
  EXPECT_EQ(ErrorOf("walkers:\n  - position: [1, 2]\n    times: 0\n"),
            "4: walkers[0].times: '0'; expected a whole number from 1 to 1000");
  EXPECT_NE(ErrorOf("walkers: [{position: [1, 2], sped: 1}]\n").find("sped"),
            std::string::npos);
  EXPECT_NE(ErrorOf("walkers: [{speed: 1}]\n").find("walkers[0].position"),
            std::string::npos);
}

TEST(YamlWorld, ReadsGround) {
  const World world = Read(
      "ground:\n"
      "  - {shape: {box: {pose: [0, 0, 0], size: [2, 2]}}, friction: 0.2}\n"
      "  - {shape: {cylinder: {position: [5, 5], radius: 1}},\n"
      "     tyre_slip_stiffness: 50}\n");
  ASSERT_EQ(world.ground.size(), 2u);
  EXPECT_EQ(world.ground[0].friction, 0.2);
  EXPECT_EQ(world.ground[0].tyre_slip_stiffness,
            JackalModel().tyre_slip_stiffness);
  EXPECT_TRUE(Contains(world.ground[0].shapes[0], {0.9, -0.9}));
  EXPECT_EQ(world.ground[1].tyre_slip_stiffness, 50.0);
  EXPECT_EQ(ErrorOf("ground:\n"
                    "  - friction: 0\n"
                    "    shape: {cylinder: {position: [5, 5], radius: 1}}\n"),
            "3: ground[0].friction: '0'; expected a number from 0.01 to 10");
}

TEST(YamlWorld, ReadsLasersOfRobots) {
  const World world = Read(
      "robots:\n"
      "  - {name: a, start: [0, 0, 0]}\n"
      "  - {name: b, start: [4, 0, 3], laser: barn}\n");
  EXPECT_FALSE(world.robots[0].laser.has_value());
  ASSERT_TRUE(world.robots[1].laser.has_value());
  EXPECT_EQ(world.robots[1].laser->rate, 50.0);
  EXPECT_EQ(ErrorOf("robots:\n  - start: [0, 0, 0]\n    laser: sick\n"),
            "4: robots[0].laser: 'sick'; expected one of paper, barn");
}

TEST(YamlWorld, NamesAreUnique) {
  EXPECT_EQ(ErrorOf("cylinders: [{name: a, position: [1, 2], radius: 1}]\n"
                    "robots:\n"
                    "  - start: [0, 0, 0]\n"
                    "    name: a\n"),
            "5: robots[0].name: 'a'; expected a name that nothing else has; "
            "there is a 'a' already");
  EXPECT_EQ(ErrorOf("boxes:\n"
                    "  - {name: box_2, pose: [0, 0, 0], size: [1, 1]}\n"
                    "  - {pose: [5, 0, 0], size: [1, 1]}\n"),
            "4: boxes[1]: a group of entries; expected a name that nothing "
            "else has; there is a 'box_2' already");
}

TEST(YamlWorld, ReadsGoalsOfRobots) {
  const World world = Read(
      "robots:\n"
      "  - {name: a, start: [0, 0, 0], goal: [4, 0]}\n"
      "  - {name: b, start: [4, 0, 3], goal: [0, 0, 1]}\n");
  ASSERT_TRUE(world.robots[1].goal.has_value());
  EXPECT_EQ(world.robots[1].goal->theta, 1.0);
  ASSERT_TRUE(world.goal.has_value()) << "that of the first robot";
  EXPECT_EQ(world.goal->x, 4.0);
}

}  // namespace
}  // namespace vfh_astar
