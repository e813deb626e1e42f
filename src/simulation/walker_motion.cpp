#include "vfh_astar/simulation/walker_motion.h"

#include <algorithm>

namespace vfh_astar {
namespace {

/// m/s; a robot that is slower has no way that one could step into.
constexpr double kMoving = 0.1;
/// s for which a walker thinks ahead where a robot will be.
constexpr double kFarthestForesight = 4.0;
/// s for which a walker waits on its way.
constexpr double kPatience = 1.0;

const SeenRobot* Nearest(const std::vector<SeenRobot>& robots,
                         const Eigen::Vector2d& place) {
  const auto distance = [&place](const SeenRobot& robot) {
    return (robot.pose.position() - place).norm();
  };
  const auto nearest =
      std::min_element(robots.begin(), robots.end(),
                       [&](const SeenRobot& a, const SeenRobot& b) {
                         return distance(a) < distance(b);
                       });
  return nearest == robots.end() ? nullptr : &*nearest;
}

}  // namespace

Eigen::Vector2d WalkerMotion::PlaceToMeet(const SeenRobot& robot) const {
  // How long the walk takes depends on how far the robot gets meanwhile.
  Eigen::Vector2d place = robot.pose.position();
  double duration = 0.0;
  for (int round = 0; round < 10; ++round) {
    place = robot.pose *
            Eigen::Vector2d(walker_.ahead + robot.speed * duration, 0.0);
    duration = std::min((place - position_).norm() / walker_.speed,
                        kFarthestForesight);
  }
  return place;
}

void WalkerMotion::Notice(const std::vector<SeenRobot>& robots) {
  const SeenRobot* robot = Nearest(robots, position_);
  if (robot == nullptr || robot->speed < kMoving ||
      (robot->pose.position() - position_).norm() > walker_.notice) {
    return;
  }
  state_ = State::kStepping;
  state_time_ = 0.0;
  target_ = PlaceToMeet(*robot);
  ++times_;
}

bool WalkerMotion::Walk(double duration, const std::vector<SeenRobot>& robots,
                        const std::function<bool(const Shape&)>& is_free) {
  const Eigen::Vector2d way = target_ - position_;
  const double length = std::min(walker_.speed * duration, way.norm());
  if (length <= 0.0) return true;
  const Eigen::Vector2d next = position_ + length * way.normalized();
  const Shape there = MakeDisc(next, walker_.radius);
  for (const SeenRobot& robot : robots) {
    const double distance = Distance(robot.outline, there);
    if (distance < walker_.keep &&
        distance < Distance(robot.outline, shape())) {
      return false;
    }
  }
  if (!is_free(there)) return false;
  position_ = next;
  return true;
}

void WalkerMotion::Update(double time, const std::vector<SeenRobot>& robots,
                          const std::function<bool(const Shape&)>& is_free) {
  const double duration = time - time_;
  time_ = time;
  if (duration <= 0.0) return;
  switch (state_) {
    case State::kWaiting:
      if (times_ < walker_.times) Notice(robots);
      break;
    case State::kStanding:
      state_time_ += duration;
      if (state_time_ < walker_.stand) break;
      if (times_ < walker_.times) {
        // From where it stands it may step into the way again.
        state_ = State::kWaiting;
      } else {
        state_ = State::kLeaving;
        target_ = walker_.home;
      }
      break;
    case State::kStepping:
      if (!Walk(duration, robots, is_free)) state_time_ += duration;
      if (position_ == target_ || state_time_ > kPatience) {
        state_ = State::kStanding;
        state_time_ = 0.0;
      }
      break;
    case State::kLeaving:
      Walk(duration, robots, is_free);
      break;
  }
}

}  // namespace vfh_astar
