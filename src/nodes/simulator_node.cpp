#include "simulator_node.h"

#include <rosgraph_msgs/Clock.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace vfh_astar {
namespace {

constexpr double kClockPeriod = 0.01;  // s of simulated time, at most.
// s of the wall clock for which services wait at most while topics are served.
constexpr double kServicePeriod = 0.01;

World LoadWorldOf(const SimulatorParameters& parameters) {
  WorldLoadOptions options;
  options.solid_below = parameters.solid_below;
  World world = LoadWorld(parameters.world, options);
  world.robots.front().pose = parameters.Start(world.robots.front().pose);
  return world;
}

SimulationParameters SimulationParametersOf(
    const SimulatorParameters& parameters) {
  SimulationParameters simulation;
  simulation.laser = LaserPreset(parameters.laser);
  simulation.noise = NoisePreset(parameters.noise);
  simulation.seed = static_cast<std::uint32_t>(parameters.seed);
  return simulation;
}

std::string ToText(const Pose2D& pose) {
  std::ostringstream text;
  text << "(" << pose.x << " m, " << pose.y << " m, " << pose.theta << " rad)";
  return text.str();
}

double WallTime() { return ros::SteadyTime::now().toSec(); }

/// Answers a service by a success, or by the reason for a failure.
template <typename Response>
bool Answer(const std::string& failure, Response& response) {
  response.success = failure.empty();
  response.message = failure;
  return true;
}

}  // namespace

SimulatorNode::SimulatorNode(const SimulatorParameters& parameters)
    : parameters_(parameters),
      simulation_(LoadWorldOf(parameters), SimulationParametersOf(parameters)),
      seed_(simulation_.parameters().seed),
      steps_per_tick_(std::max(
          1, static_cast<int>(kClockPeriod / simulation_.parameters().step +
                              1e-9))),
      pace_(parameters.real_time_factor) {
  clock_publisher_ =
      ros::NodeHandle().advertise<rosgraph_msgs::Clock>("/clock", 50);
  AddRobots();
  AdvertiseServices();
}

void SimulatorNode::AddRobots() {
  const std::vector<RobotStart>& starts = simulation_.world().robots;
  std::vector<geometry_msgs::TransformStamped> laser_transforms;
  for (std::size_t i = 0; i < starts.size(); ++i) {
    const std::string& name = starts[i].name;
    // Where it stands already, unless something is in the way.
    if (!simulation_.SetPose(i, starts[i].pose)) {
      throw std::invalid_argument(
          parameters_.world + ": robot '" + name + "' cannot start at " +
          ToText(starts[i].pose) + ": it would touch something there");
    }
    const std::string prefix = starts.size() > 1 ? name : "";
    ros::NodeHandle node(prefix);
    node.setCallbackQueue(&topic_queue_);
    robots_.push_back(std::make_unique<RobotTopics>(
        node, &simulation_, i, prefix, parameters_.lockstep));
    laser_transforms.push_back(robots_.back()->LaserTransform());
  }
  static_broadcaster_.sendTransform(laser_transforms);
}

void SimulatorNode::AdvertiseServices() {
  ros::NodeHandle node;
  ros::NodeHandle private_node("~");
  node.setCallbackQueue(&service_queue_);
  private_node.setCallbackQueue(&service_queue_);
  services_ = {
      node.advertiseService("reset", &SimulatorNode::OnReset, this),
      node.advertiseService("step", &SimulatorNode::OnStep, this),
      node.advertiseService("set_pose", &SimulatorNode::OnSetPose, this),
      node.advertiseService("spawn", &SimulatorNode::OnSpawn, this),
      node.advertiseService("delete", &SimulatorNode::OnDelete, this),
      // Private, as `pause` is the navigation's service.
      private_node.advertiseService("pause", &SimulatorNode::OnPause, this)};
}

void SimulatorNode::Run() {
  double wait = 0.0;
  while (ros::ok()) {
    Serve(wait);
    wait = WaitTime();
    if (wait <= 0.0) Advance(steps_per_tick_);
  }
}

void SimulatorNode::Serve(double patience) {
  topic_queue_.callAvailable(
      ros::WallDuration(std::min(patience, kServicePeriod)));
  service_queue_.callAvailable();
}

double SimulatorNode::WaitTime() {
  if (is_paused_) return std::numeric_limits<double>::infinity();
  const double hold = HoldTime();
  if (hold > 0.0) return hold;
  return pace_.WaitTime(WallTime(), simulation_.time());
}

double SimulatorNode::HoldTime() {
  if (!is_held_) return 0.0;
  is_held_ = !std::all_of(robots_.begin(), robots_.end(),
                          [](const auto& robot) { return robot->HasAnswer(); });
  if (!is_held_) return 0.0;
  const double rest = hold_deadline_ - WallTime();
  if (rest > 0.0) return rest;
  is_held_ = false;
  for (const auto& robot : robots_) {
    if (!robot->HasAnswer()) robot->GiveUpAnswer();
  }
  ROS_WARN_THROTTLE(10.0,
                    "lock-step: the scan of %.3f s was not answered within %g "
                    "s of the wall clock; going on without",
                    simulation_.time(), parameters_.lockstep_timeout);
  return 0.0;
}

