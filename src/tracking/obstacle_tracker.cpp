#include "vfh_astar/tracking/obstacle_tracker.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vfh_astar {
namespace {

constexpr double kMargin = 0.1;        ///< m by which a beam must pass a place.
constexpr double kGate = 0.35;         ///< m between a track and a cluster.
constexpr double kFitSigma = 0.02;     ///< m, of a fitted centre.
constexpr double kGuessSigma = 0.08;   ///< m, of any other.
constexpr double kBestFit = 0.025;     ///< m of error of a circle.
constexpr double kLeastRadius = 0.05;  ///< m
constexpr double kLostTime = 0.15;   ///< s until what is not where it should be
                                     ///< is given up.
constexpr double kLongestGap = 0.5;  ///< s; a longer one begins anew.

Eigen::Vector2d Mean(const std::vector<Eigen::Vector2d>& points) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2d& point : points) sum += point;
  return sum / static_cast<double>(points.size());
}

}  // namespace

void TrackerParameters::Read(ParameterReader& reader) {
  reader.Number("max_range", max_range, 0.0, 100.0);
  reader.Number("max_extent", max_extent, 0.1, 10.0);
  reader.Number("min_speed", min_speed, 0.01, 5.0);
  reader.Number("memory", memory, 0.2, 5.0);
  reader.Number("coast_time", coast_time, 0.0, 10.0);
}

ObstacleTracker::ObstacleTracker(const TrackerParameters& parameters)
    : parameters_(parameters), memory_(parameters.memory) {}

void ObstacleTracker::AddScan(const LaserScan& scan, const Pose2D& laser_pose) {
  if (parameters_.max_range == 0.0) return;
  if (has_scan_) {
    const double gap = scan.stamp - last_.scan().stamp;
    if (gap == 0.0) return;
    if (gap < 0.0 || gap > kLongestGap) {
      tracks_.clear();
      memory_.Clear();
    }
  }
  last_ = PlacedScan(scan, laser_pose);
  has_scan_ = true;
  moving_beams_.clear();
  for (ObstacleTrack& track : tracks_) track.Predict(scan.stamp);
  std::vector<ScanCluster> clusters =
      FindClusters(scan, laser_pose, parameters_.max_range);
  clusters.erase(std::remove_if(clusters.begin(), clusters.end(),
                                [this](const ScanCluster& cluster) {
                                  return cluster.extent >
                                             parameters_.max_extent ||
                                         cluster.points.size() < 2;
                                }),
                 clusters.end());
  Follow(clusters);
  DropLost();
  memory_.Add(scan, laser_pose);
}

TrackMeasurement ObstacleTracker::Measure(const ScanCluster& cluster,
                                          const ObstacleTrack* track) const {
  const std::optional<Circle> circle = FitCircle(cluster.points);
  if (circle && circle->error < kBestFit && circle->radius >= kLeastRadius &&
      circle->radius <= 0.5 * parameters_.max_extent &&
      cluster.extent > 0.8 * circle->radius) {
    return {circle->centre, kFitSigma, circle->radius, true};
  }
  // Without a circle, the middle of what is seen lies before the centre by
  // about the radius.
  const Eigen::Vector2d mean = Mean(cluster.points);
  const Eigen::Vector2d away = mean - last_.pose().position();
  const bool knows_radius = track != nullptr && track->has_radius();
  double radius = 0.5 * cluster.extent;
  if (knows_radius) radius = track->obstacle().radius;
  const double depth = knows_radius ? 0.75 * radius : 0.0;
  return {mean + depth * away.normalized(), kGuessSigma,
          std::max(radius, kLeastRadius), false};
}

