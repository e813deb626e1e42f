#ifndef VFH_ASTAR_PLANNING_PATH_PLANNER_H_
#define VFH_ASTAR_PLANNING_PATH_PLANNER_H_

#include <Eigen/Core>
#include <atomic>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "vfh_astar/footprint.h"
#include "vfh_astar/geometry.h"
#include "vfh_astar/grid/clearance.h"
#include "vfh_astar/grid/map_window.h"
#include "vfh_astar/outcome.h"
#include "vfh_astar/parameters.h"
#include "vfh_astar/planning/cost_map.h"
#include "vfh_astar/planning/cost_search.h"
#include "vfh_astar/planning/passage_check.h"

namespace vfh_astar {

struct PathPlannerParameters {
  Footprint footprint;
  int occupied_threshold = 65;    ///< percent; from here on a cell is lethal.
  double safety_margin = 0.05;    ///< m between the footprint and the centres
                                  ///< of occupied cells; half a cell or more,
                                  ///< or what lies in a cell may be touched.
  double inflation_radius = 0.8;  ///< m from an obstacle's cell to where its
                                  ///< cost ends.
  double inflation_weight = 3.0;  ///< cost of a cell beside the lethal zone, in
                                  ///< multiples of a free cell's.
  std::string unknown_space = "free";  ///< forbidden, free or priced.
  double unknown_price = 1.0;  ///< added cost of an unknown cell, in multiples
                               ///< of a free cell's; for `priced`.
  double keep_margin = 0.1;    ///< a new path replaces a still valid old one
                               ///< only when cheaper by this fraction.

  void Read(ParameterReader& reader);
};

/// What a metre of path costs by these parameters.
CostModel CostModelFor(const PathPlannerParameters& parameters);

/// How far clearance is worked out for them, m.
double ClearanceReach(const PathPlannerParameters& parameters);

/// The rectangle that must fit along a path: the footprint with its margin.
Footprint PassageFootprint(const PathPlannerParameters& parameters);

struct PlanRequest {
  Pose2D start;            ///< map frame.
  Pose2D goal;             ///< map frame.
  double tolerance = 0.0;  ///< m by which the goal may be moved when it is not
                           ///< free or cannot be reached; 0 is strict.
  std::vector<Eigen::Vector2d> previous;  ///< the path being followed, cell by
                                          ///< cell as planned; may be empty.
};

struct PlanResult {
  Outcome outcome = Outcome::kSuccess;
  std::string message;  ///< a sentence; says when the goal was moved.
  std::vector<Eigen::Vector2d> path;  ///< map frame, start to goal, cell by
                                      ///< cell; empty on failure.
  Pose2D goal;                        ///< where the path ends.
  bool kept = false;                  ///< the path is the previous one, from
                                      ///< where the robot is on it.
  double cost = 0.0;                  ///< m, weighted.
  std::int64_t nodes_expanded = 0;    ///< see SearchResult.
};

/// A* over the inflated map. One thread at a time; a caller that plans beside
/// another one has a planner of its own.
class PathPlanner {
 public:
  explicit PathPlanner(const PathPlannerParameters& parameters);

  void SetMap(const OccupancyGrid& map);

  /// See ClearanceMap::Update.
  void UpdateMap(const std::vector<MapWindow>& windows);

  bool has_map() const;

  /// @param[in] cancelled polled; when it turns true Plan returns kCancelled
  ///   within 10 ms. May be null.
  /// @return kSuccess, or why not: kNoMap, kInvalidGoal (not finite),
  ///   kStartOutsideMap, kGoalOutsideMap, kGoalBlocked, kNoPath, kCancelled.
  ///   The robot's own footprint at the start never blocks a plan.
  PlanResult Plan(const PlanRequest& request,
                  const std::atomic<bool>* cancelled = nullptr);

  /// The inflated map for display: 0 free, 1 to 98 by cost, 99 within the
  /// inscribed radius, 100 occupied, kUnknown where forbidden or priced and
  /// unknown.
  OccupancyGrid InflatedMap() const;

 private:
  struct Goal {
    Cell cell;
    Pose2D pose;
    bool is_moved = false;
  };

  bool IsGoalFree(const Pose2D& goal) const;
  std::optional<PlanResult> Refuse(const PlanRequest& request) const;
  /// The goal when it is free, else the nearest free pose within the tolerance;
  /// when asked for, among those that the last search has reached.
  std::optional<Goal> NearestGoal(const PlanRequest& request,
                                  bool must_be_reached) const;
  PlanResult Unreachable(const PlanRequest& request,
                         const SearchResult& found) const;
  PlanResult Answer(const PlanRequest& request, const Goal& goal,
                    const SearchResult& found,
                    const PassageCheck& passages) const;

  PathPlannerParameters parameters_;
  ClearanceMap clearance_;
  CostMap costs_;
  CostSearch search_;
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_PLANNING_PATH_PLANNER_H_
