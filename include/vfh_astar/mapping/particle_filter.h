#ifndef VFH_ASTAR_MAPPING_PARTICLE_FILTER_H_
#define VFH_ASTAR_MAPPING_PARTICLE_FILTER_H_

#include <Eigen/Core>
#include <cstdint>
#include <random>
#include <vector>

#include "vfh_astar/geometry.h"
#include "vfh_astar/mapping/hit_field.h"
#include "vfh_astar/mapping/motion_model.h"
#include "vfh_astar/mapping/scan_matcher.h"
#include "vfh_astar/parameters.h"

namespace vfh_astar {

struct ParticleFilterParameters {
  int particles = 5;  ///< 1 is plain scan matching.
  /// Scales what a scan says about the particles against each other; below 1,
  /// as scans that overlap repeat what they say.
  double weight_scale = 0.3;
  /// Scales the spread that poses are drawn with; 1 takes scan and odometry at
  /// their word.
  double draw_scale = 0.2;
  double resample_threshold = 0.5;  ///< of the particles, effective ones.

  void Read(ParameterReader& reader);
};

/// A history of poses, and the map that follows from it.
struct Particle {
  std::vector<Pose2D> trajectory;  ///< one pose per scan, map frame.
  double log_weight = 0.0;         ///< nats, relative to the others.
  HitField field;

  const Pose2D& pose() const { return trajectory.back(); }
};

/// Grid-based SLAM with a Rao-Blackwellised particle filter (Grisetti,
/// Stachniss, Burgard, "Improved techniques for grid mapping with
/// Rao-Blackwellized particle filters", IEEE T-RO 2007): each particle's pose
/// is drawn from the Gaussian of odometry and scan together, it is weighted by
/// how well both agree, and particles are resampled only when few are left that
/// count. They share the tiles of their maps as long as they are equal.
///
/// The same calls with the same seed give the same result.
class ParticleFilter {
 public:
  ParticleFilter(const ParticleFilterParameters& parameters,
                 const ScanMatcher& matcher,
                 const MotionModelParameters& motion_model, std::uint32_t seed,
                 const Pose2D& start = Pose2D());

  /// Takes in a scan.
  /// @param[in] shape as ScanMatcher::Shape gives it. A scan without hits moves
  ///   the particles by odometry alone.
  /// @param[in] motion of the base since the last scan, by odometry; ignored
  ///   for the first scan, which lies at the start.
  void AddScan(const ScanShape& shape, const Pose2D& motion);

  /// Puts all particles on one history: what is known better from elsewhere.
  /// @param[in] trajectory a pose for every scan added.
  /// @param[in] field the map of that history.
  void Restart(const std::vector<Pose2D>& trajectory, const HitField& field);

  const std::vector<Particle>& particles() const { return particles_; }
  /// The one with the greatest weight. Not before the first scan.
  const Particle& best() const;
  /// Effective number of particles, 1 to all.
  double EffectiveParticles() const;

 private:
  PoseBelief Predict(const Particle& particle, const Pose2D& motion) const;
  void Move(Particle& particle, const std::vector<Eigen::Vector2d>& points,
            const Pose2D& motion, const Pose2D& correction);
  Pose2D Draw(const PoseBelief& belief);
  void Resample();

  ParticleFilterParameters parameters_;
  ScanMatcher matcher_;
  MotionModelParameters motion_model_;
  Pose2D start_;
  std::mt19937 random_;
  std::vector<Particle> particles_;
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_MAPPING_PARTICLE_FILTER_H_
