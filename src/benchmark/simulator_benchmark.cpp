#include "benchmark/simulator_benchmark.h"

#include <chrono>
#include <cmath>
#include <random>
#include <stdexcept>
#include <vector>

#include "vfh_astar/simulation/jackal.h"
#include "vfh_astar/simulation/lidar.h"
#include "vfh_astar/simulation/simulation.h"

namespace vfh_astar {
namespace {

constexpr double kCylinderRadius = 0.15;  // m
// What every robot does: it drives in a circle of 0.5 m radius.
constexpr Twist2D kCircle{0.5, 1.0};
constexpr double kRoomToCircle = 1.6;  // m around a robot's start.

double WallTime() {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double>(now).count();
}

/// Robots in rows, as far from each other as the field allows.
std::vector<RobotStart> StartsInRows(int robots, double field) {
  const int columns = static_cast<int>(std::ceil(std::sqrt(robots)));
  const double spacing = field / columns;
  std::vector<RobotStart> starts;
  for (int i = 0; i < robots; ++i) {
    const double x = (i % columns + 0.5) * spacing - 0.5 * field;
    const double y = (i / columns + 0.5) * spacing - 0.5 * field;
    starts.push_back({"robot_" + std::to_string(i + 1), Pose2D(x, y, 0.0)});
  }
  return starts;
}

bool HasRoom(const std::vector<RobotStart>& robots,
             const Eigen::Vector2d& place) {
  for (const RobotStart& robot : robots) {
    if ((robot.pose.position() - place).norm() <
        kRoomToCircle + kCylinderRadius) {
      return false;
    }
  }
  return true;
}

World FieldWithCylinders(const SimulatorBenchmarkOptions& options) {
  World world;
  world.name = "field";
  world.robots = StartsInRows(options.robots, options.field);
  const double half = 0.5 * options.field;
  world.obstacles.push_back(
      {"fence",
       MakeWall({{-half, -half}, {half, -half}, {half, half}, {-half, half}},
                0.1, true)});
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate(-half, half);
  for (int i = 0; i < options.cylinders;) {
    const double x = coordinate(random);
    const double y = coordinate(random);
    if (!HasRoom(world.robots, {x, y})) continue;
    ++i;
    world.obstacles.push_back(
        {"cylinder_" + std::to_string(i), {MakeDisc({x, y}, kCylinderRadius)}});
  }
  return world;
}

World WorldOf(const SimulatorBenchmarkOptions& options) {
  World world =
      options.world ? LoadWorld(*options.world) : FieldWithCylinders(options);
  if (world.robots.size() != static_cast<std::size_t>(options.robots)) {
    throw std::invalid_argument(
        "the world has " + std::to_string(world.robots.size()) +
        " robots; expected the " + std::to_string(options.robots) +
        " that are asked for");
  }
  if (options.start) world.robots.front().pose = *options.start;
  return world;
}

SimulationParameters ParametersOf(const SimulatorBenchmarkOptions& options) {
  SimulationParameters parameters;
  parameters.laser.beams = options.beams;
  parameters.laser.rate = options.scan_rate;
  return parameters;
}

void CheckStarts(Simulation* simulation) {
  for (std::size_t i = 0; i < simulation->robot_count(); ++i) {
    if (!simulation->SetPose(i, simulation->TruePose(i))) {
      throw std::invalid_argument("robot '" + simulation->robot_name(i) +
                                  "' would not be free at its start");
    }
  }
}

/// Wall time in s of a second's worth of sweeps of all robots, where they are.
double TimeSweeps(const Simulation& simulation, int sweeps) {
  std::vector<Shape> statics;
  for (const StaticObstacle& obstacle : simulation.world().obstacles) {
    statics.insert(statics.end(), obstacle.shapes.begin(),
                   obstacle.shapes.end());
  }
  const ShapeIndex index(statics);
  Lidar lidar(simulation.laser(0), simulation.parameters().noise);
  std::vector<Shape> outlines;
  for (std::size_t i = 0; i < simulation.robot_count(); ++i) {
    outlines.push_back(OutlineOf(Footprint(), simulation.TruePose(i)));
  }
  std::mt19937 random(1);
  const double start = WallTime();
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    const std::size_t robot = sweep % outlines.size();
    std::vector<const Shape*> others;
    for (std::size_t i = 0; i < outlines.size(); ++i) {
      if (i != robot) others.push_back(&outlines[i]);
    }
    lidar.Sweep(0.0, simulation.TruePose(robot), index, others, &random);
  }
  return WallTime() - start;
}

}  // namespace

SimulatorFigures RunSimulatorBenchmark(
    const SimulatorBenchmarkOptions& options) {
  Simulation simulation(WorldOf(options), ParametersOf(options));
  CheckStarts(&simulation);
  std::int64_t steps = 0;
  const double start = WallTime();
  while (simulation.time() < options.seconds) {
    for (std::size_t i = 0; i < simulation.robot_count(); ++i) {
      simulation.SetCommand(i, kCircle);
    }
    simulation.Step();
    ++steps;
  }
  const double wall_time = WallTime() - start;

  constexpr int kSweeps = 2000;
  const double sweep_time = TimeSweeps(simulation, kSweeps);
  SimulatorFigures figures;
  figures.realtime_factor = simulation.time() / wall_time;
  figures.steps_per_s = static_cast<double>(steps) / wall_time;
  figures.rays_per_s =
      static_cast<double>(kSweeps) * options.beams / sweep_time;
  return figures;
}

}  // namespace vfh_astar
