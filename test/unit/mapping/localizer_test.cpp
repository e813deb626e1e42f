#include "vfh_astar/mapping/localizer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "mapping/building.h"
#include "vfh_astar/mapping/grid_mapper.h"

namespace vfh_astar {
namespace {

GridMapperParameters AroundTheRing() {
  GridMapperParameters parameters;
  parameters.xmin = -3.0;
  parameters.ymin = -3.0;
  parameters.xmax = 25.0;
  parameters.ymax = 17.0;
  return parameters;
}

/// The map of a building as seen from poses.
/// @param[in] walked poses along which it is looked at, twice each.
LogOddsGrid MapOf(const Building& building, const std::vector<Pose2D>& walked) {
  std::mt19937 random(3);
  GridMapper mapper(AroundTheRing());
  double stamp = 0.0;
  for (int round = 0; round < 2; ++round) {
    for (const Pose2D& pose : walked) {
      LaserScan scan = Look(building, pose, 0.005, random);
      scan.stamp = stamp += 1.0;
      mapper.AddScan(scan, pose);
    }
  }
  return mapper.grid();
}

std::vector<Pose2D> AllAround(const Pose2D& pose) {
  std::vector<Pose2D> poses;
  for (int i = 0; i < 8; ++i) {
    poses.push_back(pose * Pose2D(0.0, 0.0, 0.25 * kPi * i));
  }
  return poses;
}

class LocalizerTest : public ::testing::Test {
 protected:
  Localizer Begin(const LogOddsGrid& map, const Pose2D& pose) const {
    return Localizer({}, matcher_, {}, map, pose);
  }

  ScanShape See(const Building& building, const Pose2D& pose) {
    return matcher_.Shape(Look(building, pose, 0.01, random_), {});
  }

