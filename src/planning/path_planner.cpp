#include "vfh_astar/planning/path_planner.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdarg>
#include <cstdio>

#include "vfh_astar/planning/known_path.h"
#include "vfh_astar/planning/start_clearing.h"

namespace vfh_astar {
namespace {

// How far clearance reaches beyond the farthest corner, so that one look at it
// tells where the footprint is free at every heading: half the diagonal of a
// cell of 0.1 m, and some.
constexpr double kBeyondFootprint = 0.1;

// Keeps a cell exactly at the limit free, as it is in the cost map.
constexpr double kRounding = 1e-4;

UnknownSpace ToUnknownSpace(const std::string& name) {
  if (name == "forbidden") return UnknownSpace::kForbidden;
  if (name == "priced") return UnknownSpace::kPriced;
  assert(name == "free");
  return UnknownSpace::kFree;
}

__attribute__((format(printf, 1, 2))) std::string Sentence(const char* format,
                                                           ...) {
  char text[512];
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(text, sizeof(text), format, arguments);
  va_end(arguments);
  return text;
}

PlanResult Failure(Outcome outcome, const std::string& message) {
  PlanResult result;
  result.outcome = outcome;
  result.message = message;
  return result;
}

std::string OutsideMap(const char* what, const Pose2D& pose,
                       const GridGeometry& geometry) {
  const Eigen::Vector2d end =
      geometry.origin +
      geometry.resolution * Eigen::Vector2d(geometry.width, geometry.height);
  return Sentence(
      "the %s (%.2f, %.2f) lies outside the map, which spans x %.2f to %.2f m "
      "and y %.2f to %.2f m",
      what, pose.x, pose.y, geometry.origin.x(), end.x(), geometry.origin.y(),
      end.y());
}

}  // namespace

void PathPlannerParameters::Read(ParameterReader& reader) {
  reader.Group("footprint", footprint);
  reader.Integer("occupied_threshold", occupied_threshold, 1, 100);
  reader.Number("safety_margin", safety_margin, 0.0, 1.0);
  reader.Number("inflation_radius", inflation_radius, 0.0, 5.0);
  reader.Number("inflation_weight", inflation_weight, 1.0, 10.0);
  reader.Choice("unknown_space", unknown_space,
                {"forbidden", "free", "priced"});
  reader.Number("unknown_price", unknown_price, 0.0, 5.0);
  reader.Number("keep_margin", keep_margin, 0.0, 1.0);
}

CostModel CostModelFor(const PathPlannerParameters& parameters) {
  CostModel model;
  model.lethal_clearance =
      parameters.footprint.InscribedRadius() + parameters.safety_margin;
  model.inflation_clearance = parameters.inflation_radius;
  model.weight = parameters.inflation_weight;
  model.unknown = ToUnknownSpace(parameters.unknown_space);
  model.unknown_price = parameters.unknown_price;
  return model;
}

double ClearanceReach(const PathPlannerParameters& parameters) {
  return std::max(parameters.inflation_radius,
                  parameters.footprint.CircumscribedRadius() +
                      parameters.safety_margin + kBeyondFootprint);
}

Footprint PassageFootprint(const PathPlannerParameters& parameters) {
  return parameters.footprint.Grown(parameters.safety_margin - kRounding);
}

PathPlanner::PathPlanner(const PathPlannerParameters& parameters)
    : parameters_(parameters),
      clearance_(parameters.occupied_threshold, ClearanceReach(parameters)),
      costs_(CostModelFor(parameters)) {}

void PathPlanner::SetMap(const OccupancyGrid& map) {
  clearance_.SetMap(map);
  costs_.SetMap(clearance_);
}

void PathPlanner::UpdateMap(const std::vector<MapWindow>& windows) {
  for (const cv::Rect& changed : clearance_.Update(windows)) {
    costs_.Update(clearance_, changed);
  }
  if (costs_.model().unknown == UnknownSpace::kFree) return;
  // What has become known changes its cost without any change of clearance.
  for (const MapWindow& window : windows) {
    costs_.Update(clearance_, window.cells);
  }
}

bool PathPlanner::has_map() const { return clearance_.geometry().size() != 0; }

std::optional<PlanResult> PathPlanner::Refuse(
    const PlanRequest& request) const {
  if (!has_map()) return Failure(Outcome::kNoMap, "there is no map yet");
  const GridGeometry& geometry = clearance_.geometry();
  if (!request.goal.IsFinite()) {
    return Failure(
        Outcome::kInvalidGoal,
        Sentence("the goal (%g, %g, %g) is not finite", request.goal.x,
                 request.goal.y, request.goal.theta));
  }
  if (!request.start.IsFinite() ||
      !geometry.Contains(geometry.ToCell(request.start.position()))) {
    return Failure(Outcome::kStartOutsideMap,
                   OutsideMap("start", request.start, geometry));
  }
  if (!geometry.Contains(geometry.ToCell(request.goal.position()))) {
    return Failure(Outcome::kGoalOutsideMap,
                   OutsideMap("goal", request.goal, geometry));
  }
  return std::nullopt;
}

PlanResult PathPlanner::Plan(const PlanRequest& request,
                             const std::atomic<bool>* cancelled) {
  if (std::optional<PlanResult> refusal = Refuse(request)) return *refusal;
  const StartClearing clearing(parameters_.footprint, request.start, clearance_,
                               costs_);
  std::optional<Goal> goal = NearestGoal(request, false);
  if (!goal) {
    return Failure(
        Outcome::kGoalBlocked,
        Sentence("the goal (%.2f, %.2f) is blocked: an obstacle is %.2f m from "
                 "it, where the robot needs %.2f to %.2f m by its heading, and "
                 "no pose within the tolerance of %.2f m is free",
                 request.goal.x, request.goal.y,
                 clearance_.At(request.goal.position()),
                 costs_.model().lethal_clearance,
                 parameters_.footprint.Grown(parameters_.safety_margin)
                     .CircumscribedRadius(),
                 request.tolerance));
  }
  const PassageCheck passages(PassageFootprint(parameters_), request.start,
                              clearance_);
  const Cell start = clearance_.geometry().ToCell(request.start.position());
  SearchResult found =
      search_.Run(costs_, passages, start, goal->cell, cancelled);
  if (found.status == SearchStatus::kExhausted) {
    // Every cell that can be reached is known now.
    goal = NearestGoal(request, true);
    if (!goal) return Unreachable(request, found);
    found = search_.Run(costs_, passages, start, goal->cell, cancelled);
  }
  if (found.status == SearchStatus::kCancelled) {
    return Failure(Outcome::kCancelled, "planning was cancelled");
  }
  return Answer(request, *goal, found, passages);
}

bool PathPlanner::IsGoalFree(const Pose2D& goal) const {
  const Cell cell = clearance_.geometry().ToCell(goal.position());
  return clearance_.geometry().Contains(cell) && !costs_.IsLethal(cell) &&
         clearance_.IsFree(parameters_.footprint, goal,
                           parameters_.safety_margin - kRounding);
}

std::optional<PathPlanner::Goal> PathPlanner::NearestGoal(
    const PlanRequest& request, bool must_be_reached) const {
  const GridGeometry& geometry = clearance_.geometry();
  const Cell centre = geometry.ToCell(request.goal.position());
  if (IsGoalFree(request.goal) &&
      (!must_be_reached || search_.IsReached(centre))) {
    return Goal{centre, request.goal, false};
  }
  std::optional<Goal> nearest;
  double distance = request.tolerance;
  const auto consider = [&](int x, int y) {
    const Cell cell{x, y};
    if (!geometry.Contains(cell)) return;
    const Pose2D pose(geometry.ToWorld(cell), request.goal.theta);
    const double moved = (pose.position() - request.goal.position()).norm();
    if (moved > distance || (nearest && moved == distance)) return;
    if (must_be_reached && !search_.IsReached(cell)) return;
    if (!IsGoalFree(pose)) return;
    nearest = Goal{cell, pose, true};
    distance = moved;
  };
  // Square rings about the goal's cell; the goal may lie anywhere in the cell,
  // so a ring may be nearer than its number by one.
  const int farthest = std::max(geometry.width, geometry.height);
  for (int ring = 0;
       ring <= farthest && (ring - 1) * geometry.resolution <= distance;
       ++ring) {
    for (int i = -ring; i <= ring; ++i) {
      consider(centre.x + i, centre.y - ring);
      if (ring > 0) consider(centre.x + i, centre.y + ring);
    }
    for (int i = 1 - ring; i < ring; ++i) {
      consider(centre.x - ring, centre.y + i);
      consider(centre.x + ring, centre.y + i);
    }
  }
  return nearest;
}

PlanResult PathPlanner::Unreachable(const PlanRequest& request,
                                    const SearchResult& found) const {
  const double cell_area = std::pow(clearance_.geometry().resolution, 2);
  PlanResult result = Failure(
      Outcome::kNoPath,
      Sentence(
          "no path from (%.2f, %.2f) to the goal (%.2f, %.2f): the robot "
          "can reach %.1f m^2 of the map, and no pose within %.2f m of the "
          "goal is among them",
          request.start.x, request.start.y, request.goal.x, request.goal.y,
          found.nodes_expanded * cell_area, request.tolerance));
  result.nodes_expanded = found.nodes_expanded;
  return result;
}

PlanResult PathPlanner::Answer(const PlanRequest& request, const Goal& goal,
                               const SearchResult& found,
                               const PassageCheck& passages) const {
  const GridGeometry& geometry = clearance_.geometry();
  const std::optional<KnownPath> known = FollowPath(
      request.previous, found.cells.front(), goal.cell, costs_, passages);
  PlanResult result;
  result.nodes_expanded = found.nodes_expanded;
  // Equal routes keep the old one too, or noise would make them alternate.
  result.kept =
      known && found.cost >= (1.0 - parameters_.keep_margin) * known->cost;
  const std::vector<Cell>& cells = result.kept ? known->cells : found.cells;
  result.cost = (result.kept ? known->cost : found.cost) *
                (geometry.resolution / kFreeStep);
  result.goal = goal.pose;
  for (const Cell& cell : cells) result.path.push_back(geometry.ToWorld(cell));
  if (result.path.size() == 1) result.path.push_back(result.path.front());
  result.path.front() = request.start.position();
  result.path.back() = goal.pose.position();

  result.message =
      Sentence("%s of weighted length %.2f m",
               result.kept ? "kept the path" : "found a path", result.cost);
  if (goal.is_moved) {
    result.message += Sentence(
        "; the goal (%.2f, %.2f) is not free or cannot be reached and was moved"
        " by %.2f m to (%.2f, %.2f)",
        request.goal.x, request.goal.y,
        (goal.pose.position() - request.goal.position()).norm(), goal.pose.x,
        goal.pose.y);
  }
  return result;
}

OccupancyGrid PathPlanner::InflatedMap() const {
  OccupancyGrid inflated(costs_.geometry(), 0);
  const int highest = costs_.LevelOf(costs_.model().lethal_clearance);
  const double span = std::max(1, highest - CostMap::kUnit);
  for (int y = 0; y < inflated.geometry().height; ++y) {
    for (int x = 0; x < inflated.geometry().width; ++x) {
      const Cell cell{x, y};
      std::int8_t& value = inflated[cell];
      const CostMap::Level level = costs_.LevelOf(clearance_.At(cell));
      if (clearance_.IsOccupied(cell)) {
        value = 100;
      } else if (level == CostMap::kLethal) {
        value = 99;
      } else if (costs_.model().unknown != UnknownSpace::kFree &&
                 clearance_.map()[cell] == kUnknown) {
        value = kUnknown;
      } else if (level > CostMap::kUnit) {
        value = static_cast<std::int8_t>(
            std::lround(1.0 + 97.0 * (level - CostMap::kUnit) / span));
      }
    }
  }
  return inflated;
}

}  // namespace vfh_astar