void SimulatorNode::AwaitAnswers() {
  while (ros::ok()) {
    const double hold = HoldTime();
    topic_queue_.callAvailable(ros::WallDuration(hold));
    if (hold <= 0.0) return;
  }
}

void SimulatorNode::PublishClock() {
  rosgraph_msgs::Clock clock;
  clock.clock.fromSec(simulation_.time());
  clock_publisher_.publish(clock);
}

int SimulatorNode::Advance(int max_steps) {
  StepEvents events;
  int steps = 0;
  while (steps < max_steps && !events.scan && !events.odometry) {
    events = simulation_.Step();
    ++steps;
  }
  PublishClock();
  for (const auto& robot : robots_) robot->Publish(events);
  if (events.scan && parameters_.lockstep) {
    is_held_ = true;
    hold_deadline_ = WallTime() + parameters_.lockstep_timeout;
  }
  return steps;
}

std::optional<std::size_t> SimulatorNode::FindRobot(
    const std::string& name) const {
  if (name.empty()) return 0;
  for (std::size_t i = 0; i < simulation_.robot_count(); ++i) {
    if (simulation_.robot_name(i) == name) return i;
  }
  return std::nullopt;
}

bool SimulatorNode::OnReset(Reset::Request& request, Reset::Response&) {
  // A command that is on its way must not become the first of the new run.
  AwaitAnswers();
  if (request.seed != 0) seed_ = request.seed;
  simulation_.Reset(seed_);
  is_held_ = false;
  pace_.Restart();
  // Who sees time go back forgets transforms, and must not forget new ones.
  PublishClock();
  for (const auto& robot : robots_) robot->BeginAnew();
  return true;
}

bool SimulatorNode::OnPause(std_srvs::SetBool::Request& request,
                            std_srvs::SetBool::Response& response) {
  is_paused_ = request.data;
  pace_.Restart();
  return Answer("", response);
}

bool SimulatorNode::OnStep(Step::Request& request, Step::Response& response) {
  is_paused_ = true;
  std::uint32_t done = 0;
  while (done < request.steps && ros::ok()) {
    AwaitAnswers();
    const std::uint32_t rest = request.steps - done;
    done += Advance(
        static_cast<int>(std::min<std::uint32_t>(rest, steps_per_tick_)));
  }
  AwaitAnswers();
  response.time.fromSec(simulation_.time());
  return true;
}

bool SimulatorNode::OnSetPose(SetPose::Request& request,
                              SetPose::Response& response) {
  const Pose2D pose(request.x, request.y, request.yaw);
  const std::optional<std::size_t> robot = FindRobot(request.robot);
  if (!robot) {
    return Answer("there is no robot '" + request.robot + "'", response);
  }
  if (!pose.IsFinite()) {
    return Answer("the pose " + ToText(pose) + " is not finite", response);
  }
  if (!simulation_.SetPose(*robot, pose)) {
    return Answer("the robot would touch something at " + ToText(pose),
                  response);
  }
  return Answer("", response);
}

bool SimulatorNode::OnSpawn(Spawn::Request& request,
                            Spawn::Response& response) {
  const Pose2D pose(request.x, request.y, request.yaw);
  const Eigen::Vector2d size(request.length, request.width);
  const bool is_cylinder = request.radius > 0.0 && size.isZero(0.0);
  const bool is_box = request.radius == 0.0 && size.minCoeff() > 0.0;
  if (request.name.empty()) return Answer("the name is empty", response);
  if (!pose.IsFinite() || !size.allFinite() || !std::isfinite(request.radius) ||
      is_cylinder == is_box) {
    std::ostringstream failure;
    failure << "radius is " << request.radius << ", length " << request.length
            << ", width " << request.width << ", the pose " << ToText(pose)
            << "; expected finite numbers, and either a positive radius or a "
               "positive length and width";
    return Answer(failure.str(), response);
  }
  StaticObstacle obstacle;
  obstacle.name = request.name;
  obstacle.shapes = {is_cylinder ? MakeDisc(pose.position(), request.radius)
                                 : MakeBox(pose, size)};
  if (!simulation_.Spawn(obstacle)) {
    return Answer(
        "the name '" + request.name + "' is taken, or a robot stands there",
        response);
  }
  return Answer("", response);
}

bool SimulatorNode::OnDelete(Delete::Request& request,
                             Delete::Response& response) {
  return Answer(simulation_.Delete(request.name)
                    ? ""
                    : "there is nothing named '" + request.name + "'",
                response);
}

}  // namespace vfh_astar