  ScanMatcher matcher_{ScanMatcherParameters()};
  std::mt19937 random_{5};
};

double Distance(const Pose2D& a, const Pose2D& b) {
  return (a.position() - b.position()).norm();
}

void ExpectNear(const Pose2D& pose, const Pose2D& truth) {
  EXPECT_LT(Distance(pose, truth), 0.03);
  EXPECT_NEAR(NormalizeAngle(pose.theta - truth.theta), 0.0, 0.01);
}

TEST_F(LocalizerTest, RecoversWhatTheGivenPoseIsOff) {
  const LogOddsGrid map = MapOf(Room(), AllAround({}));
  const Pose2D truth(0.4, -0.3, 0.6);
  for (const Pose2D& off :
       {Pose2D(), Pose2D(0.45, 0.0, 0.0), Pose2D(-0.2, -0.35, 0.25),
        Pose2D(0.1, 0.4, -0.28), Pose2D(0.0, 0.0, 0.3)}) {
    Localizer localizer = Begin(map, truth * off);
    localizer.AddScan(See(Room(), truth), {});
    ExpectNear(localizer.pose(), truth);
  }
}

TEST_F(LocalizerTest, TakesTheMotionSinceThePoseWasGivenAlong) {
  const LogOddsGrid map = MapOf(Room(), AllAround({}));
  const Pose2D truth(0.4, -0.3, 0.6);
  const Pose2D motion(1.5, 0.0, 0.8);
  Localizer localizer = Begin(map, truth * motion.Inverse());
  localizer.AddScan(See(Room(), truth), motion);
  ExpectNear(localizer.pose(), truth);
}

TEST_F(LocalizerTest, FollowsOdometryThatIsBiased) {
  const std::vector<Pose2D> lap = Laps(2);
  const LogOddsGrid map = MapOf(RingCorridor(), Laps(1));
  Localizer localizer = Begin(map, lap.front());
  localizer.AddScan(See(RingCorridor(), lap.front()), {});
  for (std::size_t i = 1; i < lap.size(); ++i) {
    Pose2D motion = lap[i - 1].Inverse() * lap[i];
    motion.x *= 1.05;
    motion.theta = 0.95 * motion.theta + 0.02 * motion.x;
    localizer.AddScan(See(RingCorridor(), lap[i]), motion);
    // Along the bare parts of the corridor odometry alone decides.
    ASSERT_LT(Distance(localizer.pose(), lap[i]), 0.15) << i;
  }
}

TEST_F(LocalizerTest, FollowsOdometryWhereNothingIsSeen) {
  const LogOddsGrid map = MapOf(Room(), AllAround({}));
  Localizer localizer = Begin(map, {});
  localizer.AddScan(See(Room(), {}), {});
  const Pose2D before = localizer.pose();
  localizer.AddScan({}, {0.5, 0.1, 0.2});
  EXPECT_LT(Distance(localizer.pose(), before * Pose2D(0.5, 0.1, 0.2)), 1e-9);
}

TEST_F(LocalizerTest, DrivesOnBeyondTheMap) {
  const std::vector<Pose2D> lap = Laps(1);
  const std::vector<Pose2D> first_side(lap.begin(), lap.begin() + 20);
  const LogOddsGrid map = MapOf(RingCorridor(), first_side);
  ASSERT_EQ(map[map.geometry().ToCell({-1.0, 13.0})], kUnexplored);
  Localizer localizer = Begin(map, lap.front());
  localizer.AddScan(See(RingCorridor(), lap.front()), {});
  Pose2D odometry = lap.front();
  double largest = 0.0;
  for (std::size_t i = 1; i < lap.size(); ++i) {
    Pose2D motion = lap[i - 1].Inverse() * lap[i];
    motion.x *= 1.02;
    motion.theta *= 0.96;
    odometry = odometry * motion;
    localizer.AddScan(See(RingCorridor(), lap[i]), motion);
    largest = std::max(largest, Distance(localizer.pose(), lap[i]));
  }
  EXPECT_GT(Distance(odometry, lap.back()), 1.0);
  EXPECT_LT(largest, 0.5);
}

TEST_F(LocalizerTest, FindsALostRobot) {
  const LogOddsGrid map = MapOf(RingCorridor(), Laps(1));
  const Pose2D truth(5.5, 0.2, 0.1);
  const std::vector<Eigen::Vector2d> points = See(RingCorridor(), truth).probes;
  for (const Pose2D& off :
       {Pose2D(2.0, 0.5, 0.3), Pose2D(-2.5, -0.4, -0.6), Pose2D()}) {
    Localizer localizer = Begin(map, truth * off);
    EXPECT_TRUE(localizer.FindAgain(points, {}, {}));
    ExpectNear(localizer.pose(), truth);
  }
}

TEST_F(LocalizerTest, RefusesWhatFitsNowhere) {
  const LogOddsGrid map = MapOf(RingCorridor(), Laps(1));
  const Pose2D elsewhere(11.0, 14.0, 0.7);
  Localizer localizer = Begin(map, elsewhere);
  EXPECT_FALSE(
      localizer.FindAgain(See(Room(), {0.0, 0.0, 2.0}).probes, {}, {}));
  EXPECT_LT(Distance(localizer.pose(), elsewhere), 1e-9);
  // Odometry still counts.
  EXPECT_FALSE(localizer.FindAgain(See(Room(), {0.0, 0.0, 2.0}).probes, {},
                                   {0.3, 0.0, 0.1}));
  EXPECT_LT(Distance(localizer.pose(), elsewhere * Pose2D(0.3, 0.0, 0.1)),
            1e-9);
}

TEST_F(LocalizerTest, RefusesTooFewHits) {
  const LogOddsGrid map = MapOf(Room(), AllAround({}));
  std::vector<Eigen::Vector2d> points = See(Room(), {}).probes;
  Localizer localizer = Begin(map, {});
  ASSERT_TRUE(localizer.FindAgain(points, {}, {}));
  points.resize(20);
  EXPECT_FALSE(localizer.FindAgain(points, {}, {}));
}

}  // namespace
}  // namespace vfh_astar
