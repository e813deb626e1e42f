#include "vfh_astar/grid/ray_traversal.h"

#include <gtest/gtest.h>

#include <random>
#include <set>
#include <utility>
#include <vector>

namespace vfh_astar {
namespace {

std::vector<Cell> Visited(const Eigen::Vector2d& from,
                          const Eigen::Vector2d& to) {
  std::vector<Cell> cells;
  EXPECT_TRUE(TraverseCells(from, to, [&cells](const Cell& cell) {
    cells.push_back(cell);
    return true;
  }));
  return cells;
}

TEST(RayTraversal, StaysInOneCell) {
  EXPECT_EQ(Visited({2.1, 3.2}, {2.8, 3.9}), (std::vector<Cell>{{2, 3}}));
  EXPECT_EQ(Visited({2.5, 3.5}, {2.5, 3.5}), (std::vector<Cell>{{2, 3}}));
}

TEST(RayTraversal, FollowsTheAxes) {
  EXPECT_EQ(Visited({0.5, 0.5}, {3.5, 0.5}),
            (std::vector<Cell>{{0, 0}, {1, 0}, {2, 0}, {3, 0}}));
  EXPECT_EQ(Visited({0.5, 0.5}, {-1.5, 0.5}),
            (std::vector<Cell>{{0, 0}, {-1, 0}, {-2, 0}}));
  EXPECT_EQ(Visited({0.5, 0.5}, {0.5, -1.5}),
            (std::vector<Cell>{{0, 0}, {0, -1}, {0, -2}}));
}

TEST(RayTraversal, CrossesRowsWhereTheLineDoes) {
  // From (0.5, 0.5) with slope 1/2 row 1 begins at x = 1.5.
  EXPECT_EQ(Visited({0.5, 0.5}, {3.5, 2.0 - 1e-9}),
            (std::vector<Cell>{{0, 0}, {1, 0}, {1, 1}, {2, 1}, {3, 1}}));
}

TEST(RayTraversal, StopsWhenTold) {
  int visits = 0;
  EXPECT_FALSE(TraverseCells({0.5, 0.5}, {9.5, 4.5},
                             [&visits](const Cell&) { return ++visits < 3; }));
  EXPECT_EQ(visits, 3);
}

/// Squared distance from a cell's square to a point.
double SquaredDistance(const Cell& cell, const Eigen::Vector2d& point) {
  const double dx = std::max({cell.x - point.x(), 0.0, point.x() - cell.x - 1});
  const double dy = std::max({cell.y - point.y(), 0.0, point.y() - cell.y - 1});
  return dx * dx + dy * dy;
}

TEST(RayTraversal, AgreesWithDenseSampling) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> coordinate(-20.0, 20.0);
  constexpr int kSamples = 4000;
  constexpr double kTouching = 1e-4;
  for (int line = 0; line < 300; ++line) {
    Eigen::Vector2d from(coordinate(random), coordinate(random));
    Eigen::Vector2d to(coordinate(random), coordinate(random));
    if (line % 3 ==
        0) {  // Lines between corners and centres are the hard ones.
      from = (from * 2.0).array().round() / 2.0;
      to = (to * 2.0).array().round() / 2.0;
    }
    const std::vector<Cell> cells = Visited(from, to);
    std::set<std::pair<int, int>> visited;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      visited.emplace(cells[i].x, cells[i].y);
      if (i > 0) {
        EXPECT_EQ(std::abs(cells[i].x - cells[i - 1].x) +
                      std::abs(cells[i].y - cells[i - 1].y),
                  1);
      }
    }
    EXPECT_EQ(visited.size(), cells.size());
    std::set<std::pair<int, int>> touched;
    for (int sample = 0; sample <= kSamples; ++sample) {
      const double part = static_cast<double>(sample) / kSamples;
      const Eigen::Vector2d point = from + part * (to - from);
      for (const Cell& cell : cells) {
        if (SquaredDistance(cell, point) < kTouching) {
          touched.emplace(cell.x, cell.y);
        }
      }
      const Eigen::Vector2d inside = point - point.array().floor().matrix();
      const bool near_edge =
          inside.minCoeff() < 1e-6 || inside.maxCoeff() > 1.0 - 1e-6;
      if (near_edge) continue;
      EXPECT_TRUE(visited.count({static_cast<int>(std::floor(point.x())),
                                 static_cast<int>(std::floor(point.y()))}))
          << from.transpose() << " to " << to.transpose();
    }
    EXPECT_EQ(touched, visited) << from.transpose() << " to " << to.transpose();
  }
}

}  // namespace
}  // namespace vfh_astar
