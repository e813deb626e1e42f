#include "vfh_astar/mapping/scan_inserter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "vfh_astar/grid/ray_traversal.h"

namespace vfh_astar {
namespace {

constexpr float kInf = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

GridGeometry Geometry() {
  GridGeometry geometry;
  geometry.resolution = 0.1;
  geometry.origin = Eigen::Vector2d(-5.0, -5.0);
  geometry.width = 100;
  geometry.height = 100;
  return geometry;
}

/// One beam along x.
LaserScan Beam(float range) {
  LaserScan scan;
  scan.angle_increment = 0.01;
  scan.range_min = 0.1;
  scan.range_max = 30.0;
  scan.ranges = {range};
  return scan;
}

// In the middle of cell (50, 50).
const Pose2D kOrigin(0.05, 0.05, 0.0);

ScanInserterParameters ShortSighted() {
  ScanInserterParameters parameters;
  parameters.max_urange = 2.0;
  parameters.max_range = 4.0;
  return parameters;
}

TEST(ScanInserter, HitEndsABeamThatClearsItsPath) {
  LogOddsGrid grid(Geometry());
  ScanInserter inserter({});
  const cv::Rect changed = inserter.Insert(Beam(1.0f), kOrigin, grid);
  EXPECT_EQ(changed, cv::Rect(50, 50, 11, 1));
  for (int x = 50; x < 60; ++x) {
    EXPECT_NEAR(grid.Probability({x, 50}), 0.4, 0.01);
  }
  EXPECT_NEAR(grid.Probability({60, 50}), 0.8, 0.01);
  EXPECT_EQ(grid.Probability({61, 50}), -1.0);
  EXPECT_EQ(grid.Probability({49, 50}), -1.0);
  EXPECT_EQ(grid.Probability({55, 51}), -1.0);
}

TEST(ScanInserter, TellsMaxUrangeFromMaxRange) {
  const auto insert = [](float range) {
    LogOddsGrid grid(Geometry());
    ScanInserter(ShortSighted()).Insert(Beam(range), kOrigin, grid);
    return grid;
  };
  // Beyond max_urange: free so far, and no hit.
  for (const float range : {3.0f, kInf}) {
    const LogOddsGrid grid = insert(range);
    EXPECT_LT(grid.Probability({70, 50}), 0.5);
    EXPECT_GT(grid.Probability({70, 50}), 0.0);
    EXPECT_EQ(grid.Probability({71, 50}), -1.0);
    EXPECT_EQ(grid.Probability({80, 50}), -1.0);
  }
  // No measurements.
  for (const float range : {5.0f, 0.05f, kNan, -kInf, -1.0f}) {
    EXPECT_EQ(insert(range).FindTile(0, 0), nullptr) << range;
  }
}

TEST(ScanInserter, FreeBeamEndsAtTheSensorsOwnRange) {
  LaserScan scan = Beam(kInf);
  scan.range_max = 1.0;
  LogOddsGrid grid(Geometry());
  ScanInserter({}).Insert(scan, kOrigin, grid);
  EXPECT_GT(grid.Probability({60, 50}), 0.0);
  EXPECT_EQ(grid.Probability({61, 50}), -1.0);
}

TEST(ScanInserter, HitsWinOverMissesOfTheSameScan) {
  LaserScan scan = Beam(1.0f);
  scan.angle_increment = 1e-4;
  scan.ranges = {2.0f, 1.0f, 2.0f};
  LogOddsGrid grid(Geometry());
  ScanInserter({}).Insert(scan, kOrigin, grid);
  EXPECT_NEAR(grid.Probability({60, 50}), 0.8, 0.01);
  // Passed through by two beams, changed once.
  EXPECT_NEAR(grid.Probability({65, 50}), 0.4, 0.01);
}

TEST(ScanInserter, ClampsAndTurnsRoundWithinAFewScans) {
  LogOddsGrid grid(Geometry());
  ScanInserter inserter({});
  for (int i = 0; i < 100; ++i) inserter.Insert(Beam(1.0f), kOrigin, grid);
  EXPECT_NEAR(grid.Probability({60, 50}), 0.88, 0.01);
  EXPECT_NEAR(grid.Probability({55, 50}), 0.12, 0.01);
  EXPECT_TRUE(inserter.Insert(Beam(1.0f), kOrigin, grid).empty());
  // What has come shows with the second scan,
  inserter.Insert(Beam(0.5f), kOrigin, grid);
  inserter.Insert(Beam(0.5f), kOrigin, grid);
  EXPECT_GE(grid.Probability({55, 50}), 0.65);
  // and what has gone is cleared within five.
  for (int i = 0; i < 5; ++i) inserter.Insert(Beam(2.0f), kOrigin, grid);
  EXPECT_LE(grid.Probability({60, 50}), 0.5);
}

TEST(ScanInserter, SurerValuesOfAGivenMapYieldJustAsFast) {
  LogOddsGrid grid(Geometry());
  grid.Set({55, 50}, FromOccupancy(100));
  grid.Set({60, 50}, FromOccupancy(0));
  ScanInserter inserter({});
  inserter.Insert(Beam(1.0f), kOrigin, grid);
  inserter.Insert(Beam(1.0f), kOrigin, grid);
  EXPECT_GE(grid.Probability({60, 50}), 0.65);
  for (int i = 0; i < 3; ++i) inserter.Insert(Beam(1.0f), kOrigin, grid);
  EXPECT_LE(grid.Probability({55, 50}), 0.5);
}

TEST(ScanInserter, GrowsTheGrid) {
  LogOddsGrid grid(Geometry());
  ScanInserter inserter({});
  inserter.Insert(Beam(1.0f), kOrigin, grid);
  const cv::Rect changed =
      inserter.Insert(Beam(10.0f), {0.05, 0.05, kPi}, grid);
  // 256 columns were added to the left.
  EXPECT_EQ(grid.geometry().width, 100 + 256);
  EXPECT_EQ(changed, cv::Rect(50 + 256 - 100, 50, 101, 1));
  EXPECT_NEAR(grid.Probability({60 + 256, 50}), 0.8, 0.01);
  EXPECT_NEAR(grid.Probability({50 + 256 - 100, 50}), 0.8, 0.01);
}

TEST(ScanInserter, LeavesOutWhatTheLargestGridCannotHold) {
  LogOddsGrid grid(Geometry());
  ScanInserter inserter({});
  EXPECT_TRUE(inserter.Insert(Beam(1.0f), {1e15, 0.0, 0.0}, grid).empty());
  EXPECT_LE(grid.geometry().width, LogOddsGrid::kMaxSide);
}

TEST(IsOneSurface, AStraightLineOfHits) {
  const Eigen::Vector2d a(0, 0), b(0.4, 0.1), c(0.9, 0.22), d(0.9, -2.0);
  EXPECT_TRUE(IsOneSurface(&a, b, c, nullptr));
  EXPECT_TRUE(IsOneSurface(nullptr, a, b, &c));
  EXPECT_FALSE(IsOneSurface(nullptr, a, b, nullptr))
      << "two points say nothing";
  EXPECT_FALSE(IsOneSurface(&d, b, c, nullptr)) << "around a corner";
  EXPECT_FALSE(IsOneSurface(&c, a, b, &a)) << "to and fro";
}

TEST(ScanInserter, AWallSeenAtAFlatAngleIsNotWornAway) {
  // A wall along y = 0.3 from a laser at y = 0.05, 8 m of it.
  LaserScan scan;
  scan.angle_min = -0.3;
  scan.angle_increment = 0.0044;
  scan.range_min = 0.1;
  scan.range_max = 30.0;
  for (int i = 0; i < 140; ++i) {
    const double angle = scan.Angle(i);
    const double range = angle > 0.031 ? 0.24 / std::sin(angle) : 40.0;
    scan.ranges.push_back(range < 8.0 ? static_cast<float>(range) : kInf);
  }
  GridGeometry geometry;
  geometry.origin = {-5.0, -10.0};
  geometry.width = 600;
  geometry.height = 400;
  LogOddsGrid grid(geometry);
  const int row = geometry.ToCell({0.0, 0.275}).y;
  const int from = geometry.ToCell({1.0, 0.0}).x;
  const int to = geometry.ToCell({5.0, 0.0}).x;
  // What was seen from close by.
  for (int x = from; x <= to; ++x) grid.Set({x, row}, FromOccupancy(88));
  ScanInserter inserter({});
  for (int i = 0; i < 30; ++i) inserter.Insert(scan, {0.05, 0.05, 0.0}, grid);
  ASSERT_EQ(grid.geometry(), geometry);
  for (int x = from; x <= to; ++x) {
    EXPECT_GT(grid.Probability({x, row}), 0.65) << x;
  }
}

/// Beam by beam and cell by cell, straight from the description.
void InsertSlowly(const ScanInserterParameters& parameters,
                  const LaserScan& scan, const Pose2D& pose,
                  LogOddsGrid& grid) {
  std::set<std::pair<int, int>> hits;
  std::set<std::pair<int, int>> misses;
  std::vector<std::optional<Eigen::Vector2d>> ends(scan.ranges.size());
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    const float range = scan.ranges[i];
    const bool is_free = range > scan.range_max;
    const bool is_hit = range >= scan.range_min && !is_free;
    if (!is_free && !(is_hit && range <= parameters.max_range)) continue;
    const double length = std::min<double>(is_free ? scan.range_max : range,
                                           parameters.max_urange);
    const double angle = pose.theta + scan.Angle(i);
    const Eigen::Vector2d end =
        pose.position() +
        length * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    TraverseCells(ToCellUnits(grid.geometry(), pose.position()),
                  ToCellUnits(grid.geometry(), end), [&](const Cell& cell) {
                    misses.emplace(cell.x, cell.y);
                    return true;
                  });
    if (is_hit && range <= parameters.max_urange) {
      const Cell cell = grid.geometry().ToCell(end);
      hits.emplace(cell.x, cell.y);
      ends[i] = end;
    }
  }
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    if (!ends[i] || !ends[i + 1]) continue;
    const double gap = (*ends[i + 1] - *ends[i]).norm();
    if (gap < grid.geometry().resolution || gap > 2.0) continue;
    const auto* before = i > 0 && ends[i - 1] ? &*ends[i - 1] : nullptr;
    const auto* after =
        i + 2 < ends.size() && ends[i + 2] ? &*ends[i + 2] : nullptr;
    if (!IsOneSurface(before, *ends[i], *ends[i + 1], after)) continue;
    TraverseCells(ToCellUnits(grid.geometry(), *ends[i]),
                  ToCellUnits(grid.geometry(), *ends[i + 1]),
                  [&](const Cell& cell) {
                    misses.erase({cell.x, cell.y});
                    return true;
                  });
  }
  const auto change = [&grid, &parameters](const Cell& cell, double by) {
    const LogOdds value = grid[cell];
    const int known = value == kUnexplored ? kEvenOdds : value;
    const int steps = ToLogOdds(by) - kEvenOdds;
    grid.Set(cell, static_cast<LogOdds>(std::clamp<int>(
                       known + steps, ToLogOdds(parameters.min_probability),
                       ToLogOdds(parameters.max_probability))));
  };
  for (const auto& [x, y] : hits) {
    change({x, y}, parameters.hit_probability);
    misses.erase({x, y});
  }
  for (const auto& [x, y] : misses) {
    change({x, y}, parameters.miss_probability);
  }
}