void ObstacleTracker::Follow(const std::vector<ScanCluster>& clusters) {
  struct Pair {
    double distance;
    std::size_t track;
    std::size_t cluster;
  };
  std::vector<Pair> pairs;
  for (std::size_t c = 0; c < clusters.size(); ++c) {
    const Eigen::Vector2d rough = Mean(clusters[c].points);
    for (std::size_t t = 0; t < tracks_.size(); ++t) {
      const MovingObstacle& obstacle = tracks_[t].obstacle();
      if ((obstacle.position - rough).norm() > kGate + obstacle.radius) {
        continue;
      }
      const double distance =
          (obstacle.position - Measure(clusters[c], &tracks_[t]).position)
              .norm();
      if (distance <= kGate) pairs.push_back({distance, t, c});
    }
  }
  std::sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) {
    return a.distance < b.distance;
  });
  std::vector<bool> is_followed(tracks_.size(), false);
  std::vector<bool> is_taken(clusters.size(), false);
  for (const Pair& pair : pairs) {
    if (is_followed[pair.track] || is_taken[pair.cluster]) continue;
    is_followed[pair.track] = true;
    is_taken[pair.cluster] = true;
    ObstacleTrack& track = tracks_[pair.track];
    track.Correct(Measure(clusters[pair.cluster], &track));
    Judge(track, clusters[pair.cluster]);
  }
  for (std::size_t c = 0; c < clusters.size(); ++c) {
    if (is_taken[c]) continue;
    tracks_.emplace_back(next_id_++, last_.scan().stamp,
                         Measure(clusters[c], nullptr));
    RememberPoints(clusters[c], tracks_.back());
  }
}

void ObstacleTracker::RememberPoints(const ScanCluster& cluster,
                                     ObstacleTrack& track) const {
  track.old_points = cluster.points;
  track.old_points_time = last_.scan().stamp;
  track.old_heading = last_.pose().theta;
}

void ObstacleTracker::Judge(ObstacleTrack& track, const ScanCluster& cluster) {
  const auto share = [](const std::vector<Eigen::Vector2d>& points,
                        const auto& holds) {
    return points.empty() ? 0.0
                          : static_cast<double>(std::count_if(
                                points.begin(), points.end(), holds)) /
                                points.size();
  };
  double evidence = 0.0;
  // Only what seems to move is worth the question.
  if (track.is_moving() || track.speed() > 0.5 * parameters_.min_speed) {
    const double entered =
        share(cluster.points, [this](const Eigen::Vector2d& point) {
          return memory_.WasFree(point, kMargin, last_.pose().theta);
        });
    const double left =
        share(track.old_points, [&](const Eigen::Vector2d& point) {
          return last_.SawThrough(point, kMargin, track.old_heading);
        });
    evidence = std::max(entered, left);
  }
  track.Judge(evidence, parameters_.min_speed);
  if (last_.scan().stamp - track.old_points_time > 0.5 * parameters_.memory) {
    RememberPoints(cluster, track);
  }
  if (!track.is_moving()) return;
  moving_beams_.insert(moving_beams_.end(), cluster.beams.begin(),
                       cluster.beams.end());
}

void ObstacleTracker::DropLost() {
  const double now = last_.scan().stamp;
  const auto is_lost = [&](const ObstacleTrack& track) {
    const double unseen = now - track.last_seen();
    if (unseen == 0.0) return false;
    if (!track.is_moving()) return unseen > kLostTime;
    // Where the laser sees through its place it is not there.
    const bool is_gone = last_.SawThrough(track.obstacle().position, kMargin,
                                          last_.pose().theta);
    return unseen > (is_gone ? kLostTime : parameters_.coast_time);
  };
  tracks_.erase(std::remove_if(tracks_.begin(), tracks_.end(), is_lost),
                tracks_.end());
}

std::vector<MovingObstacle> ObstacleTracker::Moving() const {
  std::vector<MovingObstacle> moving;
  for (const ObstacleTrack& track : tracks_) {
    if (track.is_moving()) moving.push_back(track.obstacle());
  }
  return moving;
}

LaserScan ObstacleTracker::Without(LaserScan scan) const {
  for (const std::size_t beam : moving_beams_) {
    scan.ranges[beam] = std::numeric_limits<float>::quiet_NaN();
  }
  return scan;
}

LaserScan ObstacleTracker::Only(const LaserScan& scan) const {
  LaserScan only = scan;
  std::fill(only.ranges.begin(), only.ranges.end(),
            std::numeric_limits<float>::quiet_NaN());
  for (const std::size_t beam : moving_beams_) {
    only.ranges[beam] = scan.ranges[beam];
  }
  return only;
}

}  // namespace vfh_astar
