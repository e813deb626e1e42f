#ifndef VFH_ASTAR_TRACKING_OBSTACLE_TRACK_H_
#define VFH_ASTAR_TRACKING_OBSTACLE_TRACK_H_

#include <Eigen/Core>
#include <vector>

#include "vfh_astar/tracking/moving_obstacle.h"

namespace vfh_astar {

/// Where something was seen.
struct TrackMeasurement {
  Eigen::Vector2d position;  ///< m
  double sigma;              ///< m, along each axis.
  double radius;             ///< m
  bool has_radius;           ///< the radius was measured, not guessed.
};

/// One thing followed through scans: a Kalman filter whose state is position
/// and velocity, driven by white acceleration. Both axes have the same noise
/// and therefore share one covariance.
class ObstacleTrack {
 public:
  ObstacleTrack(int id, double time, const TrackMeasurement& first);

  int id() const { return id_; }
  /// Now: at the time of the last Predict or Correct.
  const MovingObstacle& obstacle() const { return obstacle_; }
  double last_seen() const { return last_seen_; }    ///< s
  double first_seen() const { return first_seen_; }  ///< s
  bool has_radius() const { return has_radius_; }
  double speed() const { return obstacle_.velocity.norm(); }  ///< m/s
  /// m/s, one standard deviation of each component of the velocity.
  double speed_sigma() const;

  void Predict(double time);
  void Correct(const TrackMeasurement& measurement);

  /// Takes in how much of the thing is where there was nothing before, or is no
  /// longer where it was (0 to 1), and decides whether it moves.
  void Judge(double evidence, double min_speed);
  bool is_moving() const { return is_moving_; }

  /// Hits of a while ago, to see whether the thing has left them.
  std::vector<Eigen::Vector2d> old_points;
  double old_points_time = 0.0;
  double old_heading = 0.0;  ///< rad, of the laser then.

 private:
  int id_;
  double time_;
  double first_seen_;
  double last_seen_;
  MovingObstacle obstacle_;
  bool has_radius_;
  // Of each axis: position, position with velocity, velocity.
  double pp_;
  double pv_ = 0.0;
  double vv_;
  double evidence_ = 0.0;
  bool is_moving_ = false;
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_TRACKING_OBSTACLE_TRACK_H_
