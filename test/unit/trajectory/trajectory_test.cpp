#include "vfh_astar/trajectory/trajectory.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vfh_astar {
namespace {

using Kind = TrajectoryPiece::Kind;

TrajectoryPiece Piece(Kind kind, double duration, const Jet& x0, const Jet& x1,
                      const Jet& y0, const Jet& y1) {
  TrajectoryPiece piece;
  piece.kind = kind;
  piece.duration = duration;
  piece.x = HermiteQuintic(x0, x1, duration);
  piece.y = HermiteQuintic(y0, y1, duration);
  return piece;
}

// 1 m along y from rest to rest in 2 s.
TrajectoryPiece RestToRest(Kind kind, double y0, double y1) {
  return Piece(kind, 2.0, {3, 0, 0, 0}, {3, 0, 0, 0}, {y0, 0, 0, 0},
               {y1, 0, 0, 0});
}

TEST(Trajectory, SamplesForward) {
  const Trajectory trajectory({RestToRest(Kind::kForward, 0.0, 1.0)});
  EXPECT_DOUBLE_EQ(trajectory.duration(), 2.0);
  const Reference middle = trajectory.Sample(1.0);
  EXPECT_NEAR(middle.pose.x, 3.0, 1e-12);
  EXPECT_NEAR(middle.pose.y, 0.5, 1e-12);
  EXPECT_NEAR(middle.pose.theta, kPi / 2, 1e-12);
  EXPECT_NEAR(middle.twist.v, 15.0 / 16.0, 1e-12);
  EXPECT_NEAR(middle.twist.w, 0.0, 1e-12);
  EXPECT_NEAR(middle.acceleration, 0.0, 1e-12);
  EXPECT_GT(trajectory.Sample(0.5).acceleration, 0.5);
  EXPECT_LT(trajectory.Sample(1.5).acceleration, -0.5);
}

TEST(Trajectory, SamplesReverse) {
  const Trajectory trajectory({RestToRest(Kind::kReverse, 0.0, -1.0)});
  const Reference early = trajectory.Sample(0.5);
  EXPECT_NEAR(early.pose.theta, kPi / 2, 1e-12);
  EXPECT_LT(early.twist.v, -0.1);
  EXPECT_LT(early.acceleration, -0.5);
}

TEST(Trajectory, HeadingAtRestIsItsLimit) {
  const Trajectory forward({RestToRest(Kind::kForward, 0.0, 1.0)});
  const Trajectory reverse({RestToRest(Kind::kReverse, 0.0, -1.0)});
  for (const Trajectory& trajectory : {forward, reverse}) {
    for (const double t : {0.0, 1e-9, 2.0 - 1e-9, 2.0}) {
      const Reference reference = trajectory.Sample(t);
      EXPECT_NEAR(reference.pose.theta, kPi / 2, 1e-6) << t;
      EXPECT_NEAR(reference.twist.w, 0.0, 1e-6) << t;
    }
  }
}

TEST(Trajectory, AccelerationAtRestIsItsLimit) {
  // 2 m/s^2 from rest to 2 m/s in 1 s.
  const Trajectory trajectory(
      {Piece(Kind::kForward, 1.0, {0, 0, 2, 0}, {1, 2, 2, 0}, {0, 0, 0, 0},
             {0, 0, 0, 0})});
  EXPECT_NEAR(trajectory.Sample(0.0).acceleration, 2.0, 1e-9);
  EXPECT_NEAR(trajectory.Sample(0.0).pose.theta, 0.0, 1e-9);
}

TEST(Trajectory, BeforeAndAfterItRests) {
  const Trajectory trajectory({RestToRest(Kind::kForward, 0.0, 1.0)});
  EXPECT_NEAR(trajectory.Sample(-1.0).pose.y, 0.0, 1e-12);
  EXPECT_NEAR(trajectory.Sample(9.0).pose.y, 1.0, 1e-12);
  EXPECT_EQ(trajectory.Sample(9.0).twist.v, 0.0);
  EXPECT_EQ(trajectory.Sample(-1.0).acceleration, 0.0);
}

TEST(Trajectory, FeedForwardIsTheDerivativeOfThePose) {
  const Trajectory trajectory(
      {Piece(Kind::kForward, 1.5, {0, 1.2, 0.3, 0}, {1.2, 0.5, -0.4, 0},
             {0, 0.1, 0.8, 0}, {1.0, 1.1, -0.2, 0})});
  const double h = 1e-6;
  for (double t = 0.01; t < 1.49; t += 0.02) {
    const Reference at = trajectory.Sample(t);
    const Reference before = trajectory.Sample(t - h);
    const Reference after = trajectory.Sample(t + h);
    const Eigen::Vector2d step = after.pose.position() - before.pose.position();
    EXPECT_NEAR(at.twist.v, step.norm() / (2 * h), 1e-6);
    EXPECT_NEAR(at.twist.w,
                NormalizeAngle(after.pose.theta - before.pose.theta) / (2 * h),
                1e-5);
    EXPECT_NEAR(at.acceleration, (after.twist.v - before.twist.v) / (2 * h),
                1e-5);
  }
}

TEST(Trajectory, TurnsOnTheSpot) {
  TrajectoryPiece turn;
  turn.kind = Kind::kTurn;
  turn.duration = 2.0;
  turn.x[0] = 1.0;
  turn.y[0] = -1.0;
  turn.heading = HermiteQuintic({3.0, 0, 0, 0}, {4.0, 0, 0, 0}, 2.0);
  const Trajectory trajectory({turn});
  const Reference middle = trajectory.Sample(1.0);
  EXPECT_NEAR(middle.pose.theta, NormalizeAngle(3.5), 1e-12);
  EXPECT_NEAR(middle.twist.w, 15.0 / 16.0, 1e-12);
  EXPECT_EQ(middle.twist.v, 0.0);
  EXPECT_EQ(trajectory.Length(2.0), 0.0);
}

TEST(Trajectory, LengthAndItsInverse) {
  TrajectoryPiece turn;
  turn.kind = Kind::kTurn;
  turn.duration = 3.0;
  turn.x[0] = 3.0;
  turn.y[0] = 1.0;
  turn.heading = HermiteQuintic({kPi / 2, 0, 0, 0}, {1.0, 0, 0, 0}, 3.0);
  const Trajectory trajectory({RestToRest(Kind::kForward, 0.0, 1.0), turn,
                               RestToRest(Kind::kReverse, 1.0, 0.0)});
  EXPECT_NEAR(trajectory.Length(1.0), 0.5, 1e-9);
  EXPECT_NEAR(trajectory.Length(2.0), 1.0, 1e-9);
  EXPECT_NEAR(trajectory.Length(4.0), 1.0, 1e-9);
  EXPECT_NEAR(trajectory.Length(6.0), 1.5, 1e-9);
  EXPECT_NEAR(trajectory.Length(99.0), 2.0, 1e-9);
  EXPECT_NEAR(trajectory.TimeAtLength(0.5), 1.0, 1e-5);
  EXPECT_NEAR(trajectory.TimeAtLength(1.0 + 1e-9), 5.0, 0.02);
  EXPECT_EQ(trajectory.TimeAtLength(3.0), 7.0);
  for (double length = 0.0; length < 2.0; length += 0.01) {
    const double reached = trajectory.Length(trajectory.TimeAtLength(length));
    EXPECT_LE(reached, length + 1e-12);
    EXPECT_NEAR(reached, length, 2e-6);
  }
}

}  // namespace
}  // namespace vfh_astar
