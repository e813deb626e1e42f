#include "vfh_astar/mapping/slam.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "mapping/building.h"

namespace vfh_astar {
namespace {

struct Drive {
  std::vector<Pose2D> truth;     ///< the first at the origin.
  std::vector<Pose2D> odometry;  ///< wears off.
  std::vector<LaserScan> scans;
};

Drive DriveLaps(int laps) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  const Building ring = RingCorridor();
  Drive drive;
  drive.truth = Laps(laps);
  drive.odometry.push_back({});
  for (std::size_t i = 0; i < drive.truth.size(); ++i) {
    drive.scans.push_back(Look(ring, drive.truth[i], 0.01, random));
    if (i == 0) continue;
    Pose2D motion = drive.truth[i - 1].Inverse() * drive.truth[i];
    motion.x *= 1.03 + 0.05 * normal(random);
    motion.theta =
        1.04 * motion.theta + 0.01 * motion.x + 0.01 * normal(random);
    drive.odometry.push_back(drive.odometry.back() * motion);
  }
  return drive;
}

Slam RunSlam(const Drive& drive, const SlamParameters& parameters,
             std::uint32_t seed) {
  Slam slam(parameters, seed);
  for (std::size_t i = 0; i < drive.scans.size(); ++i) {
    EXPECT_TRUE(slam.AddScan(drive.scans[i], {}, drive.odometry[i]));
  }
  slam.Finish();
  return slam;
}

double LargestError(const std::vector<Pose2D>& poses,
                    const std::vector<Pose2D>& truth) {
  double largest = 0.0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    largest =
        std::max(largest, (poses[i].position() - truth[i].position()).norm());
  }
  return largest;
}

SlamParameters WithParticles(int particles) {
  SlamParameters parameters;
  parameters.linear_update = 0.0;
  parameters.angular_update = 0.0;
  parameters.filter.particles = particles;
  return parameters;
}

TEST(Slam, ClosesALoopThatOdometryLeavesOpen) {
  const Drive drive = DriveLaps(2);
  EXPECT_GT(LargestError(drive.odometry, drive.truth), 2.0);
  for (const int particles : {1, 10}) {
    const Slam slam = RunSlam(drive, WithParticles(particles), 1);
    EXPECT_LT(LargestError(slam.trajectory(), drive.truth), 0.25);
    EXPECT_GT(slam.revision(), 0);
  }
}

TEST(Slam, ParticlesAloneFollowToo) {
  const Drive drive = DriveLaps(1);
  SlamParameters parameters = WithParticles(10);
  parameters.loop_closure = false;
  const Slam slam = RunSlam(drive, parameters, 1);
  EXPECT_LT(LargestError(slam.trajectory(), drive.truth), 0.6);
  EXPECT_TRUE(slam.constraints().empty());
}

TEST(Slam, TheSameSeedGivesTheSameResult) {
  const Drive drive = DriveLaps(1);
  const auto trajectory = [&](std::uint32_t seed) {
    return RunSlam(drive, WithParticles(5), seed).trajectory();
  };
  const std::vector<Pose2D> once = trajectory(1);
  const std::vector<Pose2D> again = trajectory(1);
  for (std::size_t i = 0; i < once.size(); ++i) {
    EXPECT_EQ(once[i].x, again[i].x);
    EXPECT_EQ(once[i].y, again[i].y);
    EXPECT_EQ(once[i].theta, again[i].theta);
  }
}

TEST(Slam, ARobotThatHardlyMovesIsFollowedByOdometry) {
  const Drive drive = DriveLaps(1);
  Slam slam(SlamParameters(), 1);
  EXPECT_TRUE(slam.AddScan(drive.scans[0], {}, {5.0, 5.0, 1.0}));
  EXPECT_FALSE(slam.AddScan(drive.scans[0], {}, {5.0, 5.1, 1.0}));
  EXPECT_EQ(slam.trajectory().size(), 1u);
  const Pose2D pose = slam.PoseAt({5.0, 5.1, 1.1});
  EXPECT_NEAR(pose.x, 0.1 * std::sin(1.0), 1e-9);
  EXPECT_NEAR(pose.y, 0.1 * std::cos(1.0), 1e-9);
  EXPECT_NEAR(pose.theta, 0.1, 1e-9);
}

}  // namespace
}  // namespace vfh_astar
