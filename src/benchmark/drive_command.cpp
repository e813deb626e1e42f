#include "benchmark/drive_command.h"

#include <fstream>
#include <stdexcept>

#include "benchmark/drive.h"
#include "benchmark/figure_eight.h"
#include "benchmark/pose_option.h"
#include "benchmark/quantile.h"

namespace vfh_astar {
namespace {

namespace po = boost::program_options;

po::options_description Options() {
  po::options_description options("drive");
  auto add = options.add_options();
  add("world", po::value<std::string>(), "world or map file");
  add("figure-eight", po::value<double>(),
      "m/s: a lap of this speed in an empty world, instead of a world");
  add("start", po::value<std::string>(), "X,Y,YAW (m, rad)");
  add("goal", po::value<std::string>(), "X,Y,YAW (m, rad)");
  add("config", po::value<std::string>(), "parameters of the stack");
  add("laser", po::value<std::string>()->default_value("paper"), "preset");
  add("noise", po::value<std::string>()->default_value("clean"), "preset");
  add("seed", po::value<std::uint32_t>()->default_value(1), "of all chance");
  add("time-limit", po::value<double>()->default_value(100.0), "s");
  add("finish-radius", po::value<double>()->default_value(0.0),
      "m from the goal that count as there; 0: as the robot says");
  add("start-distance", po::value<double>()->default_value(0.0),
      "m from the start at which time begins");
  add("trace", po::value<std::string>(), "CSV file for the drive's course");
  add("motions", po::value<std::string>(),
      "CSV file for its paths and trajectories");
  return options;
}

/// The world with its start and goal.
void ReadScene(const po::variables_map& options, DriveTask* task) {
  if (options.count("world") == 0) {
    throw OptionError("expected --world or --figure-eight");
  }
  task->world = LoadWorld(options["world"].as<std::string>());
  if (options.count("start") != 0) {
    task->world.robots.front().pose =
        ParsePoseOption("start", options["start"].as<std::string>());
  }
  if (options.count("goal") != 0) {
    task->goal = ParsePoseOption("goal", options["goal"].as<std::string>());
  } else if (task->world.goal) {
    task->goal = *task->world.goal;
  } else {
    throw OptionError("the world suggests no goal; expected --goal");
  }
  MakeRoomInMap(task);
}

/// An empty world with a figure eight to be driven in it.
void SetFigureEight(double speed, DriveTask* task) {
  task->world.name = "figure_eight";
  task->world.robots = {{"robot_1", FigureEightStart()}};
  task->goal = FigureEightStart();
  task->course = FigureEight(speed, task->stack.fitter.limits);
}

DriveTask TaskFrom(const po::variables_map& options) {
  DriveTask task;
  if (options.count("config") != 0) {
    task.stack = LoadStackParameters(options["config"].as<std::string>());
  }
  if (options.count("figure-eight") == 0) {
    ReadScene(options, &task);
  } else {
    SetFigureEight(NumberOption(options, "figure-eight", 0.05, 10.0), &task);
  }
  task.simulation.laser = LaserPreset(options["laser"].as<std::string>());
  task.simulation.noise = NoisePreset(options["noise"].as<std::string>());
  task.simulation.seed = options["seed"].as<std::uint32_t>();
  task.time_limit = NumberOption(options, "time-limit", 0.1, 1e5);
  task.finish_radius = NumberOption(options, "finish-radius", 0.0, 1e3);
  task.start_distance = NumberOption(options, "start-distance", 0.0, 1e3);
  return task;
}

void WriteTrace(const std::string& file, const DriveResult& result) {
  std::ofstream stream(file);
  stream << "time,x,y,theta,v,w,command_v,command_w,state,limited,e1,e2,e3,"
            "clearance,reference_x,reference_y,reason,movers\n";
  for (const DriveSample& sample : result.samples) {
    const NavigatorStatus& status = sample.status;
    stream << sample.time << ',' << sample.pose.x << ',' << sample.pose.y << ','
           << sample.pose.theta << ',' << sample.twist.v << ','
           << sample.twist.w << ',' << sample.command.v << ','
           << sample.command.w << ',' << ToString(status.state) << ','
           << status.limited << ',' << status.error[0] << ',' << status.error[1]
           << ',' << status.error[2] << ',' << status.clearance << ',';
    if (status.reference) {
      stream << status.reference->pose.x << ',' << status.reference->pose.y;
    } else {
      stream << ',';
    }
    stream << ",\"" << status.reason << "\",";
    // Each as x y vx vy radius, with semicolons between them; in the world as
    // the robot saw them from where it truly was.
    const Pose2D world_from_map = sample.pose * status.pose.Inverse();
    for (const MovingObstacle& seen : status.movers) {
      const MovingObstacle mover = Transform(world_from_map, seen);
      stream << mover.position.x() << ' ' << mover.position.y() << ' '
             << mover.velocity.x() << ' ' << mover.velocity.y() << ' '
             << mover.radius << ';';
    }
    stream << '\n';
  }
  if (!stream) throw std::runtime_error("cannot write the trace " + file);
}

/// Lines of points, each under the number and the time of its motion.
void WriteMotions(const std::string& file, const DriveResult& result) {
  constexpr double kStep = 0.1;  // s between points of a trajectory.
  std::ofstream stream(file);
  stream << "motion,time,line,x,y\n";
  for (std::size_t i = 0; i < result.motions.size(); ++i) {
    const DriveMotion& motion = result.motions[i];
    const auto write = [&](const char* line, const Eigen::Vector2d& point) {
      stream << i << ',' << motion.time << ',' << line << ',' << point.x()
             << ',' << point.y() << '\n';
    };
    for (const Eigen::Vector2d& point : motion.path) write("path", point);
    if (motion.trajectory.empty()) continue;
    const double duration = motion.trajectory.duration();
    for (double t = 0.0; t < duration + kStep; t += kStep) {
      write("trajectory",
            motion.trajectory.Sample(std::min(t, duration)).pose.position());
    }
  }
  if (!stream) throw std::runtime_error("cannot write the motions " + file);
}

nlohmann::json ToJson(const DriveResult& result) {
  nlohmann::json json = {
      {"outcome", result.outcome},
      {"message", result.message},
      {"time_s", result.time},
      {"path_m", result.path},
      {"min_clearance_m", result.min_clearance},
      {"replans", result.replans},
      {"rms_error_m", result.rms_error},
      {"max_error_m", result.max_error},
      {"true_rms_error_m", result.true_rms_error},
      {"pose_error_m", result.pose_error},
      {"max_pose_error_m", result.max_pose_error},
      {"goal_heading_error_deg", result.goal_heading_error * 180.0 / kPi}};
  if (result.collision) {
    json["collision"] = {{"time_s", result.collision->time},
                         {"with", result.collision->with},
                         {"robot_speed", result.collision->robot_speed}};
  }
  return json;
}

nlohmann::json Run(const po::variables_map& options) {
  StageTimes times;
  DriveTask task = TaskFrom(options);
  task.times = &times;
  const DriveResult result = Drive(task);
  if (options.count("trace") != 0) {
    WriteTrace(options["trace"].as<std::string>(), result);
  }
  if (options.count("motions") != 0) {
    WriteMotions(options["motions"].as<std::string>(), result);
  }
  nlohmann::json json = ToJson(result);
  const std::vector<double>& ticks = times.Of(Stage::kControlTick);
  if (!ticks.empty()) {
    json["control_tick_median_us"] = Quantile(ticks, 0.5);
    json["control_tick_p99_us"] = Quantile(ticks, 0.99);
  }
  return json;
}

}  // namespace

Command DriveCommand() { return {"drive", Options(), Run}; }

}  // namespace vfh_astar
