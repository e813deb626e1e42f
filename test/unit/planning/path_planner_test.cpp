#include "vfh_astar/planning/path_planner.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "planning/text_map.h"

namespace vfh_astar {
namespace {

constexpr double kResolution = 0.05;

/// Free, with walls around it.
OccupancyGrid Room(double width, double height) {
  GridGeometry geometry;
  geometry.resolution = kResolution;
  geometry.width = static_cast<int>(width / kResolution);
  geometry.height = static_cast<int>(height / kResolution);
  OccupancyGrid map(geometry, 0);
  for (int x = 0; x < geometry.width; ++x) {
    map[{x, 0}] = map[{x, geometry.height - 1}] = 100;
  }
  for (int y = 0; y < geometry.height; ++y) {
    map[{0, y}] = map[{geometry.width - 1, y}] = 100;
  }
  return map;
}

/// Occupies the cells whose centres lie in a box, m.
void Fill(double x_min, double y_min, double x_max, double y_max,
          OccupancyGrid& map, std::int8_t value = 100) {
  for (int y = 0; y < map.geometry().height; ++y) {
    for (int x = 0; x < map.geometry().width; ++x) {
      const Eigen::Vector2d at = map.geometry().ToWorld({x, y});
      if (x_min < at.x() && at.x() < x_max && y_min < at.y() &&
          at.y() < y_max) {
        map[{x, y}] = value;
      }
    }
  }
}

PathPlanner PlannerOn(const OccupancyGrid& map,
                      const PathPlannerParameters& parameters = {}) {
  PathPlanner planner(parameters);
  planner.SetMap(map);
  return planner;
}

PlanRequest FromTo(const Pose2D& start, const Pose2D& goal,
                   double tolerance = 0.0) {
  PlanRequest request;
  request.start = start;
  request.goal = goal;
  request.tolerance = tolerance;
  return request;
}

TEST(PathPlanner, GoesFromPoseToPose) {
  PathPlanner planner = PlannerOn(Room(6.0, 4.0));
  const PlanResult result =
      planner.Plan(FromTo({1.51, 2.01, 0.3}, {4.52, 2.02, 1.0}));
  ASSERT_EQ(result.outcome, Outcome::kSuccess) << result.message;
  EXPECT_EQ(result.path.front(), Eigen::Vector2d(1.51, 2.01));
  EXPECT_EQ(result.path.back(), Eigen::Vector2d(4.52, 2.02));
  EXPECT_EQ(result.goal.theta, 1.0);
  EXPECT_NEAR(result.cost, 3.0, 1e-9);
  EXPECT_FALSE(result.kept);
}

TEST(PathPlanner, SaysWhyItFails) {
  PathPlanner empty({});
  EXPECT_FALSE(empty.has_map());
  EXPECT_EQ(empty.Plan({}).outcome, Outcome::kNoMap);

  OccupancyGrid map = Room(6.0, 4.0);
  Fill(3.0, 0.0, 3.2, 4.0, map);
  PathPlanner planner = PlannerOn(map);
  const Pose2D start(1.5, 2.0, 0.0);
  const double kNan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(planner.Plan(FromTo(start, {kNan, 2.0, 0.0})).outcome,
            Outcome::kInvalidGoal);
  const PlanResult outside = planner.Plan(FromTo(start, {9.0, 2.0, 0.0}));
  EXPECT_EQ(outside.outcome, Outcome::kGoalOutsideMap);
  EXPECT_NE(outside.message.find("(9.00, 2.00)"), std::string::npos)
      << outside.message;
  EXPECT_NE(outside.message.find("6.00"), std::string::npos);
  EXPECT_EQ(planner.Plan(FromTo({-1.0, 2.0, 0.0}, start)).outcome,
            Outcome::kStartOutsideMap);
  EXPECT_EQ(planner.Plan(FromTo(start, {3.1, 2.0, 0.0})).outcome,
            Outcome::kGoalBlocked);
  const PlanResult beyond = planner.Plan(FromTo(start, {4.5, 2.0, 0.0}));
  EXPECT_EQ(beyond.outcome, Outcome::kNoPath);
  EXPECT_TRUE(beyond.path.empty());
  EXPECT_NE(beyond.message.find("(4.50, 2.00)"), std::string::npos);

  const std::atomic<bool> cancelled{true};
  EXPECT_EQ(PlannerOn(Room(40.0, 40.0))
                .Plan(FromTo({2.0, 2.0, 0.0}, {38.0, 30.0, 0.0}), &cancelled)
                .outcome,
            Outcome::kCancelled);
}

TEST(PathPlanner, KeepsToTheMiddleOfACorridor) {
  OccupancyGrid map = Room(8.0, 5.0);
  Fill(3.0, 0.0, 5.0, 2.0, map);
  Fill(3.0, 3.2, 5.0, 5.0, map);
  const PlanResult result =
      PlannerOn(map).Plan(FromTo({1.0, 1.0, 0.0}, {7.0, 1.0, 0.0}));
  ASSERT_EQ(result.outcome, Outcome::kSuccess);
  for (const Eigen::Vector2d& point : result.path) {
    if (3.3 < point.x() && point.x() < 4.7) {
      EXPECT_NEAR(point.y(), 2.6, kResolution);
    }
  }
}

TEST(PathPlanner, PassesWhereverTheRobotFits) {
  // The robot is 0.416 m wide. Nine free cells of 0.05 m are enough with 0.03 m
  // to the walls' cell centres at each side, eight are not.
  const auto plan = [](int free_cells) {
    OccupancyGrid map = Room(8.0, 5.0);
    const double gap = free_cells * kResolution;
    Fill(3.0, 0.0, 5.0, 2.0, map);
    Fill(3.0, 2.0 + gap, 5.0, 5.0, map);
    PathPlannerParameters parameters;
    parameters.safety_margin = 0.03;
    return PlannerOn(map, parameters)
        .Plan(FromTo({1.0, 2.2, 0.0}, {7.0, 2.2, 0.0}))
        .outcome;
  };
  EXPECT_EQ(plan(9), Outcome::kSuccess);
  EXPECT_EQ(plan(8), Outcome::kNoPath);
}

TEST(PathPlanner, MovesABlockedGoalWithinTheTolerance) {
  OccupancyGrid map = Room(6.0, 4.0);
  PathPlanner planner = PlannerOn(map);
  const Pose2D start(1.5, 2.0, 0.0);
  const Pose2D at_wall(5.9, 2.0, 0.0);
  EXPECT_EQ(planner.Plan(FromTo(start, at_wall)).outcome,
            Outcome::kGoalBlocked);
  const PlanResult moved = planner.Plan(FromTo(start, at_wall, 0.5));
  ASSERT_EQ(moved.outcome, Outcome::kSuccess) << moved.message;
  // The wall's cell centre is at 5.975; the rectangle's front with its margin
  // (0.229 + 0.05) must stay short of it.
  EXPECT_NEAR(moved.goal.x, 5.675, 1e-9);
  EXPECT_NE(moved.message.find("moved by 0.2"), std::string::npos)
      << moved.message;
  EXPECT_EQ(moved.path.back(), moved.goal.position());
}

TEST(PathPlanner, MovesAGoalToTheNearestPoseOfAll) {
  std::mt19937 random(21);
  int moved_goals = 0;
  for (int round = 0; round < 40; ++round) {
    OccupancyGrid map = RandomMap(80, 60, kResolution, 0.02, random);
    Fill(0.0, 0.0, 1.5, 1.5, map, 0);
    PathPlannerParameters parameters;
    parameters.footprint = {0.1, 0.1, 0.08};
    parameters.safety_margin = 0.03;
    PathPlanner planner = PlannerOn(map, parameters);
    const Pose2D start(0.7, 0.7, 0.0);
    const Pose2D goal(0.2 + 0.0037 * (random() % 1000),
                      0.2 + 0.0026 * (random() % 1000), 0.4);
    const PlanResult result = planner.Plan(FromTo(start, goal, 0.8));
    if (result.outcome != Outcome::kSuccess) continue;
    const double moved = (result.goal.position() - goal.position()).norm();
    EXPECT_LE(moved, 0.8);
    if (moved == 0.0) continue;
    ++moved_goals;
    // No cell that is nearer could have been the goal.
    for (int y = 0; y < 60; ++y) {
      for (int x = 0; x < 80; ++x) {
        const Pose2D other(map.geometry().ToWorld({x, y}), goal.theta);
        if ((other.position() - goal.position()).norm() > moved - 1e-9) {
          continue;
        }
        EXPECT_NE(planner.Plan(FromTo(start, other)).outcome,
                  Outcome::kSuccess);
      }
    }
  }
  EXPECT_GT(moved_goals, 5);
}

TEST(PathPlanner, MovesAGoalThatIsCutOff) {
  OccupancyGrid map = Room(6.0, 4.0);
  Fill(3.0, 0.0, 3.1, 4.0, map);
  PathPlanner planner = PlannerOn(map);
  const PlanResult result =
      planner.Plan(FromTo({1.5, 2.0, 0.0}, {3.5, 2.0, 0.0}, 1.0));
  ASSERT_EQ(result.outcome, Outcome::kSuccess) << result.message;
  EXPECT_LT(result.goal.x, 3.0);
}

TEST(PathPlanner, StartsBesideAnObstacle) {
  OccupancyGrid map = Room(6.0, 4.0);
  PathPlanner planner = PlannerOn(map);
  // The side of the robot is 0.02 m off the wall's cell.
  const Pose2D start(3.0, 0.05 + 0.02 + 0.208, 0.0);
  const PlanResult result = planner.Plan(FromTo(start, {4.5, 2.0, 0.0}));
  EXPECT_EQ(result.outcome, Outcome::kSuccess) << result.message;
}

TEST(PathPlanner, ClearsTheStartsFootprintAndNothingElse) {
  OccupancyGrid map = Room(6.0, 4.0);
  Fill(1.45, 1.95, 1.55, 2.05, map);  // What the laser sees of the robot.
  PathPlanner planner = PlannerOn(map);
  const Pose2D start(1.5, 2.0, 0.0);
  const PlanResult inside = planner.Plan(FromTo(start, {4.5, 2.0, 0.0}));
  ASSERT_EQ(inside.outcome, Outcome::kSuccess) << inside.message;
  EXPECT_NEAR(inside.cost, 3.0, 0.01);
  // Seen from elsewhere the cells are still there.
  EXPECT_EQ(planner.Plan(FromTo({4.5, 2.0, 0.0}, start)).outcome,
            Outcome::kGoalBlocked);
  EXPECT_EQ(planner.InflatedMap().cells(),
            PlannerOn(map).InflatedMap().cells());

  // A wall through the robot's place lets it out on neither side but its own.
  OccupancyGrid walled = Room(6.0, 4.0);
  Fill(3.0, 0.0, 3.05, 4.0, walled);
  EXPECT_EQ(
      PlannerOn(walled).Plan(FromTo({2.85, 2.0, 0.0}, {4.5, 2.0, 0.0})).outcome,
      Outcome::kNoPath);
}

TEST(PathPlanner, UnknownSpaceIsForbiddenFreeOrPriced) {
  OccupancyGrid map = Room(6.0, 6.0);
  Fill(2.0, 0.0, 4.0, 4.0, map, kUnknown);
  const auto cost = [&map](const std::string& unknown) {
    PathPlannerParameters parameters;
    parameters.unknown_space = unknown;
    parameters.unknown_price = 5.0;
    const PlanResult result =
        PlannerOn(map, parameters)
            .Plan(FromTo({1.0, 3.0, 0.0}, {5.0, 3.0, 0.0}));
    EXPECT_EQ(result.outcome, Outcome::kSuccess);
    return result.cost;
  };
  EXPECT_NEAR(cost("free"), 4.0, 0.01);
  // Round the unknown it is two diagonals longer.
  EXPECT_NEAR(cost("forbidden"), 4.0 + 2.0 * 1.0 * (std::sqrt(2.0) - 1.0), 0.1);
  EXPECT_NEAR(cost("priced"), cost("forbidden"), 0.1);
}

/// Two ways round a block that reaches from `low` to y = 5.8 m; the robot and
/// its goal are at y = 4.
OccupancyGrid TwoWays(double low) {
  OccupancyGrid map = Room(10.0, 8.0);
  Fill(4.0, low, 6.0, 5.8, map);
  return map;
}

TEST(PathPlanner, KeepsToTheOldPathUnlessTheNewOneIsMuchBetter) {
  const Pose2D start(1.0, 4.0, 0.0);
  const Pose2D goal(9.0, 4.0, 0.0);
  PathPlanner planner = PlannerOn(TwoWays(2.0));
  PlanRequest request = FromTo(start, goal);
  const PlanResult first = planner.Plan(request);
  ASSERT_EQ(first.outcome, Outcome::kSuccess);
  const auto is_above = [](const PlanResult& result) {
    return result.path[result.path.size() / 2].y() > 4.0;
  };
  EXPECT_TRUE(is_above(first));

  // Now the lower way is a little shorter.
  planner.SetMap(TwoWays(2.4));
  EXPECT_FALSE(is_above(planner.Plan(request)));
  request.previous = first.path;
  const PlanResult kept = planner.Plan(request);
  EXPECT_TRUE(kept.kept);
  EXPECT_TRUE(is_above(kept));
  EXPECT_NE(kept.message.find("kept"), std::string::npos);

  // From farther on along the path, and beside it.
  request.start = Pose2D(first.path[20] + Eigen::Vector2d(0.1, -0.05), 0.0);
  const PlanResult later = planner.Plan(request);
  EXPECT_TRUE(later.kept);
  EXPECT_LT(later.cost, kept.cost - 0.8);
  EXPECT_EQ(later.path.front(), request.start.position());

  // Much shorter: not kept.
  request.start = start;
  planner.SetMap(TwoWays(4.5));
  EXPECT_FALSE(planner.Plan(request).kept);

  // No longer valid: not kept.
  OccupancyGrid blocked = TwoWays(2.4);
  Fill(5.0, 6.0, 5.1, 8.0, blocked);
  planner.SetMap(blocked);
  const PlanResult detour = planner.Plan(request);
  EXPECT_EQ(detour.outcome, Outcome::kSuccess);
  EXPECT_FALSE(detour.kept);
}

TEST(PathPlanner, EditsBetweenPlansChangeNothingButTheMap) {
  std::mt19937 random(9);
  const auto below = [&random](int limit) {
    return static_cast<int>(random() % limit);
  };
  for (const char* unknown : {"free", "forbidden", "priced"}) {
    PathPlannerParameters parameters;
    parameters.unknown_space = unknown;
    OccupancyGrid map = Room(8.0, 7.0);
    PathPlanner edited = PlannerOn(map, parameters);
    int found = 0;
    for (int round = 0; round < 60; ++round) {
      cv::Rect window(below(140), below(120), 1 + below(20), 1 + below(20));
      std::vector<std::int8_t> values;
      const std::int8_t value = below(3) == 0 ? 0 : below(3) == 0 ? -1 : 90;
      for (int y = window.y; y < window.br().y; ++y) {
        for (int x = window.x; x < window.br().x; ++x) {
          if (below(8) == 0) map[{x, y}] = value;
          values.push_back(map[{x, y}]);
        }
      }
      edited.UpdateMap({{window, values}});
      PathPlanner fresh = PlannerOn(map, parameters);
      ASSERT_EQ(edited.InflatedMap().cells(), fresh.InflatedMap().cells());
      const PlanRequest request =
          FromTo({0.3 + 0.05 * below(148), 0.3 + 0.05 * below(128), 0.1},
                 {0.3 + 0.05 * below(148), 0.3 + 0.05 * below(128), 1.0}, 0.6);
      const PlanResult a = edited.Plan(request);
      const PlanResult b = fresh.Plan(request);
      ASSERT_EQ(a.outcome, b.outcome) << a.message << " / " << b.message;
      ASSERT_EQ(a.cost, b.cost);
      ASSERT_EQ(a.path, b.path);
      found += a.outcome == Outcome::kSuccess ? 1 : 0;
    }
    EXPECT_GT(found, 20);
  }
}

}  // namespace
}  // namespace vfh_astar
