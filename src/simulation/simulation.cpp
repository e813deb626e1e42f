#include "vfh_astar/simulation/simulation.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include "vfh_astar/simulation/jackal.h"
#include "vfh_astar/simulation/lidar.h"
#include "vfh_astar/simulation/solids.h"

namespace vfh_astar {
namespace {

constexpr double kClearanceReach = 5.0;  ///< m

}  // namespace

class Simulation::Impl {
 public:
  Impl(const World& world, const SimulationParameters& parameters)
      : world_(world), parameters_(parameters) {
    Reset(parameters.seed);
  }

  struct Robot {
    Robot(PhysicsWorld* physics, const JackalModel& model,
          const RobotStart& start, const SimulationParameters& parameters,
          std::mt19937* random)
        : name(start.name),
          body(physics, model, start.pose),
          sensors(DrawErrors(parameters.noise, random), model),
          laser(start.laser.value_or(parameters.laser)),
          lidar(laser, parameters.noise) {}

    std::string name;
    Jackal body;
    RobotSensors sensors;
    LaserModel laser;
    Lidar lidar;
    std::int64_t scans = 0;     ///< taken since the start.
    bool has_new_scan = false;  ///< since the last step.
    Twist2D command;
    double command_time = 0.0;
    std::optional<Collision> collision;
  };

  double time() const { return steps_ * parameters_.step; }

  void Reset(std::uint32_t seed);
  StepEvents Step();
  void SetCommand(std::size_t robot, const Twist2D& command) {
    robots_[robot].command = command;
    robots_[robot].command_time = time();
  }
  bool SetPose(std::size_t robot, const Pose2D& pose);
  bool Spawn(const StaticObstacle& obstacle);
  bool Delete(const std::string& name);
  double Clearance(std::size_t robot) const;

  World world_;
  SimulationParameters parameters_;
  JackalModel model_;
  std::unique_ptr<PhysicsWorld> physics_;  // outlives the robots in it
  std::vector<Robot> robots_;

 private:
  std::vector<Shape> Outlines() const;
  std::vector<SeenRobot> SeenRobots() const;
  void Collide(std::size_t index, const std::vector<Shape>& outlines);
  void NoteCollision(Robot* robot, const std::string& with);
  bool TakeScans(double now);
  void TakeScan(std::size_t index, const std::vector<Shape>& outlines);
  bool IsFree(const Shape& outline, std::size_t except) const;

  std::unique_ptr<Solids> solids_;
  std::mt19937 random_;
  std::int64_t steps_ = 0;
  std::int64_t readings_ = 0;
  double last_reading_ = 0.0;
};

void Simulation::Impl::Reset(std::uint32_t seed) {
  robots_.clear();
  physics_ = std::make_unique<PhysicsWorld>();
  solids_ = std::make_unique<Solids>(world_);
  random_.seed(seed);
  robots_.reserve(world_.robots.size());
  for (const RobotStart& start : world_.robots) {
    robots_.emplace_back(physics_.get(), model_, start, parameters_, &random_);
  }
  steps_ = 0;
  readings_ = 0;
  last_reading_ = 0.0;
}

std::vector<Shape> Simulation::Impl::Outlines() const {
  std::vector<Shape> outlines;
  outlines.reserve(robots_.size());
  for (const Robot& robot : robots_) outlines.push_back(robot.body.Outline());
  return outlines;
}

std::vector<SeenRobot> Simulation::Impl::SeenRobots() const {
  std::vector<SeenRobot> seen;
  seen.reserve(robots_.size());
  for (const Robot& robot : robots_) {
    seen.push_back({robot.body.pose(), robot.body.Outline(),
                    robot.body.velocity().norm()});
  }
  return seen;
}

void Simulation::Impl::NoteCollision(Robot* robot, const std::string& with) {
  if (robot->collision) return;
  robot->collision = Collision{time(), with, robot->body.velocity().norm()};
}

void Simulation::Impl::Collide(std::size_t index,
                               const std::vector<Shape>& outlines) {
  Robot& robot = robots_[index];
  const Shape& outline = outlines[index];
  for (const NamedShape& solid :
       solids_->Near(outline.center, outline.radius)) {
    for (const ContactPoint& contact : FindContact(outline, solid.shape)) {
      robot.body.Touch(contact);
      NoteCollision(&robot, *solid.name);
    }
  }
  for (std::size_t other = index + 1; other < robots_.size(); ++other) {
    for (const ContactPoint& contact : FindContact(outline, outlines[other])) {
      robot.body.Touch(contact, &robots_[other].body);
      NoteCollision(&robot, robots_[other].name);
      NoteCollision(&robots_[other], robot.name);
    }
  }
}

void Simulation::Impl::TakeScan(std::size_t index,
                                const std::vector<Shape>& outlines) {
  std::vector<const Shape*> moving;
  for (const NamedShape& solid : solids_->moving()) {
    moving.push_back(&solid.shape);
  }
  for (std::size_t other = 0; other < outlines.size(); ++other) {
    if (other != index) moving.push_back(&outlines[other]);
  }
  Robot& robot = robots_[index];
  robot.lidar.Sweep(time(), robot.body.pose(), solids_->statics(), moving,
                    &random_);
}

/// @param[in] now s, at which those scans are due that are.
/// @return whether there was one.
bool Simulation::Impl::TakeScans(double now) {
  bool any = false;
  for (Robot& robot : robots_) {
    robot.has_new_scan = now >= (robot.scans + 1) / robot.laser.rate;
    if (robot.has_new_scan) ++robot.scans;
    any = any || robot.has_new_scan;
  }
  if (!any) return false;
  const std::vector<Shape> outlines = Outlines();
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    if (robots_[i].has_new_scan) TakeScan(i, outlines);
  }
  return true;
}

