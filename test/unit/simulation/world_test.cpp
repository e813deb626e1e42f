#include "vfh_astar/simulation/world.h"

#include <gtest/gtest.h>

#include "shared_data.h"
#include "temporary_folder.h"

namespace vfh_astar {
namespace {

std::size_t CountShapes(const World& world) {
  std::size_t count = 0;
  for (const auto& obstacle : world.obstacles) count += obstacle.shapes.size();
  return count;
}

std::string ErrorOf(const std::string& file) {
  try {
    LoadWorld(file);
  } catch (const WorldFileError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Mover, GoesFromKeyframeToKeyframe) {
  Mover mover;
  mover.keyframes = {{1.0, {0.0, 0.0}}, {3.0, {4.0, 0.0}}, {4.0, {4.0, 2.0}}};
  EXPECT_EQ(mover.PositionAt(0.0), Eigen::Vector2d(0.0, 0.0));
  EXPECT_EQ(mover.PositionAt(1.0), Eigen::Vector2d(0.0, 0.0));
  EXPECT_EQ(mover.PositionAt(1.5), Eigen::Vector2d(1.0, 0.0));
  EXPECT_EQ(mover.PositionAt(3.0), Eigen::Vector2d(4.0, 0.0));
  EXPECT_EQ(mover.PositionAt(3.5), Eigen::Vector2d(4.0, 1.0));
  EXPECT_EQ(mover.PositionAt(100.0), Eigen::Vector2d(4.0, 2.0));
}

TEST(Mover, BeginsAnewAfterItsPeriod) {
  Mover mover;
  mover.keyframes = {{0.0, {0.0, 0.0}}, {2.0, {4.0, 0.0}}};
  mover.period = 3.0;
  EXPECT_EQ(mover.PositionAt(1.0), Eigen::Vector2d(2.0, 0.0));
  EXPECT_EQ(mover.PositionAt(2.5), Eigen::Vector2d(4.0, 0.0));
  EXPECT_EQ(mover.PositionAt(3.0), Eigen::Vector2d(0.0, 0.0));
  EXPECT_EQ(mover.PositionAt(10.0), Eigen::Vector2d(2.0, 0.0));
}

TEST(LoadWorld, NamesWhatTheFileDoesNot) {
  const TemporaryFolder folder;
  const World world = LoadWorld(folder.Write("empty.yaml", "version: 1\n"));
  EXPECT_EQ(world.name, "empty");
  EXPECT_FALSE(world.goal.has_value());
  ASSERT_EQ(world.robots.size(), 1u);
  EXPECT_EQ(world.robots[0].name, "robot_1");
  EXPECT_EQ(world.robots[0].pose.x, 0.0);
}

TEST(LoadWorld, RefusesWhatIsNoWorld) {
  const TemporaryFolder folder;
  const std::string missing = folder.Path("missing.yaml");
  EXPECT_EQ(ErrorOf(missing),
            missing + ": cannot be read; expected a readable file");
  EXPECT_EQ(ErrorOf(folder.Path("")),
            folder.Path("") + ": cannot be read; expected a readable file");
  const std::string other = folder.Write("other.yaml", "name: a\n");
  EXPECT_EQ(ErrorOf(other),
            other +
                ":1: a group of entries; expected a world (with "
                "`version`), a DynaBARN world (with `obstacles`) or a map "
                "(with `image`)");
  const std::string nothing = folder.Write("nothing.yaml", " \n");
  EXPECT_NE(ErrorOf(nothing).find(":1: missing; expected a world"),
            std::string::npos);
  const std::string text = folder.Write("text.yaml", "some text\n");
  EXPECT_EQ(ErrorOf(text),
            text + ":1: 'some text'; expected entries with names");
  const std::string bytes =
      folder.Write("bytes.yaml", std::string("\x00\x01\xff\x02: [", 7));
  EXPECT_NE(ErrorOf(bytes), "no error");
}

TEST(LoadWorld, NamesAreUnique) {
  const TemporaryFolder folder;
  const std::string cylinder =
      "{\"name\": \"a\", \"shape\": \"cylinder\", \"radius\": 1, "
      "\"period_s\": 2, \"keyframes_t_x_y\": [[0, 1, 2]]}";
  const std::string file =
      folder.Write("twice.json",
                   "{\"start\": [0, 0, 0], \"goal\": [1, 1], \"obstacles\": [" +
                       cylinder + ",\n" + cylinder + "]}");
  EXPECT_EQ(ErrorOf(file), file +
                               ":2: obstacles[1].name: 'a'; expected a name "
                               "that nothing else has");
  // A world without robots gets one.
  const std::string robot = folder.Write(
      "robot.yaml",
      "version: 1\n"
      "cylinders: [{name: robot_1, position: [3, 0], radius: 1}]\n");
  EXPECT_EQ(ErrorOf(robot),
            robot +
                ":2: cylinders[0].name: 'robot_1'; expected a name that "
                "nothing else has; there is a 'robot_1' already");
}

TEST(LoadWorld, ReadsTheWorldsOfThisPackage) {
  int count = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(VFH_ASTAR_SOURCE_DIR "/worlds")) {
    const std::string file = entry.path().string();
    const World world = LoadWorld(file);
    EXPECT_EQ(world.name, entry.path().stem()) << file;
    EXPECT_FALSE(world.obstacles.empty()) << file;
    ASSERT_TRUE(world.goal.has_value()) << file;
    // A robot has room at its start and at its goal.
    for (const Pose2D& pose : {world.robots[0].pose, *world.goal}) {
      const Shape room = MakeDisc(pose.position(), 0.5);
      for (const auto& obstacle : world.obstacles) {
        for (const Shape& shape : obstacle.shapes) {
          EXPECT_GT(Distance(room, shape), 0.0) << file << obstacle.name;
        }
      }
    }
    ++count;
  }
  EXPECT_GE(count, 5);
}

TEST(LoadWorld, ReadsBarnWorlds) {
  const std::string file = SharedData("barn/world_11.world");
  VFH_ASTAR_SKIP_WITHOUT(file);
  const World world = LoadWorld(file);
  EXPECT_EQ(world.obstacles.size(), 204u);
  EXPECT_EQ(CountShapes(world), 204u);
  EXPECT_EQ(world.obstacles[0].name, "unit_cylinder_0");
  const Shape& first = world.obstacles[0].shapes[0];
  EXPECT_TRUE(first.IsDisc());
  EXPECT_EQ(first.center, Eigen::Vector2d(-0.075, 0.075));
  EXPECT_EQ(first.radius, 0.075);
  EXPECT_EQ(world.obstacles[203].shapes[0].center,
            Eigen::Vector2d(-0.075, 9.525));
}

TEST(LoadWorld, ReadsDynabarnWorlds) {
  const std::string file = SharedData("dynabarn/world_0.json");
  VFH_ASTAR_SKIP_WITHOUT(file);
  const World world = LoadWorld(file);
  EXPECT_EQ(world.obstacles.size(), 3u);
  ASSERT_EQ(world.movers.size(), 11u);
  EXPECT_EQ(world.movers[0].name, "easylibobs_51");
  EXPECT_EQ(world.movers[0].shape.radius, 0.5);
  EXPECT_EQ(world.movers[0].period, 33.5);
  EXPECT_TRUE(world.movers[0]
                  .PositionAt(33.5 + 1.59)
                  .isApprox(Eigen::Vector2d(-7.78, -9.33)));
  EXPECT_EQ(world.robots[0].pose.x, 11.0);
  EXPECT_EQ(world.goal->x, -9.0);
  EXPECT_NEAR(world.goal->theta, kPi, 1e-12);
}

TEST(LoadWorld, ReadsMaps) {
  const std::string file =
      SharedData("maps/willow/willow-2010-02-18-0.10.yaml");
  VFH_ASTAR_SKIP_WITHOUT(file);
  const World world = LoadWorld(file);
  ASSERT_EQ(world.obstacles.size(), 1u);
  double area = 0.0;
  for (const Shape& shape : world.obstacles[0].shapes) {
    const Eigen::Vector2d size = shape.vertices[2] - shape.vertices[0];
    area += size.x() * size.y();
  }
  EXPECT_NEAR(area, 10395 * 0.01, 1e-6);
  WorldLoadOptions options;
  options.solid_below = 50;
  EXPECT_LT(CountShapes(LoadWorld(file, options)), 600u);
}

}  // namespace
}  // namespace vfh_astar
