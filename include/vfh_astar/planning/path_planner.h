#ifndef VFH_ASTAR_PLANNING_PATH_PLANNER_H_
#define VFH_ASTAR_PLANNING_PATH_PLANNER_H_

#include <Eigen/Core>
#include <atomic>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "vfh_astar/footprint.h"
#include "vfh_astar/geometry.h"
#include "vfh_astar/grid/clearance.h"
#include "vfh_astar/outcome.h"
#include "vfh_astar/parameters.h"

namespace vfh_astar {

struct PathPlannerParameters {
  Footprint footprint;
  int occupied_threshold = 65;    ///< percent; from here on a cell is lethal.
  double safety_margin = 0.03;    ///< m kept between footprint and obstacle.
  double inflation_radius = 0.8;  ///< m from an obstacle to where cost ends.
  double inflation_weight = 3.0;  ///< cost of a cell beside the lethal zone, in
                                  ///< multiples of a free cell's.
  std::string unknown_space = "free";  ///< forbidden, free or priced.
  double unknown_price = 1.0;  ///< added cost of an unknown cell, in multiples
                               ///< of a free cell's; for `priced`.
  double keep_margin = 0.1;    ///< a new path replaces a still valid old one
                               ///< only when cheaper by this fraction.

  void Read(ParameterReader& reader);
};

struct PlanRequest {
  Pose2D start;            ///< map frame.
  Pose2D goal;             ///< map frame.
  double tolerance = 0.0;  ///< m by which the goal may be moved when it is not
                           ///< free; 0 is strict.
};

struct PlanResult {
  Outcome outcome = Outcome::kSuccess;
  std::string message;  ///< a sentence; says when the goal was moved.
  std::vector<Eigen::Vector2d> path;  ///< map frame, start to goal, cell by
                                      ///< cell; empty on failure.
  Pose2D goal;                        ///< where the path ends.
  double cost = 0.0;                  ///< m, weighted.
  std::int64_t nodes_expanded = 0;
};

/// A* over the inflated map.
class PathPlanner {
 public:
  explicit PathPlanner(const PathPlannerParameters& parameters);
  ~PathPlanner();

  void SetMap(const OccupancyGrid& map);

  /// See ClearanceMap::Update.
  void UpdateMap(const cv::Rect& window,
                 const std::vector<std::int8_t>& values);

  bool has_map() const;

  /// @param[in] cancelled polled; when it turns true Plan returns kCancelled
  ///   within 10 ms. May be null.
  /// @return kSuccess, or why not: kNoMap, kStartOutsideMap, kGoalOutsideMap,
  ///   kGoalBlocked, kNoPath, kCancelled.
  PlanResult Plan(const PlanRequest& request,
                  const std::atomic<bool>* cancelled = nullptr);

  /// The inflated map for display: 0 free, 1 to 98 by cost, 99 within the
  /// inscribed radius, 100 occupied, kUnknown where forbidden or priced and
  /// unknown.
  OccupancyGrid InflatedMap() const;

 private:
  class Search;

  PathPlannerParameters parameters_;
  ClearanceMap clearance_;
  std::unique_ptr<Search> search_;
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_PLANNING_PATH_PLANNER_H_