StepEvents Simulation::Impl::Step() {
  const double step = parameters_.step;
  const std::vector<Shape> outlines = Outlines();
  if (solids_->MayChange()) solids_->Update(time(), SeenRobots());
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    Robot& robot = robots_[i];
    const bool timed_out =
        time() - robot.command_time > parameters_.command_timeout;
    robot.body.Control(timed_out ? Twist2D() : robot.command, step);
    robot.body.TouchGround(world_.ground);
    Collide(i, outlines);
  }
  physics_->Step(step);
  ++steps_;
  for (Robot& robot : robots_) robot.body.CountWheelTurns(step);

  // Half a step of tolerance, so that rounding does not put a reading off.
  const double now = time() + 0.5 * step;
  StepEvents events;
  if (now >= (readings_ + 1) / parameters_.odometry_rate) {
    ++readings_;
    events.odometry = true;
    for (Robot& robot : robots_) {
      robot.sensors.Read(time(), time() - last_reading_, robot.body, &random_);
    }
    last_reading_ = time();
  }
  events.scan = TakeScans(now);
  return events;
}

bool Simulation::Impl::IsFree(const Shape& outline, std::size_t except) const {
  if (solids_->IsOccupied(outline)) return false;
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    if (i != except && Distance(outline, robots_[i].body.Outline()) <= 0.0) {
      return false;
    }
  }
  return true;
}

bool Simulation::Impl::SetPose(std::size_t robot, const Pose2D& pose) {
  if (!IsFree(OutlineOf(model_.footprint, pose), robot)) return false;
  robots_[robot].body.Place(pose);
  robots_[robot].command = Twist2D();
  return true;
}

bool Simulation::Impl::Spawn(const StaticObstacle& obstacle) {
  for (const Shape& outline : Outlines()) {
    for (const Shape& shape : obstacle.shapes) {
      if (Distance(shape, outline) <= 0.0) return false;
    }
  }
  return solids_->Add(obstacle);
}

bool Simulation::Impl::Delete(const std::string& name) {
  const bool removed = solids_->Remove(name);
  solids_->Update(time(), SeenRobots());
  return removed;
}

double Simulation::Impl::Clearance(std::size_t robot) const {
  const Shape outline = robots_[robot].body.Outline();
  double clearance = std::numeric_limits<double>::infinity();
  // From near to far, as there is much in a large circle.
  for (double reach = 0.5;; reach = std::min(2.0 * reach, kClearanceReach)) {
    for (const NamedShape& solid :
         solids_->Near(outline.center, outline.radius + reach)) {
      clearance = std::min(clearance, Distance(outline, solid.shape));
    }
    if (clearance <= reach || reach == kClearanceReach) break;
  }
  for (std::size_t other = 0; other < robots_.size(); ++other) {
    if (other == robot) continue;
    clearance =
        std::min(clearance, Distance(outline, robots_[other].body.Outline()));
  }
  return clearance <= kClearanceReach ? clearance
                                      : std::numeric_limits<double>::infinity();
}

Simulation::Simulation(const World& world,
                       const SimulationParameters& parameters)
    : impl_(std::make_unique<Impl>(world, parameters)) {}

Simulation::~Simulation() = default;

const World& Simulation::world() const { return impl_->world_; }

const SimulationParameters& Simulation::parameters() const {
  return impl_->parameters_;
}

double Simulation::time() const { return impl_->time(); }

std::size_t Simulation::robot_count() const { return impl_->robots_.size(); }

const std::string& Simulation::robot_name(std::size_t robot) const {
  return impl_->robots_[robot].name;
}

void Simulation::SetCommand(std::size_t robot, const Twist2D& command) {
  impl_->SetCommand(robot, command);
}

const LaserModel& Simulation::laser(std::size_t robot) const {
  return impl_->robots_[robot].laser;
}

StepEvents Simulation::Step() { return impl_->Step(); }

bool Simulation::HasNewScan(std::size_t robot) const {
  return impl_->robots_[robot].has_new_scan;
}

const LaserScan& Simulation::scan(std::size_t robot) const {
  return impl_->robots_[robot].lidar.scan();
}

const OdometryReading& Simulation::wheel_odometry(std::size_t robot) const {
  return impl_->robots_[robot].sensors.wheels();
}

const OdometryReading& Simulation::filtered_odometry(std::size_t robot) const {
  return impl_->robots_[robot].sensors.filtered();
}

const ImuReading& Simulation::imu(std::size_t robot) const {
  return impl_->robots_[robot].sensors.imu();
}

Pose2D Simulation::TruePose(std::size_t robot) const {
  return impl_->robots_[robot].body.pose();
}

Twist2D Simulation::TrueTwist(std::size_t robot) const {
  return impl_->robots_[robot].body.twist();
}

std::array<double, 4> Simulation::WheelAngles(std::size_t robot) const {
  return impl_->robots_[robot].body.wheel_angles();
}

double Simulation::Clearance(std::size_t robot) const {
  return impl_->Clearance(robot);
}

const std::optional<Collision>& Simulation::collision(std::size_t robot) const {
  return impl_->robots_[robot].collision;
}

void Simulation::Reset(std::uint32_t seed) { impl_->Reset(seed); }

bool Simulation::SetPose(std::size_t robot, const Pose2D& pose) {
  return impl_->SetPose(robot, pose);
}

bool Simulation::Spawn(const StaticObstacle& obstacle) {
  return impl_->Spawn(obstacle);
}

bool Simulation::Delete(const std::string& name) { return impl_->Delete(name); }

}  // namespace vfh_astar
