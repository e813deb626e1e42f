#include "benchmark/trajectory_error.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vfh_astar {
namespace {

TEST(TrajectoryError, AlignmentTakesARigidMotionAway) {
  const std::vector<Pose2D> reference = {
      {0, 0, 0}, {4, 0, 0}, {4, 3, 0}, {-1, 2, 0}};
  const Pose2D moved(5.0, -2.0, 2.5);
  std::vector<Pose2D> trajectory;
  for (const Pose2D& pose : reference) trajectory.push_back(moved * pose);
  EXPECT_NEAR(AlignedError(trajectory, reference), 0.0, 1e-6);
}

TEST(TrajectoryError, AlignmentKeepsTheShapesDifference) {
  // A bar of length 2 against one of length 4: each end is 1 m off.
  EXPECT_NEAR(AlignedError({{-1, 0, 0}, {1, 0, 0}}, {{0, -2, 0}, {0, 2, 0}}),
              1.0, 1e-9);
  // The same scale is not taken for a mirror image.
  const std::vector<Pose2D> left = {{0, 0, 0}, {2, 0, 0}, {0, 1, 0}};
  const std::vector<Pose2D> right = {{0, 0, 0}, {2, 0, 0}, {0, -1, 0}};
  EXPECT_GT(AlignedError(left, right), 0.3);
}

TEST(TrajectoryError, RelationsAreComparedInTheirOwnFrame) {
  // Straight on by 1 m against 1.1 m, then a turn of 0.5 against 0.4 rad.
  const std::vector<Pose2D> reference = {{0, 0, 1},
                                         Pose2D(0, 0, 1) * Pose2D(1.0, 0, 0.5),
                                         Pose2D(0, 0, 1) * Pose2D(1.0, 0, 0.5)};
  const std::vector<Pose2D> trajectory = {
      {7, 7, -2},
      Pose2D(7, 7, -2) * Pose2D(1.1, 0, 0.4),
      Pose2D(7, 7, -2) * Pose2D(1.1, 0, 0.4)};
  const RelationErrors errors =
      CompareRelations(trajectory, ConsecutiveRelations(reference));
  EXPECT_NEAR(errors.translation_mean, 0.05, 1e-9);
  EXPECT_NEAR(errors.translation_std, 0.05, 1e-9);
  EXPECT_NEAR(errors.rotation_mean, 0.05, 1e-9);
}

}  // namespace
}  // namespace vfh_astar
