#include "vfh_astar/mapping/slam_mapper.h"

#include <algorithm>
#include <cmath>

namespace vfh_astar {
namespace {

constexpr int kFewestKnown = 30;       // hits on the map that say something
constexpr int kFewestDoubts = 4;       // scans in a row, to be lost,
constexpr double kPatience = 1.0;      // s for which they last
constexpr double kSearchPeriod = 0.5;  // s between two searches when lost

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
  if (parameters_.localization == "slam") BeginSlam();
}

void SlamMapper::SetMap(const OccupancyGrid& map) {
  known_map_ = map;
  grid_.SetMap(map);
  if (slam_ || localizer_) LocalizeFrom(start_);
}

void SlamMapper::SetPose(const Pose2D& map_from_base) {
  Trust();
  if (!has_begun_) start_ = map_from_base;
  if (localizer_ || (slam_ && has_begun_)) LocalizeFrom(map_from_base);
  map_from_guarded_ = map_from_base * guarded_odometry_.Inverse();
  map_from_odom_ = map_from_base * odometry_.Inverse();
}

void SlamMapper::Forget() {
  grid_ = GridMapper(parameters_.grid);
  if (known_map_) grid_.SetMap(*known_map_);
  // What the poses were found by is forgotten with the map, unless it is given.
  if (slam_ || (localizer_ && !known_map_)) {
    BeginSlam();
    Trust();
  }
}

/// From where the robot is now.
void SlamMapper::BeginSlam() {
  slam_ = std::make_unique<Slam>(parameters_.slam, parameters_.seed,
                                 map_from_guarded_ * guarded_odometry_);
  localizer_.reset();
  kept_.clear();
  revision_ = slam_->revision();
}

void SlamMapper::LocalizeFrom(const Pose2D& pose) {
  // In a map that stands still odometry's pull does not add up.
  MotionModelParameters motion = parameters_.slam.motion;
  motion.srr = std::min(motion.srr, MotionModelParameters().srr);
  motion.linear_floor = MotionModelParameters().linear_floor;
  localizer_ = std::make_unique<Localizer>(parameters_.localizer, matcher_,
                                           motion, grid_.grid(), pose);
  localized_odometry_ = guarded_odometry_;
  localized_at_.reset();
  slam_.reset();
  kept_.clear();
}

MapChange SlamMapper::AddScan(const LaserScan& scan,
                              const Pose2D& base_from_laser,
                              const Pose2D& odom_from_base) {
  Locate(scan, base_from_laser, odom_from_base);
  return Enter();
}

void SlamMapper::Locate(const LaserScan& scan, const Pose2D& base_from_laser,
                        const Pose2D& odom_from_base) {
  odometry_ = odom_from_base;
  guarded_odometry_ = guard_.Add(scan.stamp, odom_from_base);
  newest_ = {WithoutMovers(scan, guarded_odometry_ * base_from_laser),
             base_from_laser};
  localization_.odometry_jumps = guard_.jumps();
  if (!has_begun_) {
    map_from_guarded_ = start_ * guarded_odometry_.Inverse();
    localized_odometry_ = guarded_odometry_;
    has_begun_ = true;
  }
  pose_ = Localize();
  map_from_guarded_ = pose_ * guarded_odometry_.Inverse();
  map_from_odom_ = pose_ * odom_from_base.Inverse();
}

MapChange SlamMapper::Enter() {
  if (IsToRebuild()) return Rebuild();
  if (localization_.is_lost) return {};
  if (IsDoubtful()) {
    Doubt();
    return {};
  }
  doubts_ = 0;
  return grid_.AddScan(newest_.scan, pose_ * newest_.base_from_laser);
}

/// The scan without what moves, unless nothing else is in it.
LaserScan SlamMapper::WithoutMovers(const LaserScan& scan,
                                    const Pose2D& odom_from_laser) {
  tracker_.AddScan(scan, odom_from_laser);
  LaserScan still = tracker_.Without(scan);
  return DescribeDefect(still) ? scan : still;
}

/// The base's pose in the map.
Pose2D SlamMapper::Localize() {
  if (slam_) {
    // The robot may have moved since.
    if (kept_.empty()) BeginSlam();
    if (slam_->AddScan(newest_.scan, newest_.base_from_laser,
                       guarded_odometry_)) {
      kept_.push_back(newest_);
    }
    return slam_->PoseAt(guarded_odometry_);
  }
  if (!localizer_) return map_from_guarded_ * guarded_odometry_;
  FollowInMap();
  return localizer_->pose() *
         (localized_odometry_.Inverse() * guarded_odometry_);
}

void SlamMapper::FollowInMap() {
  const auto& [scan, base_from_laser] = newest_;
  const Pose2D motion = localized_odometry_.Inverse() * guarded_odometry_;
  if (localization_.is_lost) {
    if (localized_at_ && scan.stamp - *localized_at_ < kSearchPeriod) return;
    localization_.is_lost =
        !localizer_->FindAgain(matcher_.Shape(scan, base_from_laser).probes,
                               base_from_laser.position(), motion);
  } else {
    const bool is_due =
        motion.position().norm() >= parameters_.slam.linear_update ||
        std::abs(motion.theta) >= parameters_.slam.angular_update ||
        std::abs(scan.stamp - localized_at_.value_or(0.0)) >=
            parameters_.slam.temporal_update;
    if (localized_at_ && !is_due) return;
    localizer_->AddScan(matcher_.Shape(scan, base_from_laser), motion);
  }
  localized_odometry_ = guarded_odometry_;
  localized_at_ = scan.stamp;
}

/// True when the newest scan contradicts the map.
bool SlamMapper::IsDoubtful() {
  if (!slam_ && !localizer_) return false;
  const auto& [scan, base_from_laser] = newest_;
  const MapAgreement agreement =
      CompareWithMap(grid_.grid(), matcher_.Shape(scan, base_from_laser).probes,
                     base_from_laser.position(), pose_, ReachOf(grid_.grid()));
  localization_.agreement = agreement;
  return agreement.known >= kFewestKnown &&
         agreement.near_share() < parameters_.lost_near_share &&
         agreement.pierced_share() > parameters_.lost_pierced_share;
}

void SlamMapper::Doubt() {
  const double stamp = newest_.scan.stamp;
  if (doubts_ == 0) doubted_since_ = stamp;
  ++doubts_;
  if (doubts_ < kFewestDoubts || stamp - doubted_since_ < kPatience) return;
  localization_.is_lost = true;
  // What the last scans were matched with may hold them at wrong places.
  LocalizeFrom(pose_);
}

void SlamMapper::Trust() {
  localization_.is_lost = false;
  doubts_ = 0;
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
