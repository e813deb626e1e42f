#include "benchmark/trajectory_error.h"

#include <cassert>
#include <cmath>

namespace vfh_astar {
namespace {

Eigen::Vector2d Centroid(const std::vector<Pose2D>& poses) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (const Pose2D& pose : poses) sum += pose.position();
  return sum / static_cast<double>(poses.size());
}

}  // namespace

std::vector<PoseRelation> ConsecutiveRelations(
    const std::vector<Pose2D>& trajectory) {
  std::vector<PoseRelation> relations;
  for (std::size_t i = 1; i < trajectory.size(); ++i) {
    relations.push_back(
        {i - 1, i, trajectory[i - 1].Inverse() * trajectory[i]});
  }
  return relations;
}

RelationErrors CompareRelations(const std::vector<Pose2D>& trajectory,
                                const std::vector<PoseRelation>& relations) {
  assert(!relations.empty());
  RelationErrors errors;
  double squares = 0.0;
  for (const PoseRelation& relation : relations) {
    const Pose2D motion =
        trajectory[relation.from].Inverse() * trajectory[relation.to];
    const Pose2D difference = relation.motion.Inverse() * motion;
    const double distance = difference.position().norm();
    errors.translation_mean += distance;
    squares += distance * distance;
    errors.rotation_mean += std::abs(difference.theta);
  }
  const double count = static_cast<double>(relations.size());
  errors.translation_mean /= count;
  errors.rotation_mean /= count;
  errors.translation_std =
      std::sqrt(std::max(0.0, squares / count - errors.translation_mean *
                                                    errors.translation_mean));
  return errors;
}

double AlignedError(const std::vector<Pose2D>& trajectory,
                    const std::vector<Pose2D>& reference) {
  assert(!trajectory.empty() && trajectory.size() == reference.size());
  const Eigen::Vector2d from = Centroid(trajectory);
  const Eigen::Vector2d to = Centroid(reference);
  // In the plane the best turn is the angle of the sum of all products, taken
  // as complex numbers.
  double along = 0.0;
  double across = 0.0;
  double squares = 0.0;
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    const Eigen::Vector2d a = trajectory[i].position() - from;
    const Eigen::Vector2d b = reference[i].position() - to;
    along += a.dot(b);
    across += a.x() * b.y() - a.y() * b.x();
    squares += a.squaredNorm() + b.squaredNorm();
  }
  const double rest = squares - 2.0 * std::hypot(along, across);
  return std::sqrt(std::max(0.0, rest) /
                   static_cast<double>(trajectory.size()));
}

}  // namespace vfh_astar
