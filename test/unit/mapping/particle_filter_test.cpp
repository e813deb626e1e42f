#include "vfh_astar/mapping/particle_filter.h"

#include <gtest/gtest.h>

#include <random>

#include "mapping/building.h"

namespace vfh_astar {
namespace {

ParticleFilter Filter(const ParticleFilterParameters& parameters,
                      std::uint32_t seed) {
  return ParticleFilter(parameters, ScanMatcher{ScanMatcherParameters()},
                        MotionModelParameters(), seed);
}

/// Half a metre at a time along the lower side of the ring.
void DriveAhead(int scans, ParticleFilter& filter) {
  std::mt19937 random(9);
  const ScanMatcher matcher{ScanMatcherParameters()};
  const Building ring = RingCorridor();
  for (int i = 0; i < scans; ++i) {
    const Pose2D pose(0.5 * i, 0.0, 0.0);
    filter.AddScan(matcher.Shape(Look(ring, pose, 0.01, random), {}),
                   {0.5, 0.0, 0.0});
  }
}

TEST(ParticleFilter, OneParticleIsPlainScanMatching) {
  ParticleFilterParameters parameters;
  parameters.particles = 1;
  ParticleFilter filter = Filter(parameters, 1);
  ParticleFilter other = Filter(parameters, 2);
  DriveAhead(12, filter);
  DriveAhead(12, other);
  // No chance in it, whatever the seed.
  EXPECT_EQ(filter.best().pose().x, other.best().pose().x);
  EXPECT_NEAR(filter.best().pose().x, 5.5, 0.1);
  EXPECT_NEAR(filter.best().pose().y, 0.0, 0.05);
}

TEST(ParticleFilter, IsDecidedByItsSeed) {
  ParticleFilterParameters parameters;
  parameters.particles = 8;
  const auto poses = [&](std::uint32_t seed) {
    ParticleFilter filter = Filter(parameters, seed);
    DriveAhead(10, filter);
    std::vector<double> all;
    for (const Particle& particle : filter.particles()) {
      all.push_back(particle.pose().x);
      all.push_back(particle.log_weight);
    }
    return all;
  };
  EXPECT_EQ(poses(3), poses(3));
  EXPECT_NE(poses(3), poses(4));
}

TEST(ParticleFilter, ParticlesShareWhatTheyHaveInCommon) {
  ParticleFilterParameters parameters;
  parameters.particles = 4;
  ParticleFilter filter = Filter(parameters, 1);
  DriveAhead(1, filter);
  const auto& particles = filter.particles();
  // The cupboard-sized niche at (5 m, -1.5 m), in cells of 0.05 m.
  EXPECT_TRUE(particles[0].field.SharesTile(particles[3].field, 0, -20));
  filter.Restart(particles[0].trajectory, particles[0].field);
  EXPECT_TRUE(particles[0].field.SharesTile(particles[3].field, 0, -20));
}

TEST(ParticleFilter, ResamplesOnlyWhenFewParticlesCount) {
  ParticleFilterParameters parameters;
  parameters.particles = 10;
  parameters.resample_threshold = 0.0;
  ParticleFilter never = Filter(parameters, 1);
  DriveAhead(15, never);
  EXPECT_LT(never.EffectiveParticles(), 10.0);
  parameters.resample_threshold = 1.0;
  ParticleFilter always = Filter(parameters, 1);
  DriveAhead(15, always);
  EXPECT_NEAR(always.EffectiveParticles(), 10.0, 1e-9);
}

TEST(ParticleFilter, GoesOnFromWhereItIsRestarted) {
  ParticleFilterParameters parameters;
  parameters.particles = 3;
  ParticleFilter filter = Filter(parameters, 1);
  DriveAhead(2, filter);
  const Pose2D elsewhere(100.0, 50.0, 1.0);
  filter.Restart({{}, elsewhere}, HitField(0.05, 0.05, 0.75));
  filter.AddScan({}, {1.0, 0.0, 0.0});
  const Pose2D expected = elsewhere * Pose2D(1.0, 0.0, 0.0);
  EXPECT_EQ(filter.best().trajectory.size(), 3u);
  EXPECT_NEAR(filter.best().pose().x, expected.x, 0.3);
  EXPECT_NEAR(filter.best().pose().y, expected.y, 0.3);
}

}  // namespace
}  // namespace vfh_astar
