#include "vfh_astar/mapping/particle_filter.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cassert>
#include <cmath>

namespace vfh_astar {

void ParticleFilterParameters::Read(ParameterReader& reader) {
  reader.Integer("particles", particles, 1, 1000);
  reader.Number("resample_threshold", resample_threshold, 0.0, 1.0);
}

ParticleFilter::ParticleFilter(const ParticleFilterParameters& parameters,
                               const ScanMatcher& matcher,
                               const MotionModelParameters& motion_model,
                               std::uint32_t seed, const Pose2D& start)
    : parameters_(parameters),
      matcher_(matcher),
      motion_model_(motion_model),
      start_(start),
      random_(seed),
      particles_(parameters.particles, Particle{{}, 0.0, matcher.MakeField()}) {
}

void ParticleFilter::AddScan(const ScanShape& shape, const Pose2D& motion) {
  if (particles_.front().trajectory.empty()) {
    HitField field = particles_.front().field;
    field.Add(shape.walls, start_);
    Restart({start_}, field);
    return;
  }
  // The particles lie close together, so what odometry got wrong since the last
  // scan is looked for once.
  const PoseBelief likely = Predict(best(), motion);
  const Pose2D correction =
      shape.probes.empty()
          ? Pose2D()
          : likely.mean.Inverse() *
                matcher_.FindCoarse(best().field, shape.probes, likely);
  for (Particle& particle : particles_) {
    Move(particle, shape.probes, motion, correction);
  }
  if (EffectiveParticles() <
      parameters_.resample_threshold * particles_.size()) {
    Resample();
  }
  for (Particle& particle : particles_) {
    particle.field.Add(shape.walls, particle.pose());
  }
}

void ParticleFilter::Restart(const std::vector<Pose2D>& trajectory,
                             const HitField& field) {
  for (Particle& particle : particles_) {
    particle = Particle{trajectory, 0.0, field};
  }
}

const Particle& ParticleFilter::best() const {
  return *std::max_element(particles_.begin(), particles_.end(),
                           [](const Particle& a, const Particle& b) {
                             return a.log_weight < b.log_weight;
                           });
}

double ParticleFilter::EffectiveParticles() const {
  const double top = best().log_weight;
  double sum = 0.0;
  double squares = 0.0;
  for (const Particle& particle : particles_) {
    const double weight = std::exp(particle.log_weight - top);
    sum += weight;
    squares += weight * weight;
  }
  return sum * sum / squares;
}

PoseBelief ParticleFilter::Predict(const Particle& particle,
                                   const Pose2D& motion) const {
  return {particle.pose() * motion,
          MotionInformation(motion_model_, particle.pose(), motion)};
}

void ParticleFilter::Move(Particle& particle,
                          const std::vector<Eigen::Vector2d>& points,
                          const Pose2D& motion, const Pose2D& correction) {
  const PoseBelief prior = Predict(particle, motion);
  const Alignment alignment =
      matcher_.Align(particle.field, points, prior.mean * correction, prior);
  const bool is_alone = particles_.size() == 1;
  particle.trajectory.push_back(is_alone ? alignment.belief.mean
                                         : Draw(alignment.belief));
  // Laplace's approximation of the scan's likelihood under the prior.
  const double evidence =
      alignment.utility +
      0.5 * std::log(prior.information.determinant() /
                     alignment.belief.information.determinant());
  particle.log_weight += parameters_.weight_scale * evidence;
}

Pose2D ParticleFilter::Draw(const PoseBelief& belief) {
  std::normal_distribution<double> normal;
  Eigen::Vector3d noise;
  for (int i = 0; i < 3; ++i)
    noise[i] = parameters_.draw_scale * normal(random_);
  // With information = L L^T, the covariance of L^-T noise is its inverse.
  const Eigen::Vector3d offset =
      belief.information.llt().matrixU().solve(noise);
  return {belief.mean.x + offset.x(), belief.mean.y + offset.y(),
          NormalizeAngle(belief.mean.theta + offset.z())};
}

void ParticleFilter::Resample() {
  const double top = best().log_weight;
  double sum = 0.0;
  for (const Particle& particle : particles_) {
    sum += std::exp(particle.log_weight - top);
  }
  // Low variance: one draw, then even steps through the weights.
  const double step = sum / particles_.size();
  double at = std::uniform_real_distribution<double>(0.0, step)(random_);
  std::vector<Particle> chosen;
  chosen.reserve(particles_.size());
  double passed = 0.0;
  for (const Particle& particle : particles_) {
    passed += std::exp(particle.log_weight - top);
    while (at < passed && chosen.size() < particles_.size()) {
      chosen.push_back(particle);
      chosen.back().log_weight = 0.0;
      at += step;
    }
  }
  while (chosen.size() < particles_.size()) chosen.push_back(chosen.back());
  particles_ = std::move(chosen);
}

}  // namespace vfh_astar
