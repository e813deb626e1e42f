#include "vfh_astar/simulation/solids.h"

#include <algorithm>

namespace vfh_astar {
namespace {

template <typename Named>
bool EraseByName(std::vector<Named>* things, const std::string& name) {
  const auto found =
      std::find_if(things->begin(), things->end(),
                   [&](const Named& thing) { return thing.name == name; });
  if (found == things->end()) return false;
  things->erase(found);
  return true;
}

template <typename Named>
bool AnyNamed(const std::vector<Named>& things, const std::string& name) {
  return std::any_of(things.begin(), things.end(),
                     [&](const Named& thing) { return thing.name == name; });
}

bool IsDue(const PopUp& pop_up, double time,
           const std::vector<SeenRobot>& robots) {
  if (pop_up.time && time >= *pop_up.time) return true;
  return pop_up.approach_distance && !robots.empty() &&
         (robots.front().pose.position() - pop_up.approach_point).norm() <=
             *pop_up.approach_distance;
}

bool TouchesAny(const std::vector<Shape>& shapes,
                const std::vector<SeenRobot>& robots) {
  for (const Shape& shape : shapes) {
    for (const SeenRobot& robot : robots) {
      if (Distance(shape, robot.outline) <= 0.0) return true;
    }
  }
  return false;
}

}  // namespace

Solids::Solids(const World& world)
    : world_(world),
      walkers_(world.walkers.begin(), world.walkers.end()),
      appeared_(world.pop_ups.size(), false) {
  IndexStatics();
  Update(0.0, {});
}

void Solids::IndexStatics() {
  std::vector<Shape> shapes;
  static_owners_.clear();
  for (std::size_t i = 0; i < world_.obstacles.size(); ++i) {
    for (const Shape& shape : world_.obstacles[i].shapes) {
      shapes.push_back(shape);
      static_owners_.push_back(static_cast<int>(i));
    }
  }
  statics_ = ShapeIndex(std::move(shapes));
}

void Solids::Update(double time, const std::vector<SeenRobot>& robots) {
  moving_.clear();
  for (const Mover& mover : world_.movers) {
    const Pose2D place(mover.PositionAt(time), 0.0);
    moving_.push_back({mover.shape.At(place), &mover.name});
  }
  for (std::size_t i = 0; i < world_.pop_ups.size(); ++i) {
    const PopUp& pop_up = world_.pop_ups[i];
    if (!appeared_[i]) {
      appeared_[i] =
          IsDue(pop_up, time, robots) && !TouchesAny(pop_up.shapes, robots);
    }
    if (!appeared_[i]) continue;
    for (const Shape& shape : pop_up.shapes) {
      moving_.push_back({shape, &pop_up.name});
    }
  }
  // Last, as they mind whatever else there is; each minds those before it.
  const auto is_free = [this](const Shape& shape) {
    return !IsOccupied(shape);
  };
  for (std::size_t i = 0; i < walkers_.size(); ++i) {
    walkers_[i].Update(time, robots, is_free);
    moving_.push_back({walkers_[i].shape(), &world_.walkers[i].name});
  }
}

std::vector<NamedShape> Solids::Near(const Eigen::Vector2d& point,
                                     double radius) const {
  std::vector<NamedShape> near;
  for (const int i : statics_.Near(point, radius)) {
    near.push_back(
        {statics_.shapes()[i], &world_.obstacles[static_owners_[i]].name});
  }
  for (const NamedShape& moving : moving_) {
    if ((moving.shape.center - point).norm() <= radius + moving.shape.radius) {
      near.push_back(moving);
    }
  }
  return near;
}

bool Solids::IsOccupied(const Shape& shape) const {
  const std::vector<NamedShape> near = Near(shape.center, shape.radius);
  return std::any_of(near.begin(), near.end(), [&](const NamedShape& solid) {
    return Distance(solid.shape, shape) <= 0.0;
  });
}

bool Solids::HasName(const std::string& name) const {
  return AnyNamed(world_.obstacles, name) || AnyNamed(world_.movers, name) ||
         AnyNamed(world_.pop_ups, name) || AnyNamed(world_.walkers, name);
}

bool Solids::Add(const StaticObstacle& obstacle) {
  if (HasName(obstacle.name)) return false;
  world_.obstacles.push_back(obstacle);
  IndexStatics();
  return true;
}

bool Solids::Remove(const std::string& name) {
  for (std::size_t i = 0; i < world_.pop_ups.size(); ++i) {
    if (world_.pop_ups[i].name == name) appeared_.erase(appeared_.begin() + i);
  }
  for (std::size_t i = 0; i < world_.walkers.size(); ++i) {
    if (world_.walkers[i].name == name) walkers_.erase(walkers_.begin() + i);
  }
  const bool removed = EraseByName(&world_.obstacles, name) ||
                       EraseByName(&world_.walkers, name) ||
                       EraseByName(&world_.movers, name) ||
                       EraseByName(&world_.pop_ups, name);
  // The names that shapes point at have moved in memory.
  moving_.clear();
  IndexStatics();
  return removed;
}

}  // namespace vfh_astar
