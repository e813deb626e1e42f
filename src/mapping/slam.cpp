#include "vfh_astar/mapping/slam.h"

#include <algorithm>
#include <cmath>

namespace vfh_astar {
namespace {

// A turn on the spot wears odometry out too.
constexpr double kPathPerTurn = 0.3;  // m per rad

// A tie that the poses meet so well needs no new solution.
constexpr double kSettledDistance = 0.02;  // m
constexpr double kSettledAngle = 0.005;    // rad

// Solving costs as much as the graph is long, so it waits for a part of that.
constexpr std::size_t kFewestBetweenSolving = 10;
constexpr std::size_t kPartBetweenSolving = 50;

}  // namespace

void SlamParameters::Read(ParameterReader& reader) {
  reader.Number("linear_update", linear_update, 0.0, 10.0);
  reader.Number("angular_update", angular_update, 0.0, kPi);
  reader.Number("temporal_update", temporal_update, 0.0, 3600.0);
  reader.Flag("loop_closure", loop_closure);
  reader.Group("matcher", matcher);
  motion.Read(reader);
  filter.Read(reader);
}

Slam::Slam(const SlamParameters& parameters, std::uint32_t seed,
           const Pose2D& start)
    : parameters_(parameters),
      matcher_(parameters.matcher),
      filter_(parameters.filter, matcher_, parameters.motion, seed, start),
      loop_closer_(parameters.loops, matcher_) {}

bool Slam::AddScan(const LaserScan& scan, const Pose2D& base_from_laser,
                   const Pose2D& odometry) {
  const Pose2D motion = last_odometry_.Inverse() * odometry;
  if (!nodes_.empty() && !IsDue(motion)) {
    if (std::abs(scan.stamp - matched_at_) >= parameters_.temporal_update) {
      Track(scan, base_from_laser, odometry);
    }
    return false;
  }
  last_odometry_ = odometry;
  matched_at_ = scan.stamp;
  SlamNode node;
  node.shape = matcher_.Shape(scan, base_from_laser);
  if (!nodes_.empty()) {
    node.path = nodes_.back().path + motion.position().norm() +
                kPathPerTurn * std::abs(motion.theta);
  }
  nodes_.push_back(std::move(node));
  filter_.AddScan(nodes_.back().shape, motion);
  if (!parameters_.loop_closure) {
    FollowFilter();
  } else if (nodes_.size() == 1) {
    trajectory_ = {filter_.best().pose()};
  } else {
    ExtendGraph(motion);
    FindLoops();
  }
  return true;
}

bool Slam::IsDue(const Pose2D& motion) const {
  return motion.position().norm() >= parameters_.linear_update ||
         std::abs(motion.theta) >= parameters_.angular_update;
}

void Slam::Track(const LaserScan& scan, const Pose2D& base_from_laser,
                 const Pose2D& odometry) {
  matched_at_ = scan.stamp;
  const Particle& best = filter_.best();
  const Pose2D motion = last_odometry_.Inverse() * odometry;
  const PoseBelief prior{
      best.pose() * motion,
      MotionInformation(parameters_.motion, best.pose(), motion)};
  const Alignment alignment =
      matcher_.Align(best.field, matcher_.Shape(scan, base_from_laser).probes,
                     prior.mean, prior);
  last_odometry_ = odometry * (alignment.belief.mean.Inverse() * best.pose());
}

void Slam::FollowFilter() {
  const std::vector<Pose2D>& followed = filter_.best().trajectory;
  const bool is_same_history =
      std::equal(trajectory_.begin(), trajectory_.end(), followed.begin(),
                 [](const Pose2D& a, const Pose2D& b) {
                   return a.x == b.x && a.y == b.y && a.theta == b.theta;
                 });
  if (!is_same_history) ++revision_;
  trajectory_ = followed;
}

void Slam::ExtendGraph(const Pose2D& motion) {
  const Pose2D& last = trajectory_.back();
  const PoseBelief prior{last * motion,
                         MotionInformation(parameters_.motion, last, motion)};
  // The filter has looked already; its step holds where the graph stands too.
  const std::vector<Pose2D>& followed = filter_.best().trajectory;
  const Pose2D step = followed[followed.size() - 2].Inverse() * followed.back();
  const PoseConstraint tie =
      loop_closer_.TieToPredecessor(nodes_, trajectory_, prior, last * step);
  trajectory_.push_back(last * tie.motion);
  constraints_.push_back(tie);
}

void Slam::FindLoops() {
  const std::optional<PoseConstraint> loop =
      loop_closer_.FindLoop(nodes_, trajectory_, filter_.best().pose());
  if (loop) {
    const Pose2D off = (trajectory_[loop->from] * loop->motion).Inverse() *
                       trajectory_[loop->to];
    is_unsettled_ = is_unsettled_ || off.position().norm() > kSettledDistance ||
                    std::abs(off.theta) > kSettledAngle;
    constraints_.push_back(*loop);
  }
  const std::size_t patience =
      std::max(kFewestBetweenSolving, nodes_.size() / kPartBetweenSolving);
  if (is_unsettled_ && nodes_.size() >= solved_at_ + patience) Solve();
}

void Slam::Solve() {
  trajectory_ = OptimizePoses(trajectory_, constraints_, parameters_.graph);
  HitField field = matcher_.MakeField();
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    field.Add(nodes_[i].shape.walls, trajectory_[i]);
  }
  filter_.Restart(trajectory_, field);
  solved_at_ = nodes_.size();
  is_unsettled_ = false;
  ++revision_;
}

void Slam::Finish() {
  if (parameters_.loop_closure && !constraints_.empty()) Solve();
}

}  // namespace vfh_astar
