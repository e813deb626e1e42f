#include "vfh_astar/tracking/scan_clusters.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vfh_astar {
namespace {

TEST(FitCircleTest, FindsTheCircleOfAnArc) {
  std::vector<Eigen::Vector2d> points;
  for (int i = 0; i < 20; ++i) {
    const double angle = 2.0 + 0.08 * i;
    points.emplace_back(30.0 + 0.5 * std::cos(angle),
                        -7.0 + 0.5 * std::sin(angle));
  }
  const std::optional<Circle> circle = FitCircle(points);
  ASSERT_TRUE(circle);
  EXPECT_NEAR(circle->centre.x(), 30.0, 1e-6);
  EXPECT_NEAR(circle->centre.y(), -7.0, 1e-6);
  EXPECT_NEAR(circle->radius, 0.5, 1e-6);
  EXPECT_NEAR(circle->error, 0.0, 1e-6);
}

TEST(FitCircleTest, FindsNoneInALineOrInFourPoints) {
  EXPECT_FALSE(FitCircle({{0, 0}, {1, 0.5}, {2, 1}, {3, 1.5}, {4, 2}}));
  EXPECT_FALSE(FitCircle({{1, 0}, {0, 1}, {-1, 0}, {0, -1}}));
}

TEST(FindClustersTest, SplitsWhereTheNextHitIsFarAndNotAtALostBeam) {
  LaserScan scan;
  scan.angle_min = 0.0;
  scan.angle_increment = 0.01;
  scan.range_min = 0.1;
  scan.range_max = 10.0;
  scan.ranges = {2.0F, 2.0F, NAN, 2.0F, 3.0F, 3.0F, 9.0F, 3.0F};
  const std::vector<ScanCluster> clusters =
      FindClusters(scan, Pose2D(1.0, 1.0, 0.0), 5.0);
  ASSERT_EQ(clusters.size(), 2u);
  EXPECT_EQ(clusters[0].beams, (std::vector<std::size_t>{0, 1, 3}));
  EXPECT_EQ(clusters[1].beams, (std::vector<std::size_t>{4, 5, 7}));
  EXPECT_NEAR(clusters[0].points[0].x(), 3.0, 1e-9);
  EXPECT_NEAR(clusters[0].points[0].y(), 1.0, 1e-9);
  // Three beam steps at 2 m.
  EXPECT_NEAR(clusters[0].extent, 0.06, 1e-4);
}

}  // namespace
}  // namespace vfh_astar
