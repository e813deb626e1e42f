#include "vfh_astar/tracking/obstacle_track.h"

#include <algorithm>
#include <cmath>

namespace vfh_astar {
namespace {

/// m^2/s^3, of the acceleration: a walker turns around within half a second.
constexpr double kAcceleration = 0.5;
constexpr double kFirstSpeed = 1.0;  ///< m/s, one standard deviation.

constexpr double kRadiusGain = 0.1;
constexpr double kEvidenceGain = 0.15;
/// Of what is seen, that must have come or gone for something to move, and
/// below which it stands again.
constexpr double kEnough = 0.12;
constexpr double kTooLittle = 0.03;
constexpr double kSigmas = 3.0;     ///< by which speed must exceed its error.
constexpr double kLeastAge = 0.25;  ///< s

}  // namespace

ObstacleTrack::ObstacleTrack(int id, double time, const TrackMeasurement& first)
    : id_(id),
      time_(time),
      first_seen_(time),
      last_seen_(time),
      obstacle_{first.position, Eigen::Vector2d::Zero(), first.radius},
      has_radius_(first.has_radius),
      pp_(first.sigma * first.sigma),
      vv_(kFirstSpeed * kFirstSpeed) {}

double ObstacleTrack::speed_sigma() const { return std::sqrt(vv_); }

void ObstacleTrack::Predict(double time) {
  const double dt = time - time_;
  time_ = time;
  if (dt <= 0.0) return;
  obstacle_.position += dt * obstacle_.velocity;
  pp_ += dt * (2.0 * pv_ + dt * vv_) + kAcceleration * dt * dt * dt / 3.0;
  pv_ += dt * vv_ + kAcceleration * dt * dt / 2.0;
  vv_ += kAcceleration * dt;
}

void ObstacleTrack::Correct(const TrackMeasurement& measurement) {
  last_seen_ = time_;
  const double innovation_variance =
      pp_ + measurement.sigma * measurement.sigma;
  const double gain_position = pp_ / innovation_variance;
  const double gain_velocity = pv_ / innovation_variance;
  const Eigen::Vector2d innovation = measurement.position - obstacle_.position;
  obstacle_.position += gain_position * innovation;
  obstacle_.velocity += gain_velocity * innovation;
  vv_ -= gain_velocity * pv_;
  pv_ -= gain_velocity * pp_;
  pp_ -= gain_position * pp_;
  if (measurement.has_radius && !has_radius_) {
    obstacle_.radius = measurement.radius;
    has_radius_ = true;
  } else if (measurement.has_radius == has_radius_) {
    obstacle_.radius += kRadiusGain * (measurement.radius - obstacle_.radius);
  }
}

void ObstacleTrack::Judge(double evidence, double min_speed) {
  evidence_ += kEvidenceGain * (evidence - evidence_);
  if (is_moving_) {
    is_moving_ = evidence_ > kTooLittle || speed() > 0.5 * min_speed;
    return;
  }
  is_moving_ = evidence_ > kEnough && speed() > min_speed &&
               speed() > kSigmas * speed_sigma() &&
               time_ - first_seen_ > kLeastAge;
}

}  // namespace vfh_astar
