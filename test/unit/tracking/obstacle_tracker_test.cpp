#include "vfh_astar/tracking/obstacle_tracker.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace vfh_astar {
namespace {

struct Disc {
  Eigen::Vector2d centre;
  double radius;
};

struct Wall {
  Eigen::Vector2d from;
  Eigen::Vector2d to;
};

/// m along a ray to a disc; +inf when it misses.
double Reach(const Eigen::Vector2d& start, const Eigen::Vector2d& direction,
             const Disc& disc) {
  const Eigen::Vector2d way = disc.centre - start;
  const double along = way.dot(direction);
  const double square =
      disc.radius * disc.radius - (way.squaredNorm() - along * along);
  if (square < 0.0 || along < 0.0) {
    return std::numeric_limits<double>::infinity();
  }
  return along - std::sqrt(square);
}

double Reach(const Eigen::Vector2d& start, const Eigen::Vector2d& direction,
             const Wall& wall) {
  const Eigen::Vector2d side = wall.to - wall.from;
  const Eigen::Vector2d offset = wall.from - start;
  const double cross = direction.x() * side.y() - direction.y() * side.x();
  const double ray = (offset.x() * side.y() - offset.y() * side.x()) / cross;
  const double place =
      (offset.x() * direction.y() - offset.y() * direction.x()) / cross;
  const bool hits = cross != 0.0 && ray > 0.0 && place >= 0.0 && place <= 1.0;
  return hits ? ray : std::numeric_limits<double>::infinity();
}

/// A laser of 720 beams over 270 degrees at 50 Hz among discs and walls.
class TrackerTest : public testing::Test {
 protected:
  void Scan(const Pose2D& pose) { Scan(pose, pose); }

  /// @param[in] believed where odometry has the robot.
  void Scan(const Pose2D& pose, const Pose2D& believed) {
    LaserScan scan;
    scan.stamp = time_;
    scan.angle_min = -2.35619;
    scan.angle_increment = 2.0 * 2.35619 / 719.0;
    scan.range_min = 0.1;
    scan.range_max = 30.0;
    std::normal_distribution<double> noise(0.0, 0.01);
    for (int beam = 0; beam < 720; ++beam) {
      const Eigen::Vector2d direction =
          Pose2D(0.0, 0.0, pose.theta + scan.Angle(beam)).heading();
      double range = std::numeric_limits<double>::infinity();
      for (const Disc& disc : discs_) {
        range = std::min(range, Reach(pose.position(), direction, disc));
      }
      for (const Wall& wall : walls_) {
        range = std::min(range, Reach(pose.position(), direction, wall));
      }
      scan.ranges.push_back(static_cast<float>(range + noise(random_)));
    }
    tracker_.AddScan(scan, believed);
    time_ += 0.02;
  }

