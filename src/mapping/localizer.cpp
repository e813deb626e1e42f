#include "vfh_astar/mapping/localizer.h"

#include <optional>

#include "vfh_astar/mapping/correlative_search.h"
#include "vfh_astar/mapping/map_agreement.h"

namespace vfh_astar {
namespace {

// Of the field's mean at the points, below which a place is not worth a look:
// at the start, and for a robot that is lost.
constexpr double kLeastScore = 0.1;
constexpr double kLeastFoundScore = 0.25;
// What a place loses of its score at the edge of the window.
constexpr double kEdgePenalty = 0.05;
// Fewer hits on the map say nothing.
constexpr int kFewestKnown = 30;

/// The centres of what is more likely occupied than not, m.
std::vector<Eigen::Vector2d> OccupiedPlaces(const LogOddsGrid& map) {
  std::vector<Eigen::Vector2d> places;
  for (int row = 0; row < map.tile_rows(); ++row) {
    for (int column = 0; column < map.tile_columns(); ++column) {
      const LogOddsGrid::Tile* tile = map.FindTile(column, row);
      if (tile == nullptr) continue;
      for (int i = 0; i < static_cast<int>(tile->size()); ++i) {
        if ((*tile)[i] <= kEvenOdds) continue;
        constexpr int kSide = LogOddsGrid::kTileSize;
        places.push_back(map.geometry().ToWorld(
            {column * kSide + i % kSide, row * kSide + i / kSide}));
      }
    }
  }
  return places;
}

HitField FieldOf(const LogOddsGrid& map, const ScanMatcher& matcher) {
  HitField field = matcher.MakeField();
  field.Add(OccupiedPlaces(map), Pose2D());
  return field;
}

/// Nothing known but about where.
PoseBelief RoughBelief(const Pose2D& pose, double distance, double angle) {
  PoseBelief belief{pose, Eigen::Matrix3d::Zero()};
  belief.information.diagonal() =
      Eigen::Vector3d(1.0 / (distance * distance), 1.0 / (distance * distance),
                      1.0 / (angle * angle));
  return belief;
}

}  // namespace

void LocalizerParameters::Read(ParameterReader& reader) {
  reader.Number("start_distance", start_distance, 0.01, 5.0);
  reader.Number("start_angle", start_angle, 0.01, kPi);
  reader.Number("lost_distance", lost_distance, 0.1, 20.0);
  reader.Number("lost_angle", lost_angle, 0.05, kPi);
  reader.Number("found_share", found_share, 0.1, 1.0);
}

Localizer::Localizer(const LocalizerParameters& parameters,
                     const ScanMatcher& matcher,
                     const MotionModelParameters& motion_model,
                     const LogOddsGrid& map, const Pose2D& pose)
    : parameters_(parameters),
      matcher_(matcher),
      motion_model_(motion_model),
      map_(map),
      field_(FieldOf(map, matcher)),
      pose_(pose) {}

void Localizer::AddScan(const ScanShape& shape, const Pose2D& motion) {
  PoseBelief prior{pose_ * motion,
                   MotionInformation(motion_model_, pose_, motion)};
  if (shape.probes.empty()) {
    pose_ = prior.mean;
    return;
  }
  Pose2D start;
  if (is_settled_) {
    start = matcher_.FindCoarse(field_, shape.probes, prior);
  } else {
    prior = RoughBelief(prior.mean, parameters_.start_distance,
                        parameters_.start_angle);
    start = Search(shape.probes, prior.mean, 2.0 * parameters_.start_distance,
                   2.0 * parameters_.start_angle, kLeastScore)
                .value_or(prior.mean);
  }
  pose_ = matcher_.Align(field_, shape.probes, start, prior).belief.mean;
  is_settled_ = true;
  AddUnknown(shape.walls);
}

std::optional<Pose2D> Localizer::Search(
    const std::vector<Eigen::Vector2d>& points, const Pose2D& centre,
    double distance, double angle, double least_score) const {
  SearchWindow window;
  window.linear = distance;
  window.angular = angle;
  window.angular_step = matcher_.parameters().angular_step;
  // Of two places that fit alike (a corridor) the likelier one is taken.
  window.linear_penalty = kEdgePenalty / (distance * distance);
  window.angular_penalty = kEdgePenalty / (angle * angle);
  const std::optional<SearchResult> found =
      SearchPose(field_, points, centre, window, least_score);
  if (!found) return std::nullopt;
  return found->pose;
}

bool Localizer::FindAgain(const std::vector<Eigen::Vector2d>& points,
                          const Eigen::Vector2d& laser, const Pose2D& motion) {
  pose_ = pose_ * motion;
  const std::optional<Pose2D> found =
      Search(points, pose_, parameters_.lost_distance, parameters_.lost_angle,
             kLeastFoundScore);
  if (!found) return false;
  const Pose2D pose = matcher_
                          .Align(field_, points, *found,
                                 RoughBelief(*found, parameters_.start_distance,
                                             parameters_.start_angle))
                          .belief.mean;
  const MapAgreement agreement = CompareWithMap(
      map_, points, laser, pose, 2.0 * map_.geometry().resolution);
  if (agreement.known < kFewestKnown ||
      agreement.near_share() < parameters_.found_share) {
    return false;
  }
  pose_ = pose;
  is_settled_ = true;
  return true;
}

void Localizer::AddUnknown(const std::vector<Eigen::Vector2d>& walls) {
  std::vector<Eigen::Vector2d> unknown;
  for (const Eigen::Vector2d& point : walls) {
    const Cell cell = map_.geometry().ToCell(pose_ * point);
    if (!map_.geometry().Contains(cell) || map_[cell] == kUnexplored) {
      unknown.push_back(point);
    }
  }
  field_.Add(unknown, pose_);
}

}  // namespace vfh_astar
