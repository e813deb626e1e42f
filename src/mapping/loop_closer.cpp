#include "vfh_astar/mapping/loop_closer.h"

#include <algorithm>
#include <cmath>

#include "vfh_astar/mapping/correlative_search.h"

namespace vfh_astar {
namespace {

// The wide search is dear, and neighbouring scans find the same.
constexpr int kFarEvery = 3;                // scans
constexpr double kFarPath = 5.0;            // m of path since the last loop
constexpr double kFarAngle = 0.3;           // rad
constexpr double kAgreeingDistance = 0.25;  // m, of two wide searches
constexpr double kAgreeingAngle = 0.05;     // rad
constexpr int kFarSubmap = 10;              // scans to both sides of an old one
constexpr int kFarScans = 8;                // newest ones, taken together
constexpr std::size_t kFarPoints = 400;
constexpr double kSlack = 0.5;  // m, of the wide search at least
constexpr int kFewestNear = 3;  // old scans, to match against

// What a candidate loses at the edge of its window. Far off a corridor fits
// onto many others, so that what asks for a large drift has to fit the better.
constexpr double kNearPenalty = 0.02;
constexpr double kFarPenalty = 0.15;

/// The newest scans as one, in the frame of the newest.
std::vector<Eigen::Vector2d> NewestPoints(const std::vector<SlamNode>& nodes,
                                          const std::vector<Pose2D>& poses) {
  std::vector<Eigen::Vector2d> all;
  const std::size_t count = nodes.size();
  for (std::size_t i = count > kFarScans ? count - 1 - kFarScans : 0; i < count;
       ++i) {
    const Pose2D relative = poses.back().Inverse() * poses[i];
    for (const Eigen::Vector2d& point : nodes[i].shape.probes) {
      all.push_back(relative * point);
    }
  }
  if (all.size() <= kFarPoints) return all;
  std::vector<Eigen::Vector2d> chosen;
  for (std::size_t i = 0; i < kFarPoints; ++i) {
    chosen.push_back(all[i * all.size() / kFarPoints]);
  }
  return chosen;
}

}  // namespace

PoseConstraint LoopCloser::TieToPredecessor(const std::vector<SlamNode>& nodes,
                                            const std::vector<Pose2D>& poses,
                                            const PoseBelief& prior,
                                            const Pose2D& start) const {
  const int newest = static_cast<int>(nodes.size()) - 1;
  HitField field = matcher_.MakeField();
  for (int i = std::max(0, newest - parameters_.recent_scans); i < newest;
       ++i) {
    field.Add(nodes[i].shape.walls, poses[i]);
  }
  const Alignment alignment =
      matcher_.Align(field, nodes[newest].shape.probes, start, prior);
  const Pose2D& from = poses[newest - 1];
  return {newest - 1, newest, from.Inverse() * alignment.belief.mean,
          InFrameOf(from, alignment.belief.information), false};
}

std::optional<PoseConstraint> LoopCloser::FindLoop(
    const std::vector<SlamNode>& nodes, const std::vector<Pose2D>& poses,
    const Pose2D& guess) {
  const double since = nodes.back().path - last_loop_path_;
  std::optional<PoseConstraint> found;
  if (since < parameters_.near_path) found = FindNear(nodes, poses, guess);
  if (!found && since >= kFarPath && nodes.size() % kFarEvery == 0) {
    found = Confirm(FindFar(nodes, poses, guess, since), poses);
  }
  if (found) last_loop_path_ = nodes.back().path;
  return found;
}

std::optional<PoseConstraint> LoopCloser::Confirm(
    const std::optional<PoseConstraint>& found,
    const std::vector<Pose2D>& poses) {
  std::optional<PoseConstraint> earlier = found;
  std::swap(earlier, unconfirmed_);
  if (!found || !earlier) return std::nullopt;
  const Pose2D here = poses[found->from] * found->motion;
  const Pose2D expected = poses[earlier->from] * earlier->motion *
                          (poses[earlier->to].Inverse() * poses[found->to]);
  const Pose2D off = expected.Inverse() * here;
  if (off.position().norm() > kAgreeingDistance ||
      std::abs(off.theta) > kAgreeingAngle) {
    return std::nullopt;
  }
  unconfirmed_.reset();
  return found;
}

bool LoopCloser::IsOld(const std::vector<SlamNode>& nodes, int index) const {
  return index + parameters_.gap_scans < static_cast<int>(nodes.size()) - 1 &&
         nodes.back().path - nodes[index].path > parameters_.gap_distance;
}

std::optional<PoseConstraint> LoopCloser::FindNear(
    const std::vector<SlamNode>& nodes, const std::vector<Pose2D>& poses,
    const Pose2D& guess) const {
  struct Neighbour {
    double distance;
    int index;
  };
  std::vector<Neighbour> neighbours;
  for (int i = 0; IsOld(nodes, i); ++i) {
    const double distance = (poses[i].position() - guess.position()).norm();
    if (distance > parameters_.near_radius) continue;
    // Scans taken the same way see the same.
    constexpr double kTurnDistance = 2.0;  // m per rad
    neighbours.push_back(
        {distance + kTurnDistance *
                        std::abs(NormalizeAngle(poses[i].theta - guess.theta)),
         i});
  }
  if (static_cast<int>(neighbours.size()) < kFewestNear) return std::nullopt;
  const std::size_t count =
      std::min<std::size_t>(neighbours.size(), parameters_.near_scans);
  std::partial_sort(neighbours.begin(), neighbours.begin() + count,
                    neighbours.end(),
                    [](const Neighbour& a, const Neighbour& b) {
                      return a.distance < b.distance ||
                             (a.distance == b.distance && a.index < b.index);
                    });
  HitField field = matcher_.MakeField();
  for (std::size_t i = 0; i < count; ++i) {
    const int index = neighbours[i].index;
    field.Add(nodes[index].shape.walls, poses[index]);
  }
  return Match(field, nodes.back().shape.probes, guess,
               {parameters_.near_window, parameters_.near_angle, kNearPenalty,
                parameters_.near_fit},
               neighbours.front().index, poses);
}

std::optional<PoseConstraint> LoopCloser::FindFar(
    const std::vector<SlamNode>& nodes, const std::vector<Pose2D>& poses,
    const Pose2D& guess, double path_since_loop) const {
  const double window = std::min(kSlack + parameters_.drift * path_since_loop,
                                 parameters_.widest_window);
  constexpr double kSight = 2.0;  // m that two scans of one place lie apart
  double nearest = window + kSight;
  int anchor = -1;
  for (int i = 0; IsOld(nodes, i); ++i) {
    const double distance = (poses[i].position() - guess.position()).norm();
    if (distance >= nearest) continue;
    nearest = distance;
    anchor = i;
  }
  if (anchor < 0) return std::nullopt;
  HitField field = matcher_.MakeField();
  for (int i = std::max(0, anchor - kFarSubmap);
       i <= anchor + kFarSubmap && IsOld(nodes, i); ++i) {
    field.Add(nodes[i].shape.walls, poses[i]);
  }
  return Match(field, NewestPoints(nodes, poses), guess,
               {window, kFarAngle, kFarPenalty, parameters_.far_fit}, anchor,
               poses);
}

std::optional<PoseConstraint> LoopCloser::Match(
    const HitField& field, const std::vector<Eigen::Vector2d>& points,
    const Pose2D& guess, const Window& window, int anchor,
    const std::vector<Pose2D>& poses) const {
  SearchWindow search;
  search.linear = window.linear;
  search.angular = window.angular;
  search.angular_step = matcher_.parameters().angular_step;
  search.linear_penalty = window.penalty / (window.linear * window.linear);
  search.angular_penalty = window.penalty / (window.angular * window.angular);
  // Aligned below the cell the fit becomes better than the score.
  const double least_score = 0.8 * window.least_fit;
  const std::optional<SearchResult> found =
      SearchPose(field, points, guess, search, least_score);
  if (!found) return std::nullopt;
  const Alignment alignment =
      matcher_.Align(field, points, found->pose,
                     PoseBelief{found->pose, Eigen::Matrix3d::Zero()});
  if (alignment.fit - (found->score - found->value) < window.least_fit)
    return std::nullopt;
  const Pose2D& from = poses[anchor];
  return PoseConstraint{
      anchor, static_cast<int>(poses.size()) - 1,
      from.Inverse() * alignment.belief.mean,
      InFrameOf(from, parameters_.loop_weight * alignment.scan_information),
      true};
}

}  // namespace vfh_astar