/// Scans from random poses, up to `spread` m off, into a grid that need not
/// grow.
void ExpectAgreement(double spread, int beams, double increment,
                     double resolution,
                     const std::function<float(int)>& range) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> offset(-spread, spread);
  std::uniform_real_distribution<double> angle(-6.0, 6.0);
  ScanInserterParameters parameters;
  parameters.max_urange = 5.5;
  parameters.max_range = 7.0;
  ScanInserter inserter(parameters);
  GridGeometry geometry;
  geometry.resolution = resolution;
  geometry.origin = Eigen::Vector2d(-13.0, -12.3);
  geometry.width = static_cast<int>(25.0 / resolution);
  geometry.height = static_cast<int>(24.3 / resolution);
  LogOddsGrid grid(geometry);
  LogOddsGrid reference(geometry);
  for (int round = 0; round < 40; ++round) {
    LaserScan scan;
    scan.angle_min = -2.3;
    scan.angle_increment = increment;
    scan.range_min = 0.3;
    scan.range_max = 8.0;
    for (int i = 0; i < beams; ++i) scan.ranges.push_back(range(i));
    const Pose2D pose(offset(random), offset(random), angle(random));
    const LogOddsGrid before = grid;
    const cv::Rect changed = inserter.Insert(scan, pose, grid);
    InsertSlowly(parameters, scan, pose, reference);
    ASSERT_EQ(grid.geometry(), geometry);
    for (int y = 0; y < geometry.height; ++y) {
      for (int x = 0; x < geometry.width; ++x) {
        const Cell cell{x, y};
        ASSERT_EQ(grid[cell], reference[cell]) << x << ", " << y;
        if (!changed.contains(cv::Point(x, y))) {
          ASSERT_EQ(grid[cell], before[cell]);
        }
      }
    }
  }
}

