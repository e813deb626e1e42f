#include "benchmark/world_planner_benchmark.h"

#include <chrono>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <random>
#include <vector>

#include "benchmark/reference_planner.h"
#include "vfh_astar/grid/map_file.h"
#include "vfh_astar/planning/path_planner.h"

namespace vfh_astar {
namespace {

constexpr double kLeastDistance = 10.0;  // m

OccupancyGrid Padded(const OccupancyGrid& map, int padding) {
  GridGeometry geometry = map.geometry();
  geometry.width += 2 * padding;
  geometry.height += 2 * padding;
  geometry.origin.array() -= padding * geometry.resolution;
  OccupancyGrid padded(geometry, 0);
  for (int y = 0; y < map.geometry().height; ++y) {
    for (int x = 0; x < map.geometry().width; ++x) {
      padded[{x + padding, y + padding}] = map[{x, y}];
    }
  }
  return padded;
}

/// Poses to plan between.
class RandomQueries {
 public:
  /// @param[in] solid the map as it is planned on.
  RandomQueries(const WorldPlannerOptions& options, const OccupancyGrid& solid)
      : surveyed_(LoadMap(options.map)),
        clearance_(kParameters.occupied_threshold, 2.0),
        random_(options.seed) {
    clearance_.SetMap(solid);
    CostMap costs(CostModelFor(kParameters));
    costs.SetMap(clearance_);
    const GridGeometry& geometry = solid.geometry();
    cv::Mat passable(geometry.height, geometry.width, CV_8U);
    for (int y = 0; y < geometry.height; ++y) {
      for (int x = 0; x < geometry.width; ++x) {
        passable.at<std::uint8_t>(y, x) = !costs.IsLethal({x, y});
      }
    }
    // No corner is cut, so only neighbours along a side are connected.
    cv::connectedComponents(passable, regions_, 4, CV_32S);
  }

  /// @throws WorldPlannerError
  PlanRequest Next() {
    constexpr int kTries = 1000000;
    for (int i = 0; i < kTries; ++i) {
      const std::optional<Pose2D> start = Draw();
      const std::optional<Pose2D> goal = Draw();
      if (!start || !goal || RegionOf(*start) != RegionOf(*goal) ||
          (start->position() - goal->position()).norm() < kLeastDistance) {
        continue;
      }
      PlanRequest request;
      request.start = *start;
      request.goal = *goal;
      return request;
    }
    throw WorldPlannerError(
        "no two connected free poses 10 m or more apart in " +
        std::to_string(kTries) + " draws");
  }

 private:
  inline static const PathPlannerParameters kParameters;

  int Below(int limit) { return static_cast<int>(random_() % limit); }

  /// A pose over a cell's centre, if there is room at it.
  std::optional<Pose2D> Draw() {
    const GridGeometry& geometry = surveyed_.geometry();
    const int x = Below(geometry.width);
    const int y = Below(geometry.height);
    const double heading = Below(360) * kPi / 180.0;
    if (surveyed_[{x, y}] != 0) return std::nullopt;
    const Pose2D pose(geometry.ToWorld({x, y}), heading);
    const bool is_free =
        RegionOf(pose) != 0 && clearance_.IsFree(kParameters.footprint, pose,
                                                 kParameters.safety_margin);
    return is_free ? std::optional<Pose2D>(pose) : std::nullopt;
  }

  /// 0 where the inscribed circle has no room.
  int RegionOf(const Pose2D& pose) const {
    const Cell cell = surveyed_.geometry().ToCell(pose.position());
    return regions_.at<int>(cell.y, cell.x);
  }

  OccupancyGrid surveyed_;  ///< by the thresholds of the yaml.
  ClearanceMap clearance_;
  cv::Mat regions_;
  std::mt19937 random_;
};

}  // namespace

PlannerFigures RunWorldPlannerBenchmark(const WorldPlannerOptions& options) {
  using Clock = std::chrono::steady_clock;
  MapLoadOptions load;
  load.solid_below = options.solid_below;
  const OccupancyGrid solid = LoadMap(options.map, load);
  RandomQueries draw(options, solid);
  std::vector<PlanRequest> requests;
  while (requests.size() < static_cast<std::size_t>(options.queries)) {
    requests.push_back(draw.Next());
  }

  const PathPlannerParameters parameters;
  const OccupancyGrid map = Padded(solid, options.padding);
  PathPlanner planner(parameters);
  planner.SetMap(map);
  std::vector<PlanResult> results;
  std::vector<double> times_ms;
  for (const PlanRequest& request : requests) {
    const Clock::time_point begin = Clock::now();
    results.push_back(planner.Plan(request));
    const std::chrono::duration<double, std::milli> time = Clock::now() - begin;
    times_ms.push_back(time.count());
  }

  ReferencePlanner reference(parameters, map);
  PlannerTally tally;
  for (std::size_t i = 0; i < requests.size(); ++i) {
    const bool is_solved = results[i].outcome == Outcome::kSuccess;
    tally.Add(times_ms[i], results[i].nodes_expanded,
              is_solved ? std::optional<double>(results[i].cost -
                                                reference.Cost(requests[i]))
                        : std::nullopt);
  }
  return tally.Figures();
}

}  // namespace vfh_astar
