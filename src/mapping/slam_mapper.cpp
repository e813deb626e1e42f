#include "vfh_astar/mapping/slam_mapper.h"

#include <cmath>

namespace vfh_astar {
namespace {

constexpr double kJudgingPeriod = 0.25;  // s
constexpr int kFewestKnown = 30;         // hits on the map that say something
constexpr int kDoubtsToBeLost = 4;       // in a row
constexpr double kSearchPeriod = 0.5;    // s between two searches when lost

/// Hits that lie so near to something occupied are explained by it.
double ReachOf(const LogOddsGrid& grid) {
  return 2.0 * grid.geometry().resolution;
}

}  // namespace

void SlamMapperParameters::Read(ParameterReader& reader) {
  grid.Read(reader);
  reader.Choice("localization", localization, {"slam", "odometry"});
  reader.Integer("seed", seed, 0, 1 << 30);
  reader.Group("movers", movers);
  reader.Group("slam", slam);
  reader.Group("localizer", localizer);
  reader.Number("lost_near_share", lost_near_share, 0.0, 1.0);
  reader.Number("lost_pierced_share", lost_pierced_share, 0.0, 1.0);
}

SlamMapper::SlamMapper(const SlamMapperParameters& parameters,
                       const Pose2D& start)
    : parameters_(parameters),
      matcher_(parameters.slam.matcher),
      tracker_(parameters.movers),
      start_(start),
      grid_(parameters.grid),
      map_from_guarded_(start),
      map_from_odom_(start) {
  if (parameters_.localization == "slam") BeginSlam(start);
}

void SlamMapper::SetMap(const OccupancyGrid& map) {
  known_map_ = map;
  grid_.SetMap(map);
  if (slam_ || localizer_) LocalizeFrom(start_);
}

void SlamMapper::SetPose(const Pose2D& map_from_base) {
  localization_.is_lost = false;
  doubts_ = 0;
  if (!has_begun_) {
    start_ = map_from_base;
    if (slam_) {
      slam_ =
          std::make_unique<Slam>(parameters_.slam, parameters_.seed, start_);
    }
  }
  if (localizer_ || (slam_ && has_begun_)) LocalizeFrom(map_from_base);
  map_from_guarded_ = map_from_base * guarded_odometry_.Inverse();
}

void SlamMapper::Forget() {
  grid_ = GridMapper(parameters_.grid);
  if (known_map_) grid_.SetMap(*known_map_);
  // What the poses were found by is forgotten with the map, unless it is given.
  if (slam_ || (localizer_ && !known_map_)) {
    BeginSlam(map_from_guarded_ * guarded_odometry_);
  }
}

void SlamMapper::BeginSlam(const Pose2D& start) {
  slam_ = std::make_unique<Slam>(parameters_.slam, parameters_.seed, start);
  localizer_.reset();
  kept_.clear();
  revision_ = slam_->revision();
}

void SlamMapper::LocalizeFrom(const Pose2D& pose) {
  localizer_ =
      std::make_unique<Localizer>(parameters_.localizer, matcher_,
                                  parameters_.slam.motion, grid_.grid(), pose);
  localized_odometry_ = guarded_odometry_;
  localized_at_.reset();
  slam_.reset();
  kept_.clear();
}

MapChange SlamMapper::AddScan(const LaserScan& whole_scan,
                              const Pose2D& base_from_laser,
                              const Pose2D& odom_from_base) {
  guarded_odometry_ = guard_.Add(whole_scan.stamp, odom_from_base);
  const LaserScan scan =
      WithoutMovers(whole_scan, guarded_odometry_ * base_from_laser);
  localization_.odometry_jumps = guard_.jumps();
  if (!has_begun_) {
    map_from_guarded_ = start_ * guarded_odometry_.Inverse();
    localized_odometry_ = guarded_odometry_;
    has_begun_ = true;
  }
  const Pose2D pose = Localize(scan, base_from_laser);
  map_from_guarded_ = pose * guarded_odometry_.Inverse();
  map_from_odom_ = pose * odom_from_base.Inverse();
  if (slam_ && slam_->revision() != revision_) return Rebuild();
  Judge(scan, base_from_laser, pose);
  if (localization_.is_lost) return {};
  return grid_.AddScan(scan, pose * base_from_laser);
}

/// The scan without what moves, unless nothing else is in it.
LaserScan SlamMapper::WithoutMovers(const LaserScan& scan,
                                    const Pose2D& odom_from_laser) {
  tracker_.AddScan(scan, odom_from_laser);
  LaserScan still = tracker_.Without(scan);
  return DescribeDefect(still) ? scan : still;
}

/// The base's pose in the map.
Pose2D SlamMapper::Localize(const LaserScan& scan,
                            const Pose2D& base_from_laser) {
  if (slam_) {
    if (slam_->AddScan(scan, base_from_laser, guarded_odometry_)) {
      kept_.push_back({scan, base_from_laser});
    }
    return slam_->PoseAt(guarded_odometry_);
  }
  if (!localizer_) return map_from_guarded_ * guarded_odometry_;
  FollowInMap(scan, base_from_laser);
  return localizer_->pose() *
         (localized_odometry_.Inverse() * guarded_odometry_);
}

void SlamMapper::FollowInMap(const LaserScan& scan,
                             const Pose2D& base_from_laser) {
  const Pose2D motion = localized_odometry_.Inverse() * guarded_odometry_;
  if (localization_.is_lost) {
    if (localized_at_ && scan.stamp - *localized_at_ < kSearchPeriod) return;
    localization_.is_lost =
        !localizer_->FindAgain(matcher_.Shape(scan, base_from_laser).probes,
                               base_from_laser.position(), motion);
    doubts_ = 0;
  } else {
    const bool is_due =
        motion.position().norm() >= parameters_.slam.linear_update ||
        std::abs(motion.theta) >= parameters_.slam.angular_update;
    if (localized_at_ && !is_due) return;
    localizer_->AddScan(matcher_.Shape(scan, base_from_laser), motion);
  }
  localized_odometry_ = guarded_odometry_;
  localized_at_ = scan.stamp;
}

void SlamMapper::Judge(const LaserScan& scan, const Pose2D& base_from_laser,
                       const Pose2D& pose) {
  if (localization_.is_lost || !(slam_ || localizer_)) return;
  if (judged_at_ && std::abs(scan.stamp - *judged_at_) < kJudgingPeriod) return;
  judged_at_ = scan.stamp;
  const MapAgreement agreement =
      CompareWithMap(grid_.grid(), matcher_.Shape(scan, base_from_laser).probes,
                     base_from_laser.position(), pose, ReachOf(grid_.grid()));
  localization_.agreement = agreement;
  const bool is_doubtful =
      agreement.known >= kFewestKnown &&
      agreement.near_share() < parameters_.lost_near_share &&
      agreement.pierced_share() > parameters_.lost_pierced_share;
  doubts_ = is_doubtful ? doubts_ + 1 : 0;
  if (doubts_ < kDoubtsToBeLost) return;
  localization_.is_lost = true;
  if (slam_) LocalizeFrom(pose);
}

/// The map from the kept scans, with the poses as they are known now.
MapChange SlamMapper::Rebuild() {
  revision_ = slam_->revision();
  grid_ = GridMapper(parameters_.grid);
  for (std::size_t i = 0; i < kept_.size(); ++i) {
    grid_.AddScan(kept_[i].scan,
                  slam_->trajectory()[i] * kept_[i].base_from_laser);
  }
  MapChange change;
  change.inserted = true;
  change.resized = true;
  change.window = grid_.geometry().Bounds();
  return change;
}

}  // namespace vfh_astar
