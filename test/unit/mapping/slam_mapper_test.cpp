#include "vfh_astar/mapping/slam_mapper.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "mapping/building.h"
#include "temporary_folder.h"
#include "vfh_astar/grid/map_file.h"

namespace vfh_astar {
namespace {

SlamMapperParameters AroundTheRing() {
  SlamMapperParameters parameters;
  parameters.grid.xmin = -3.0;
  parameters.grid.ymin = -3.0;
  parameters.grid.xmax = 25.0;
  parameters.grid.ymax = 17.0;
  parameters.slam.filter.particles = 3;
  return parameters;
}

struct Step {
  LaserScan scan;
  Pose2D truth;
  Pose2D odometry;
};

/// A drive along poses, a second each, with odometry that errs always to the
/// same side.
std::vector<Step> Drive(const std::vector<Pose2D>& poses) {
  std::mt19937 random(7);
  std::vector<Step> drive;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    Step step{Look(RingCorridor(), poses[i], 0.01, random), poses[i], {}};
    step.scan.stamp = 1.0 * i;
    if (i > 0) {
      Pose2D motion = poses[i - 1].Inverse() * poses[i];
      motion.x *= 1.04;
      motion.theta = 0.97 * motion.theta + 0.01 * motion.x;
      step.odometry = drive.back().odometry * motion;
    }
    drive.push_back(step);
  }
  return drive;
}

Pose2D AddStep(const Step& step, SlamMapper* mapper) {
  mapper->AddScan(step.scan, {}, step.odometry);
  return mapper->map_from_odom() * step.odometry;
}

double Distance(const Pose2D& a, const Pose2D& b) {
  return (a.position() - b.position()).norm();
}

/// The largest error of the pose along a drive.
double RunAll(const std::vector<Step>& drive, SlamMapper* mapper) {
  double largest = 0.0;
  for (const Step& step : drive) {
    largest = std::max(largest, Distance(AddStep(step, mapper), step.truth));
  }
  return largest;
}

/// The ring's map, made from true poses.
OccupancyGrid TrueMap() {
  GridMapper mapper(AroundTheRing().grid);
  for (const Step& step : Drive(Laps(2))) mapper.AddScan(step.scan, step.truth);
  return mapper.Map();
}

void ExpectNear(const Pose2D& pose, const Pose2D& expected, double distance,
                double angle) {
  EXPECT_LT(Distance(pose, expected), distance);
  EXPECT_LT(std::abs(NormalizeAngle(pose.theta - expected.theta)), angle);
}

TEST(SlamMapper, WithOdometryAlonePosesAreTakenAsGiven) {
  SlamMapperParameters parameters = AroundTheRing();
  parameters.localization = "odometry";
  const Pose2D start(1.0, 2.0, 0.5);
  SlamMapper mapper(parameters, start);
  ExpectNear(mapper.map_from_odom(), start, 1e-9, 1e-9);
  const std::vector<Step> drive = Drive(Laps(1));
  const Pose2D begin(3.0, -1.0, 2.0);
  GridMapper expected(parameters.grid);
  for (const Step& step : drive) {
    mapper.AddScan(step.scan, {0.1, 0.0, 0.2}, begin * step.odometry);
    ExpectNear(mapper.map_from_odom() * begin * step.odometry,
               start * step.odometry, 1e-6, 1e-9);
    expected.AddScan(step.scan, start * step.odometry * Pose2D(0.1, 0.0, 0.2));
    EXPECT_FALSE(mapper.localization().is_lost);
  }
  EXPECT_EQ(mapper.grid_mapper().geometry(), expected.geometry());
}

TEST(SlamMapper, WithoutAMapPosesAreCorrected) {
  const std::vector<Step> drive = Drive(Laps(1));
  SlamMapper mapper(AroundTheRing(), {});
  const double error = RunAll(drive, &mapper);
  EXPECT_GT(Distance(drive.back().odometry, drive.back().truth), 2.0);
  EXPECT_LT(error, 0.5);
  EXPECT_FALSE(mapper.localization().is_lost);
}

TEST(SlamMapper, WithAMapNothingDrifts) {
  SlamMapper mapper(AroundTheRing(), {});
  mapper.SetMap(TrueMap());
  EXPECT_LT(RunAll(Drive(Laps(2)), &mapper), 0.1);
  EXPECT_FALSE(mapper.localization().is_lost);
  EXPECT_GT(mapper.localization().agreement.near_share(), 0.9);
}

TEST(SlamMapper, APoseGivenBeforeTheFirstScanIsTheStart) {
  const std::vector<Step> drive = Drive({{5.5, 0.0, 0.0}});
  SlamMapper without(AroundTheRing(), {});
  without.SetPose({5.0, 0.2, 0.1});
  ExpectNear(without.map_from_odom(), {5.0, 0.2, 0.1}, 1e-9, 1e-9);
  ExpectNear(AddStep(drive[0], &without), {5.0, 0.2, 0.1}, 1e-9, 1e-9);

  SlamMapper with(AroundTheRing(), {});
  with.SetMap(TrueMap());
  with.SetPose({5.1, 0.2, 0.1});
  ExpectNear(AddStep(drive[0], &with), {5.5, 0.0, 0.0}, 0.03, 0.01);

  SlamMapper map_last(AroundTheRing(), {});
  map_last.SetPose({5.1, 0.2, 0.1});
  map_last.SetMap(TrueMap());
  ExpectNear(AddStep(drive[0], &map_last), {5.5, 0.0, 0.0}, 0.03, 0.01);
}

TEST(SlamMapper, APoseGivenLaterHoldsAtOnceAndIsMadeExact) {
  const std::vector<Step> drive = Drive(Laps(1));
  SlamMapper mapper(AroundTheRing(), {});
  mapper.SetMap(TrueMap());
  for (int i = 0; i < 10; ++i) AddStep(drive[i], &mapper);
  // Taken from where it was to the other side of the ring.
  const Pose2D given = drive[60].truth * Pose2D(0.3, 0.2, -0.15);
  mapper.SetPose(given);
  ExpectNear(mapper.map_from_odom() * drive[9].odometry, given, 1e-6, 1e-9);
  LaserScan scan = drive[60].scan;
  scan.stamp = drive[9].scan.stamp + 0.1;
  mapper.AddScan(scan, {}, drive[9].odometry);
  ExpectNear(mapper.map_from_odom() * drive[9].odometry, drive[60].truth, 0.04,
             0.01);
}

TEST(SlamMapper, APoseGivenWhileMappingIsOneInTheMapSoFar) {
  const std::vector<Step> drive = Drive(Laps(1));
  SlamMapper mapper(AroundTheRing(), {});
  for (int i = 0; i < 30; ++i) AddStep(drive[i], &mapper);
  mapper.SetPose(drive[10].truth * Pose2D(0.2, -0.1, 0.1));
  Step back = drive[10];
  back.scan.stamp = 31.0;
  back.odometry = drive[29].odometry;
  ExpectNear(AddStep(back, &mapper), drive[10].truth, 0.15, 0.02);
}

TEST(SlamMapper, ForgettingKeepsThePoseAndLosesTheMap) {
  const std::vector<Step> drive = Drive(Laps(1));
  SlamMapper mapper(AroundTheRing(), {});
  Pose2D pose;
  for (int i = 0; i < 20; ++i) pose = AddStep(drive[i], &mapper);
  mapper.Forget();
  EXPECT_EQ(mapper.grid_mapper().Entropy(), 0.0);
  ExpectNear(mapper.map_from_odom() * drive[19].odometry, pose, 1e-9, 1e-9);
  // What was driven since counts.
  const Pose2D expected =
      pose * (drive[19].odometry.Inverse() * drive[20].odometry);
  ExpectNear(AddStep(drive[20], &mapper), expected, 1e-6, 1e-9);
  EXPECT_GT(mapper.grid_mapper().Entropy(), 0.0);
}

TEST(SlamMapper, ForgettingGoesBackToTheMapThatWasGiven) {
  const OccupancyGrid map = TrueMap();
  const std::vector<Step> drive = Drive(Laps(1));
  SlamMapper mapper(AroundTheRing(), {});
  mapper.SetMap(map);
  Pose2D pose;
  for (int i = 0; i < 20; ++i) pose = AddStep(drive[i], &mapper);
  EXPECT_NE(mapper.grid_mapper().Map().cells(), map.cells());
  mapper.Forget();
  EXPECT_EQ(mapper.grid_mapper().Map().cells(), map.cells());
  EXPECT_LT(Distance(AddStep(drive[20], &mapper), drive[20].truth), 0.1);
}

TEST(SlamMapper, ASavedMapCanBeContinued) {
  const TemporaryFolder folder;
  const std::vector<Step> drive = Drive(Laps(1));
  const auto middle = drive.begin() + 40;
  SlamMapper first(AroundTheRing(), {});
  RunAll({drive.begin(), middle}, &first);
  SaveMap(first.grid_mapper().Map(), folder.Path("half"));
  const OccupancyGrid half = LoadMap(folder.Path("half.yaml"));

  SlamMapper second(AroundTheRing(), drive[39].truth);
  second.SetMap(half);
  EXPECT_EQ(second.grid_mapper().geometry(), first.grid_mapper().geometry());
  const double error = RunAll({middle - 1, drive.end()}, &second);
  EXPECT_LT(error, 0.5);
  EXPECT_FALSE(second.localization().is_lost);
  // What was known stays, what is new comes to it.
  const OccupancyGrid whole = second.grid_mapper().Map();
  int forgotten = 0;
  int grown = 0;
  for (int y = 0; y < half.geometry().height; ++y) {
    for (int x = 0; x < half.geometry().width; ++x) {
      const Cell there =
          whole.geometry().ToCell(half.geometry().ToWorld({x, y}));
      const bool was_known = half[{x, y}] != kUnknown;
      const bool is_known = whole[there] != kUnknown;
      forgotten += was_known && !is_known ? 1 : 0;
      grown += !was_known && is_known ? 1 : 0;
    }
  }
  EXPECT_EQ(forgotten, 0);
  EXPECT_GT(grown, 2000);
}

TEST(SlamMapper, ARevisedMapIsThatOfTheCorrectedPoses) {
  const SlamMapperParameters parameters = AroundTheRing();
  const std::vector<Step> drive = Drive(Laps(2));
  SlamMapper mapper(parameters, {});
  Slam slam(parameters.slam, parameters.seed);
  std::vector<LaserScan> used;
  int revisions = 0;
  for (const Step& step : drive) {
    const int revision = slam.revision();
    const MapChange change = mapper.AddScan(step.scan, {}, step.odometry);
    if (slam.AddScan(step.scan, {}, step.odometry)) used.push_back(step.scan);
    if (slam.revision() == revision) continue;
    ++revisions;
    EXPECT_TRUE(change.inserted);
    EXPECT_TRUE(change.resized);
    GridMapper expected(parameters.grid);
    for (std::size_t i = 0; i < used.size(); ++i) {
      expected.AddScan(used[i], slam.trajectory()[i]);
    }
    ASSERT_EQ(mapper.grid_mapper().geometry(), expected.geometry());
    EXPECT_EQ(mapper.grid_mapper().Map().cells(), expected.Map().cells());
  }
  EXPECT_GT(revisions, 0);
}

TEST(SlamMapper, TheSameSeedGivesTheSameMap) {
  const std::vector<Step> drive = Drive(Laps(1));
  SlamMapper once(AroundTheRing(), {});
  SlamMapper again(AroundTheRing(), {});
  EXPECT_EQ(RunAll(drive, &once), RunAll(drive, &again));
  EXPECT_EQ(once.grid_mapper().Map().cells(),
            again.grid_mapper().Map().cells());
}

/// A drive whose odometry begins anew somewhere else while the robot stands.
std::vector<Step> WithJump(std::vector<Step> drive, std::size_t at,
                           const Pose2D& jump) {
  Step repeated = drive[at];
  repeated.scan.stamp += 0.5;
  drive.insert(drive.begin() + at + 1, repeated);
  for (std::size_t i = at + 1; i < drive.size(); ++i) {
    drive[i].odometry = jump * drive[i].odometry;
  }
  return drive;
}

TEST(SlamMapper, AnOdometryJumpLeavesTheMapAsItWas) {
  const std::vector<Step> drive = Drive(Laps(1));
  SlamMapper mapper(AroundTheRing(), {});
  SlamMapper jumped(AroundTheRing(), {});
  RunAll(WithJump(drive, 30, {}), &mapper);
  const double error = RunAll(WithJump(drive, 30, {7.0, -4.0, 2.0}), &jumped);
  EXPECT_LT(error, 0.5);
  EXPECT_EQ(mapper.localization().odometry_jumps, 0);
  EXPECT_EQ(jumped.localization().odometry_jumps, 1);
  EXPECT_FALSE(jumped.localization().is_lost);
  EXPECT_EQ(mapper.grid_mapper().Map().cells(),
            jumped.grid_mapper().Map().cells());
}

/// Carried out of the ring.
Step InTheRoom() {
  std::mt19937 random(9);
  return {Look(Room(), {0.0, 0.0, 2.0}, 0.01, random), {}, {}};
}

/// Scans of one place again and again, ten a second, from a robot that stands.
void Stay(const Step& step, const Pose2D& odometry, double* stamp, int scans,
          SlamMapper* mapper) {
  LaserScan scan = step.scan;
  for (int i = 0; i < scans; ++i) {
    scan.stamp = *stamp += 0.1;
    mapper->AddScan(scan, {}, odometry);
  }
}

TEST(SlamMapper, AKidnappedRobotKnowsAndLeavesTheMapAlone) {
  const std::vector<Step> drive = Drive(Laps(1));
  SlamMapper mapper(AroundTheRing(), {});
  mapper.SetMap(TrueMap());
  for (int i = 0; i < 10; ++i) AddStep(drive[i], &mapper);
  double stamp = drive[9].scan.stamp;
  const std::vector<std::int8_t> before = mapper.grid_mapper().Map().cells();
  Stay(InTheRoom(), drive[9].odometry, &stamp, 20, &mapper);
  EXPECT_TRUE(mapper.localization().is_lost);
  EXPECT_TRUE(mapper.grid_mapper().Map().cells() == before);
  // Back in the ring, at a corner, and told so.
  const Step there = drive[45];
  mapper.SetPose(there.truth * Pose2D(0.2, 0.1, 0.1));
  EXPECT_FALSE(mapper.localization().is_lost);
  Stay(there, drive[9].odometry, &stamp, 20, &mapper);
  EXPECT_FALSE(mapper.localization().is_lost);
  ExpectNear(mapper.map_from_odom() * drive[9].odometry, there.truth, 0.04,
             0.01);
}

TEST(SlamMapper, ARobotLostInItsOwnMapMayBeginAnew) {
  const std::vector<Step> drive = Drive(Laps(1));
  SlamMapper mapper(AroundTheRing(), {});
  for (int i = 0; i < 50; ++i) AddStep(drive[i], &mapper);
  double stamp = drive[49].scan.stamp;
  Stay(InTheRoom(), drive[49].odometry, &stamp, 30, &mapper);
  ASSERT_TRUE(mapper.localization().is_lost);
  mapper.Forget();
  EXPECT_FALSE(mapper.localization().is_lost);
  Stay(InTheRoom(), drive[49].odometry, &stamp, 3, &mapper);
  EXPECT_GT(mapper.grid_mapper().Entropy(), 0.0);
}

TEST(SlamMapper, GyroDriftOfAStandingRobotDoesNotTurnTheMap) {
  const std::vector<Step> drive = Drive(Laps(1));
  for (const bool has_map : {false, true}) {
    SlamMapper mapper(AroundTheRing(), {});
    if (has_map) mapper.SetMap(TrueMap());
    for (int i = 0; i < 10; ++i) AddStep(drive[i], &mapper);
    const Pose2D before = mapper.map_from_odom() * drive[9].odometry;
    double stamp = drive[9].scan.stamp;
    Pose2D odometry = drive[9].odometry;
    for (int i = 0; i < 400; ++i) {
      odometry = odometry * Pose2D(0.0, 0.0, 0.0005);
      Stay(drive[9], odometry, &stamp, 1, &mapper);
      ExpectNear(mapper.map_from_odom() * odometry, before, 0.04, 0.015);
    }
  }
}

}  // namespace
}  // namespace vfh_astar
