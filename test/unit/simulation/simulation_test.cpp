#include "vfh_astar/simulation/simulation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "vfh_astar/simulation/jackal.h"

namespace vfh_astar {
namespace {

World EmptyWorld() {
  World world;
  world.robots.push_back({"jackal", {0.0, 0.0, 0.0}});
  return world;
}

/// A wall 3 m ahead of the robot's centre.
World WallWorld() {
  World world = EmptyWorld();
  world.obstacles.push_back({"wall", {MakeBox({3.05, 0.0, 0.0}, {0.1, 20.0})}});
  return world;
}

void Drive(Simulation* simulation, double seconds,
           const Twist2D& command = Twist2D()) {
  const double end = simulation->time() + seconds;
  while (simulation->time() < end - 1e-9) {
    simulation->SetCommand(0, command);
    simulation->Step();
  }
}

TEST(SimulationTest, TheScanSeesTheWallWhereItIs) {
  Simulation simulation(WallWorld(), {});
  Drive(&simulation, 0.1);
  const LaserScan& scan = simulation.scan(0);
  ASSERT_EQ(scan.ranges.size(), 1080u);
  const double x = simulation.TruePose(0).x + 0.055;
  for (std::size_t beam = 0; beam < scan.ranges.size(); ++beam) {
    const double angle = scan.Angle(beam);
    const double expected = (3.0 - x) / std::cos(angle);
    if (std::abs(angle) < 1.2) {
      EXPECT_NEAR(scan.ranges[beam], expected, 2e-3) << angle;
    } else if (std::abs(angle) > 1.7) {
      EXPECT_TRUE(std::isinf(scan.ranges[beam])) << angle;
    }
  }
}

TEST(SimulationTest, SensorsComeAtTheirRates) {
  Simulation simulation(EmptyWorld(), {});
  int scans = 0;
  int readings = 0;
  while (simulation.time() < 10.0 - 1e-9) {
    const StepEvents events = simulation.Step();
    scans += events.scan ? 1 : 0;
    readings += events.odometry ? 1 : 0;
  }
  EXPECT_EQ(scans, 400);
  EXPECT_EQ(readings, 500);
}

TEST(SimulationTest, EveryRobotScansAtItsOwnRate) {
  World world = WallWorld();
  world.robots.push_back({"other", {0.0, 5.0, 0.0}});
  world.robots[1].laser = LaserPreset("barn");
  Simulation simulation(world, {});
  int scans[2] = {0, 0};
  while (simulation.time() < 2.0 - 1e-9) {
    const StepEvents events = simulation.Step();
    EXPECT_EQ(events.scan,
              simulation.HasNewScan(0) || simulation.HasNewScan(1));
    for (const std::size_t robot : {0, 1}) {
      if (!simulation.HasNewScan(robot)) continue;
      ++scans[robot];
      EXPECT_NEAR(simulation.scan(robot).stamp,
                  scans[robot] / simulation.laser(robot).rate, 0.0021);
    }
  }
  EXPECT_EQ(scans[0], 80);
  EXPECT_EQ(scans[1], 100);
  EXPECT_EQ(simulation.scan(0).ranges.size(), 1080u);
  EXPECT_EQ(simulation.scan(1).ranges.size(), 720u);
  EXPECT_EQ(simulation.laser(0).beams, 1080);
  simulation.Reset(1);
  simulation.Step();
  EXPECT_FALSE(simulation.HasNewScan(0));
}

TEST(SimulationTest, ACommandTimesOut) {
  Simulation simulation(EmptyWorld(), {});
  Drive(&simulation, 1.0, {1.0, 0.0});
  EXPECT_GT(simulation.TrueTwist(0).v, 0.9);
  while (simulation.time() < 1.6) simulation.Step();
  EXPECT_NEAR(simulation.TrueTwist(0).v, 0.0, 0.01);
}

TEST(SimulationTest, CollisionIsReportedWhenTheFootprintTouches) {
  Simulation simulation(WallWorld(), {});
  const double touch = 3.0 - Footprint().front;
  while (!simulation.collision(0) && simulation.time() < 10.0) {
    simulation.SetCommand(0, {1.0, 0.0});
    simulation.Step();
    if (simulation.TruePose(0).x < touch - 0.003) {
      EXPECT_FALSE(simulation.collision(0).has_value());
    }
  }
  ASSERT_TRUE(simulation.collision(0).has_value());
  EXPECT_NEAR(simulation.TruePose(0).x, touch, 0.006);
  EXPECT_EQ(simulation.collision(0)->with, "wall");
  EXPECT_NEAR(simulation.collision(0)->robot_speed, 1.0, 0.05);
}

TEST(SimulationTest, CollisionIsReportedAtTheTouchAtAnyAngle) {
  const Shape post = MakeDisc({1.5, 0.1}, 0.2);
  const Shape block = MakeBox({1.6, 0.1, 0.7}, {0.5, 0.3});
  for (const Shape& solid : {post, block}) {
    for (int i = 0; i < 24; ++i) {
      // Towards the solid from all sides, and with corners and sides ahead.
      const double bearing = kPi / 12.0 * i;
      const Eigen::Vector2d from =
          solid.center -
          1.2 * Eigen::Vector2d(std::cos(bearing), std::sin(bearing));
      World world;
      const double aside = 0.05 * (i % 5 - 2);
      const bool reverses = i % 3 == 0;
      world.robots.push_back(
          {"jackal", {from, bearing + aside + (reverses ? kPi : 0.0)}});
      world.obstacles.push_back({"solid", {solid}});
      Simulation simulation(world, {});
      const Twist2D command = {reverses ? -0.8 : 0.8, i % 2 == 0 ? 0.2 : 0.0};
      double before = 1.0;
      double gap = 1.0;
      while (!simulation.collision(0) && simulation.time() < 5.0) {
        before = gap;
        simulation.SetCommand(0, command);
        simulation.Step();
        gap = Distance(OutlineOf(Footprint(), simulation.TruePose(0)), solid);
      }
      ASSERT_TRUE(simulation.collision(0).has_value()) << i;
      // A touch is looked for at the beginning of a step.
      EXPECT_EQ(before, 0.0) << i;
      EXPECT_GT(simulation.collision(0)->robot_speed, 0.5);
    }
  }
}

TEST(SimulationTest, PassingCloselyIsNoCollision) {
  World world = EmptyWorld();
  const double side = Footprint().half_width;
  world.obstacles.push_back(
      {"wall", {MakeBox({1.5, side + 0.055, 0.0}, {2.0, 0.1})}});
  Simulation simulation(world, {});
  Drive(&simulation, 3.0, {1.0, 0.0});
  EXPECT_GT(simulation.TruePose(0).x, 2.7);
  EXPECT_FALSE(simulation.collision(0).has_value());
}

TEST(SimulationTest, ClearanceByHand) {
  Simulation simulation(WallWorld(), {});
  Drive(&simulation, 0.02);
  EXPECT_NEAR(simulation.Clearance(0), 3.0 - Footprint().front, 1e-3);
}

TEST(SimulationTest, CleanFilteredOdometryFollowsTheTruth) {
  Simulation simulation(EmptyWorld(), {});
  double driven = 0.0;
  for (int lap = 0; lap < 10; ++lap) {
    Drive(&simulation, 2.0, {1.5, 0.0});
    Drive(&simulation, 1.0, {1.0, 1.5});
    Drive(&simulation, 1.0, {0.0, -2.0});
    driven += 4.0;
  }
  Drive(&simulation, 1.0);
  const Pose2D error =
      simulation.TruePose(0).Inverse() * simulation.filtered_odometry(0).pose;
  EXPECT_LT(error.position().norm(), 0.02 * driven);
  EXPECT_LT(std::abs(error.theta), 0.02);
}

TEST(SimulationTest, ExperimentOdometryDriftsByTwoToFivePercent) {
  SimulationParameters parameters;
  parameters.noise = NoisePreset("experiment");
  parameters.laser.beams = 2;
  for (std::uint32_t seed = 1; seed <= 6; ++seed) {
    parameters.seed = seed;
    Simulation simulation(EmptyWorld(), parameters);
    Drive(&simulation, 30.0, {1.0, 0.0});
    const auto drift = [&simulation] {
      return (simulation.TruePose(0).position() -
              simulation.filtered_odometry(0).pose.position())
          .norm();
    };
    EXPECT_GT(drift(), 0.02 * 30.0) << seed;
    EXPECT_LT(drift(), 0.05 * 30.0) << seed;
    simulation.Reset(seed);
    Drive(&simulation, 10.0, {1.0, 0.0});
    Drive(&simulation, kPi, {1.0, 1.0});
    Drive(&simulation, 10.0, {1.0, 0.0});
    // The way back makes good a part of it.
    EXPECT_GT(drift(), 0.015 * 23.0) << seed;
    EXPECT_LT(drift(), 0.055 * 23.0) << seed;
  }
}

TEST(SimulationTest, EveryRobotHasErrorsOfItsOwn) {
  SimulationParameters parameters;
  parameters.noise = NoisePreset("experiment");
  World world = EmptyWorld();
  world.robots.push_back({"other", {0.0, 5.0, 0.0}});
  double most = 0.0;
  // Two robots may be alike by chance.
  for (parameters.seed = 1; parameters.seed <= 4; ++parameters.seed) {
    Simulation simulation(world, parameters);
    while (simulation.time() < 5.0) {
      for (const std::size_t robot : {0, 1}) {
        simulation.SetCommand(robot, {1.0, 0.0});
      }
      simulation.Step();
    }
    most = std::max(most, std::abs(simulation.filtered_odometry(0).pose.x -
                                   simulation.filtered_odometry(1).pose.x));
  }
  EXPECT_GT(most, 0.05);
}

TEST(SimulationTest, SameSeedSameRun) {
  SimulationParameters parameters;
  parameters.noise = NoisePreset("experiment");
  parameters.seed = 42;
  World world = WallWorld();
  world.obstacles.push_back({"post", {MakeDisc({1.2, 0.3}, 0.1)}});
  Simulation first(world, parameters);
  Simulation second(world, parameters);
  Drive(&first, 3.0, {0.8, 0.3});
  Drive(&second, 3.0, {0.8, 0.3});
  EXPECT_EQ(first.TruePose(0).x, second.TruePose(0).x);
  EXPECT_EQ(first.filtered_odometry(0).pose.theta,
            second.filtered_odometry(0).pose.theta);
  EXPECT_EQ(first.scan(0).ranges, second.scan(0).ranges);
  second.Reset(42);
  Drive(&second, 3.0, {0.8, 0.3});
  EXPECT_EQ(first.TruePose(0).y, second.TruePose(0).y);
  second.Reset(43);
  Drive(&second, 3.0, {0.8, 0.3});
  EXPECT_NE(first.scan(0).ranges, second.scan(0).ranges);
}

TEST(SimulationTest, SameSeedSameRunOfManyThings) {
  SimulationParameters parameters;
  parameters.noise = NoisePreset("experiment");
  World world = WallWorld();
  world.robots.push_back({"other", {1.5, 0.3, kPi}});
  world.robots.push_back({"third", {-1.0, 0.0, 0.3}});
  Walker walker;
  walker.name = "walker";
  walker.home = {1.0, 2.5};
  world.walkers.push_back(walker);
  Simulation first(world, parameters);
  Simulation second(world, parameters);
  // They run into each other and into the wall, and slide.
  for (Simulation* simulation : {&first, &second}) {
    while (simulation->time() < 6.0) {
      const double t = simulation->time();
      simulation->SetCommand(0, {1.5, std::sin(3.0 * t)});
      simulation->SetCommand(1, {1.0, t < 3.0 ? 0.0 : 4.0});
      simulation->SetCommand(2, {2.0, -0.5});
      simulation->Step();
    }
  }
  bool collided = false;
  for (const std::size_t robot : {0, 1, 2}) {
    const Pose2D pose = first.TruePose(robot);
    EXPECT_EQ(pose.x, second.TruePose(robot).x);
    EXPECT_EQ(pose.y, second.TruePose(robot).y);
    EXPECT_EQ(pose.theta, second.TruePose(robot).theta);
    EXPECT_EQ(first.WheelAngles(robot), second.WheelAngles(robot));
    EXPECT_EQ(first.scan(robot).ranges, second.scan(robot).ranges);
    collided |= first.collision(robot).has_value();
  }
  EXPECT_TRUE(collided);
}

TEST(SimulationTest, WhatIsSpawnedAndDeletedChangesNoChance) {
  SimulationParameters parameters;
  parameters.noise = NoisePreset("experiment");
  const auto run = [](Simulation* simulation) {
    simulation->Reset(7);
    Drive(simulation, 0.5, {0.8, 0.2});
    EXPECT_TRUE(simulation->Spawn({"post", {MakeDisc({1.5, 0.3}, 0.2)}}));
    Drive(simulation, 1.0, {0.8, 0.2});
    EXPECT_TRUE(simulation->Delete("walker"));
    EXPECT_TRUE(simulation->Delete("post"));
    Drive(simulation, 1.0, {0.8, 0.2});
  };
  World world = WallWorld();
  Walker walker;
  walker.name = "walker";
  walker.home = {2.0, 2.0};
  world.walkers.push_back(walker);
  Simulation first(world, parameters);
  Simulation second(world, parameters);
  Drive(&second, 0.7, {-1.0, 0.0});
  run(&first);
  run(&second);
  EXPECT_EQ(first.TruePose(0).x, second.TruePose(0).x);
  EXPECT_EQ(first.TruePose(0).theta, second.TruePose(0).theta);
  for (std::size_t beam = 0; beam < first.scan(0).ranges.size(); ++beam) {
    const float range = first.scan(0).ranges[beam];
    if (std::isnan(range)) continue;
    EXPECT_EQ(range, second.scan(0).ranges[beam]);
  }
}

TEST(SimulationTest, TheAccelerometerIsWrongByItsBias) {
  SimulationParameters parameters;
  parameters.noise.acceleration_bias = 0.1;
  Simulation simulation(EmptyWorld(), parameters);
  Drive(&simulation, 1.0);
  const ImuReading& imu = simulation.imu(0);
  EXPECT_GT(std::abs(imu.forward_acceleration), 0.079);
  EXPECT_LT(std::abs(imu.forward_acceleration), 0.126);
  EXPECT_NEAR(imu.forward_acceleration, imu.left_acceleration, 1e-3);
  EXPECT_NE(NoisePreset("experiment").acceleration_bias, 0.0);
  EXPECT_EQ(NoisePreset("clean").acceleration_bias, 0.0);
}

TEST(SimulationTest, SetPoseRefusesAnOccupiedPlace) {
  Simulation simulation(WallWorld(), {});
  Drive(&simulation, 0.1);
  EXPECT_FALSE(simulation.SetPose(0, {2.9, 0.0, 0.0}));
  EXPECT_NEAR(simulation.TruePose(0).x, 0.0, 1e-3);
  EXPECT_TRUE(simulation.SetPose(0, {-1.0, 1.0, 1.0}));
  Drive(&simulation, 0.1);
  EXPECT_NEAR(simulation.TruePose(0).y, 1.0, 1e-3);
}

TEST(SimulationTest, SpawnAndDelete) {
  Simulation simulation(EmptyWorld(), {});
  Drive(&simulation, 0.1);
  const StaticObstacle post{"post", {MakeDisc({2.0, 0.0}, 0.2)}};
  EXPECT_FALSE(simulation.Spawn({"on_the_robot", {MakeDisc({0, 0}, 0.2)}}));
  EXPECT_TRUE(simulation.Spawn(post));
  EXPECT_FALSE(simulation.Spawn(post)) << "the name is taken";
  Drive(&simulation, 0.1);
  EXPECT_NEAR(simulation.scan(0).ranges[540], 1.8 - 0.055, 0.01);
  EXPECT_TRUE(simulation.Delete("post"));
  EXPECT_FALSE(simulation.Delete("post"));
  Drive(&simulation, 0.1);
  EXPECT_TRUE(std::isinf(simulation.scan(0).ranges[540]));
}

TEST(SimulationTest, APopUpAppearsOnApproach) {
  World world = EmptyWorld();
  PopUp pop_up;
  pop_up.name = "box";
  pop_up.shapes = {MakeBox({5.0, 0.0, 0.0}, {0.4, 0.4})};
  pop_up.approach_point = {5.0, 0.0};
  pop_up.approach_distance = 3.0;
  world.pop_ups.push_back(pop_up);
  Simulation simulation(world, {});
  while (simulation.TruePose(0).x < 1.9) {
    simulation.SetCommand(0, {1.0, 0.0});
    simulation.Step();
  }
  EXPECT_TRUE(std::isinf(simulation.scan(0).ranges[540]));
  Drive(&simulation, 0.3, {1.0, 0.0});
  EXPECT_FALSE(std::isinf(simulation.scan(0).ranges[540]));
}

TEST(SimulationTest, AWalkerStepsInTheWayAndIsSeen) {
  World world = EmptyWorld();
  Walker walker;
  walker.name = "walker";
  walker.home = {4.0, 2.5};
  world.walkers.push_back(walker);
  Simulation simulation(world, {});
  Drive(&simulation, 0.1);
  EXPECT_TRUE(std::isinf(simulation.scan(0).ranges[540]));
  double nearest = std::numeric_limits<double>::infinity();
  while (simulation.time() < 6.0) {
    simulation.SetCommand(0, {0.5, 0.0});
    simulation.Step();
    nearest = std::min<double>(nearest, simulation.scan(0).ranges[540]);
  }
  EXPECT_LT(nearest, 2.0);
  EXPECT_TRUE(simulation.Delete("walker"));
  Drive(&simulation, 0.1);
  EXPECT_TRUE(std::isinf(simulation.scan(0).ranges[540]));
}

TEST(SimulationTest, TwoRobotsSeeAndTouchEachOther) {
  World world = EmptyWorld();
  world.robots.push_back({"other", {3.0, 0.0, kPi}});
  Simulation simulation(world, {});
  Drive(&simulation, 0.1);
  EXPECT_NEAR(simulation.scan(0).ranges[540], 3.0 - Footprint().front - 0.055,
              0.01);
  EXPECT_NEAR(simulation.scan(1).ranges[540], 3.0 - Footprint().front - 0.055,
              0.01);
  Drive(&simulation, 4.0, {1.0, 0.0});
  ASSERT_TRUE(simulation.collision(0).has_value());
  EXPECT_EQ(simulation.collision(0)->with, "other");
  EXPECT_EQ(simulation.collision(1)->with, "jackal");
  EXPECT_GT(simulation.TruePose(1).x, 3.0) << "pushed away";
}

}  // namespace
}  // namespace vfh_astar