TEST(ScanInserter, AgreesWithTheSlowReferenceOnWildRanges) {
  std::mt19937 random(12);
  std::uniform_real_distribution<float> length(0.0f, 9.0f);
  ExpectAgreement(6.0, 240, 0.02, 0.1, [&](int) {
    const int kind = static_cast<int>(random() % 12);
    return kind == 0   ? kInf
           : kind == 1 ? kNan
           : kind == 2 ? -kInf
                       : length(random);
  });
}

TEST(ScanInserter, AgreesWithTheSlowReferenceInARoom) {
  // Beams closer than cells far out, as a laser in a room has them.
  std::mt19937 random(13);
  std::normal_distribution<float> noise(0.0f, 0.01f);
  float wall = 3.0f;
  ExpectAgreement(6.0, 1080, -0.00436, 0.05, [&](int beam) {
    if (random() % 25 == 0) wall = 0.5f + 0.01f * (random() % 600);
    return beam % 97 == 0 ? kNan : wall + 0.002f * (beam % 40) + noise(random);
  });
}

TEST(ScanInserter, AgreesWithTheSlowReferenceWhereAllIsCleared) {
  // From about one place, so that cells all around get as low as they can,
  // until something stands among them and goes again.
  std::mt19937 random(14);
  int scan = -1;
  ExpectAgreement(0.6, 1440, 0.00436, 0.05, [&](int beam) {
    if (beam == 0) ++scan;
    const bool is_there = scan > 15 && scan % 8 < 4 && beam % 180 < 30;
    return is_there ? 1.0f + 0.05f * (scan % 5) : random() % 2 ? 5.0f : kInf;
  });
}

}  // namespace
}  // namespace vfh_astar
