#include "vfh_astar/mapping/pose_graph.h"

#include <gtest/gtest.h>

namespace vfh_astar {
namespace {

PoseConstraint Constraint(int from, int to, const Pose2D& motion,
                          double information, bool is_doubtful) {
  return {from, to, motion, information * Eigen::Matrix3d::Identity(),
          is_doubtful};
}

TEST(PoseGraph, WeighsWhatDisagreesByItsInformation) {
  // 1 m by a constraint three times as sure as the one that says 2 m.
  const auto poses = OptimizePoses({{}, {0.5, 0.5, 0.2}},
                                   {Constraint(0, 1, {1, 0, 0}, 3.0, false),
                                    Constraint(0, 1, {2, 0, 0}, 1.0, false)},
                                   {});
  EXPECT_NEAR(poses[0].x, 0.0, 1e-12);
  EXPECT_NEAR(poses[1].x, 1.25, 1e-4);
  EXPECT_NEAR(poses[1].y, 0.0, 1e-4);
  EXPECT_NEAR(poses[1].theta, 0.0, 1e-4);
}

TEST(PoseGraph, ClosesASquareAcrossTheTurnOfTheAngle) {
  const Pose2D side(2.0, 0.0, 0.5 * kPi);
  std::vector<Pose2D> poses(1);
  std::vector<PoseConstraint> constraints;
  for (int i = 0; i < 4; ++i) {
    constraints.push_back(Constraint(i, (i + 1) % 4, side, 1.0, i == 3));
    // The last side ends where the first begins.
    if (i < 3) poses.push_back(poses.back() * Pose2D(2.2, 0.1, 1.45));
  }
  poses = OptimizePoses(poses, constraints, {});
  EXPECT_NEAR(poses[1].x, 2.0, 1e-3);
  EXPECT_NEAR(poses[2].y, 2.0, 1e-3);
  EXPECT_NEAR(poses[3].x, 0.0, 1e-3);
  EXPECT_NEAR(poses[3].y, 2.0, 1e-3);
}

TEST(PoseGraph, AFalseLoopBarelyPulls) {
  std::vector<Pose2D> poses(1);
  std::vector<PoseConstraint> constraints;
  for (int i = 0; i < 10; ++i) {
    constraints.push_back(Constraint(i, i + 1, {1, 0, 0}, 1e4, false));
    poses.push_back(poses.back() * Pose2D(1, 0, 0));
  }
  constraints.push_back(Constraint(0, 10, {3, 0, 0}, 1e4, true));
  poses = OptimizePoses(poses, constraints, {});
  EXPECT_NEAR(poses[10].x, 10.0, 0.05);
}

TEST(PoseGraph, InformationIsTurnedIntoTheFrame) {
  Eigen::Matrix3d information = Eigen::Vector3d(4, 1, 9).asDiagonal();
  // A pose that looks along y: what is sure along x is sure to its right.
  const Eigen::Matrix3d turned = InFrameOf({0, 0, 0.5 * kPi}, information);
  EXPECT_NEAR(turned(0, 0), 1.0, 1e-9);
  EXPECT_NEAR(turned(1, 1), 4.0, 1e-9);
  EXPECT_NEAR(turned(2, 2), 9.0, 1e-9);
}

}  // namespace
}  // namespace vfh_astar
