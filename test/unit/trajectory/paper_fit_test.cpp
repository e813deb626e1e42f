#include "vfh_astar/trajectory/paper_fit.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace vfh_astar {
namespace {

TEST(PaperFit, TakesTimeByLengthAndReachesTheEnd) {
  const Trajectory trajectory =
      FitSingleQuintic({{1, 2}, {4, 6}}, Eigen::Vector2d::Zero(), 1.5);
  ASSERT_EQ(trajectory.pieces().size(), 1u);
  EXPECT_DOUBLE_EQ(trajectory.duration(), 7.5);
  const Reference start = trajectory.Sample(0.0);
  const Reference end = trajectory.Sample(7.5);
  EXPECT_NEAR((start.pose.position() - Eigen::Vector2d(1, 2)).norm(), 0, 1e-3);
  EXPECT_NEAR((end.pose.position() - Eigen::Vector2d(4, 6)).norm(), 0, 1e-3);
  EXPECT_NEAR(end.twist.v, 0.0, 2e-3);
}

TEST(PaperFit, KeepsTheStartsVelocity) {
  const Trajectory trajectory =
      FitSingleQuintic({{0, 0}, {5, 0}}, {0.8, 0.1}, 1.0);
  const Reference start = trajectory.Sample(0.0);
  EXPECT_NEAR(start.twist.v, std::hypot(0.8, 0.1), 2e-3);
  EXPECT_NEAR(start.pose.theta, std::atan2(0.1, 0.8), 2e-3);
}

const Polyline kHairpin = {{0, 0}, {20, 0}, {20, 2}, {0, 2}, {0, 4}, {20, 4}};

// What the fit minimises, as its header says it.
double Cost(const TrajectoryPiece& piece, const Polyline& vias) {
  const int n = static_cast<int>(vias.size());
  const double step = piece.duration / (n - 1);
  double cost = 0.0;
  for (int k = 0; k < n; ++k) {
    const bool is_end = k == 0 || k == n - 1;
    const double tau = static_cast<double>(k) / (n - 1);
    const Jet x = Evaluate(piece.x, piece.duration, tau);
    const Jet y = Evaluate(piece.y, piece.duration, tau);
    Eigen::Vector2d speed = Eigen::Vector2d::Zero();
    if (!is_end) speed = (vias[k + 1] - vias[k - 1]) / (2.0 * step);
    const double weight = is_end ? 1e6 : 1.0;
    cost +=
        weight * (Eigen::Vector2d(x.value, y.value) - vias[k]).squaredNorm();
    cost += weight * (Eigen::Vector2d(x.first, y.first) - speed).squaredNorm();
  }
  return cost;
}

// Also when it takes more than a minute: raw powers of t would be lost in
// rounding.
TEST(PaperFit, NoOtherQuinticFitsBetter) {
  const Trajectory fitted =
      FitSingleQuintic(kHairpin, Eigen::Vector2d::Zero(), 1.5);
  EXPECT_DOUBLE_EQ(fitted.duration(), 96.0);
  const Polyline vias = Resample(kHairpin, 641);
  const TrajectoryPiece best = fitted.pieces().front();
  const double least = Cost(best, vias);
  for (int i = 0; i < 6; ++i) {
    for (const double change : {-1e-3, 1e-3}) {
      TrajectoryPiece other = best;
      other.x[i] += change;
      EXPECT_GT(Cost(other, vias), least);
      other = best;
      other.y[i] += change;
      EXPECT_GT(Cost(other, vias), least);
    }
  }
}

// Why it is not the default.
TEST(PaperFit, CutsThroughAHairpin) {
  const Trajectory trajectory =
      FitSingleQuintic(kHairpin, Eigen::Vector2d::Zero(), 1.0);
  const Polyline path = Resample(kHairpin, 641);
  double farthest = 0.0;
  for (double t = 0.0; t < trajectory.duration(); t += 0.1) {
    const Eigen::Vector2d place = trajectory.Sample(t).pose.position();
    double nearest = 1e9;
    for (const Eigen::Vector2d& point : path) {
      nearest = std::min(nearest, (point - place).norm());
    }
    farthest = std::max(farthest, nearest);
  }
  EXPECT_GT(farthest, 0.5);
}

}  // namespace
}  // namespace vfh_astar