  std::mt19937 random_{4};
  double time_ = 0.0;
  std::vector<Disc> discs_;
  std::vector<Wall> walls_ = {{{-9.0, 9.0}, {9.0, 9.0}},
                              {{9.0, 9.0}, {9.0, -9.0}},
                              {{9.0, -9.0}, {-9.0, -9.0}},
                              {{-9.0, -9.0}, {-9.0, 9.0}}};
  ObstacleTracker tracker_{TrackerParameters()};
};

struct Crossing {
  Eigen::Vector2d start;
  Eigen::Vector2d velocity;
  double radius;
};

class CrossingTest : public TrackerTest,
                     public testing::WithParamInterface<Crossing> {};

TEST_P(CrossingTest, TellsPlaceAndVelocityFromAMovingRobot) {
  const Crossing& crossing = GetParam();
  discs_ = {{crossing.start, crossing.radius}};
  Pose2D pose;
  int found = 0;
  for (int step = 0; step < 75; ++step) {
    Scan(pose);
    pose = Integrate(pose, {0.8, 0.5}, 0.02);
    const Eigen::Vector2d centre = discs_[0].centre;
    discs_[0].centre += 0.02 * crossing.velocity;
    if (step < 40) continue;
    const std::vector<MovingObstacle> moving = tracker_.Moving();
    ASSERT_EQ(moving.size(), 1u) << "step " << step;
    ++found;
    EXPECT_LT((moving[0].velocity - crossing.velocity).norm(),
              0.15 * crossing.velocity.norm())
        << "step " << step;
    EXPECT_LT((moving[0].position - centre).norm(), 0.08) << "step " << step;
    EXPECT_NEAR(moving[0].radius, crossing.radius, 0.06);
  }
  EXPECT_EQ(found, 35);
}

INSTANTIATE_TEST_SUITE_P(
    Movers, CrossingTest,
    testing::Values(Crossing{{4.0, -1.5}, {0.0, 1.0}, 0.5},
                    Crossing{{5.0, 1.0}, {-1.2, 0.2}, 0.5},
                    Crossing{{3.0, 1.0}, {1.0, 0.3}, 0.3},
                    Crossing{{4.0, 2.5}, {-0.6, -0.9}, 0.25},
                    Crossing{{6.0, -3.0}, {-1.0, 1.5}, 0.5}));

TEST_F(TrackerTest, NothingMovesAmongPillarsAndWallsPassedByDriving) {
  std::uniform_real_distribution<double> place(-6.0, 6.0);
  while (discs_.size() < 60) {
    const Eigen::Vector2d centre(place(random_), place(random_));
    if (std::abs(centre.y()) > 0.6) discs_.push_back({centre, 0.075});
  }
  walls_.push_back({{-2.0, 0.9}, {2.0, 1.1}});
  walls_.push_back({{2.0, 1.1}, {2.0, 3.0}});
  Pose2D pose(-6.0, -0.25, 0.0);
  for (int step = 0; step < 500; ++step) {
    Scan(pose);
    const double turn = 1.2 * std::cos(0.05 * step);
    pose = Integrate(pose, {1.2, turn}, 0.02);
    ASSERT_TRUE(tracker_.Moving().empty()) << "step " << step;
  }
}

/// The part by which odometry takes turns for larger than they are.
class TurningTest : public TrackerTest,
                    public testing::WithParamInterface<double> {};

TEST_P(TurningTest, NothingMovesBesideARobotThatTurnsOnTheSpotInAHairpin) {
  walls_ = {{{-5.0, 1.0}, {4.0, 1.0}},   {{-5.0, -1.0}, {3.0, -1.0}},
            {{3.0, -1.0}, {3.0, -2.5}},  {{4.0, 1.0}, {6.0, -1.0}},
            {{6.0, -1.0}, {6.0, -5.0}},  {{3.0, -2.5}, {-5.0, -2.5}},
            {{6.0, -5.0}, {-5.0, -5.0}}, {{-5.0, 1.0}, {-5.0, -1.0}}};
  Pose2D pose(2.0, 0.0, 0.0);
  Pose2D believed = pose;
  for (int step = 0; step < 300; ++step) {
    Scan(pose, believed);
    pose = Integrate(pose, {0.0, 2.5}, 0.02);
    believed = Integrate(believed, {0.0, (1.0 + GetParam()) * 2.5}, 0.02);
    ASSERT_TRUE(tracker_.Moving().empty()) << "step " << step;
  }
}

INSTANTIATE_TEST_SUITE_P(GyroErrors, TurningTest,
                         testing::Values(0.0, 0.03, -0.03));

TEST_F(TrackerTest, SoonSeesWhatMovesPastARobotThatTurns) {
  discs_ = {{{4.0, 1.0}, 0.25}};
  Pose2D pose(0.0, 0.0, -1.0);
  for (int step = 0; step < 20; ++step) {
    Scan(pose);
    pose = Integrate(pose, {0.0, 2.5}, 0.02);
    discs_[0].centre += 0.02 * Eigen::Vector2d(-1.2, -0.6);
  }
  EXPECT_EQ(tracker_.Moving().size(), 1u);
}

TEST_F(TrackerTest, KeepsWhatGoesOutOfSightForAWhile) {
  discs_ = {{{4.0, -1.5}, 0.5}};
  for (int step = 0; step < 50; ++step) {
    Scan({});
    discs_[0].centre.y() += 0.02;
  }
  ASSERT_EQ(tracker_.Moving().size(), 1u);
  // A wall before it.
  walls_.push_back({{2.0, -1.2}, {2.0, 1.2}});
  for (int step = 0; step < 25; ++step) Scan({});
  ASSERT_EQ(tracker_.Moving().size(), 1u);
  EXPECT_NEAR(tracker_.Moving()[0].position.y(), -0.02, 0.12);
  for (int step = 0; step < 120; ++step) Scan({});
  EXPECT_TRUE(tracker_.Moving().empty());
}

TEST_F(TrackerTest, ForgetsAtOnceWhatIsSeenNotToBeThere) {
  discs_ = {{{4.0, -1.5}, 0.5}};
  for (int step = 0; step < 50; ++step) {
    Scan({});
    discs_[0].centre.y() += 0.02;
  }
  ASSERT_EQ(tracker_.Moving().size(), 1u);
  discs_[0].centre = {-4.0, 4.0};
  for (int step = 0; step < 12; ++step) Scan({});
  EXPECT_TRUE(tracker_.Moving().empty());
}

TEST_F(TrackerTest, TakesTheHitsOnWhatMovesOutOfAScan) {
  discs_ = {{{4.0, -1.5}, 0.5}, {{3.0, 3.0}, 0.5}};
  for (int step = 0; step < 50; ++step) {
    Scan({});
    discs_[0].centre.y() += 0.02;
  }
  LaserScan scan;
  scan.ranges.assign(720, 5.0F);
  const LaserScan without = tracker_.Without(scan);
  const LaserScan only = tracker_.Only(scan);
  int left_out = 0;
  for (int beam = 0; beam < 720; ++beam) {
    EXPECT_NE(std::isnan(without.ranges[beam]), std::isnan(only.ranges[beam]));
    left_out += std::isnan(without.ranges[beam]) ? 1 : 0;
  }
  // Half a metre of radius at 4.03 m is 2 asin(0.5 / 4.03) = 14.3 degrees, at
  // 0.3755 degrees a beam 38.
  EXPECT_NEAR(left_out, 38, 2);
}

TEST_F(TrackerTest, BeginsAnewWhenTimeRunsBackwards) {
  discs_ = {{{4.0, -1.5}, 0.5}};
  for (int step = 0; step < 50; ++step) {
    Scan({});
    discs_[0].centre.y() += 0.02;
  }
  ASSERT_EQ(tracker_.Moving().size(), 1u);
  time_ = 0.0;
  Scan({});
  EXPECT_TRUE(tracker_.Moving().empty());
}

}  // namespace
}  // namespace vfh_astar
