#include "vfh_astar/control/safety_limiter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace vfh_astar {
namespace {

using Points = std::vector<Eigen::Vector2d>;

SafetyLimiterParameters Parameters() {
  SafetyLimiterParameters parameters;
  parameters.margin = 0.0;
  parameters.reaction_time = 0.1;
  parameters.deceleration = 2.0;
  parameters.angular_deceleration = 10.0;
  return parameters;
}

TEST(SafetyLimiterTest, PassesOnWhatIsSafe) {
  const SafetyLimiter limiter(Parameters(), Footprint());
  const LimitedCommand result = limiter.Limit({2.0, 1.0}, {2.0, 1.0}, {});
  EXPECT_FALSE(result.limited);
  EXPECT_EQ(result.command.v, 2.0);
  EXPECT_EQ(result.command.w, 1.0);
}

TEST(SafetyLimiterTest, TheBrakingDistanceByHand) {
  // From 2 m/s: 0.2 m of reaction and 2^2 / (2 * 2) = 1 m of braking.
  const SafetyLimiter limiter(Parameters(), Footprint());
  const double reach = Footprint().front + 1.2;
  EXPECT_TRUE(limiter.CanStop({2.0, 0.0}, 0.1, {{reach + 0.005, 0.0}}));
  EXPECT_FALSE(limiter.CanStop({2.0, 0.0}, 0.1, {{reach - 0.005, 0.0}}));
  EXPECT_TRUE(limiter.CanStop({2.0, 0.0}, 0.1, {{reach - 0.1, 0.22}}));
}

TEST(SafetyLimiterTest, TheStoppingMotionEndsWhereTheRobotStands) {
  const SafetyLimiter limiter(Parameters(), Footprint());
  const std::vector<Pose2D> ahead = limiter.StoppingMotion({2.0, 0.0});
  ASSERT_EQ(ahead.size(), 13u) << "1.2 m in steps of 0.1 m";
  EXPECT_EQ(ahead.front().x, 0.0);
  EXPECT_NEAR(ahead.back().x, 1.2, 1e-12);
  // Turning: 0.1 s and half of 4 / 10 s, at 4 rad/s.
  const std::vector<Pose2D> turn = limiter.StoppingMotion({0.0, 4.0});
  EXPECT_NEAR(turn.back().theta, 1.2, 1e-12);
  EXPECT_EQ(turn.back().x, 0.0);
  EXPECT_EQ(limiter.StoppingMotion({}).size(), 1u);
}

TEST(SafetyLimiterTest, SlowsToWhatTheDistanceAllows) {
  const SafetyLimiter limiter(Parameters(), Footprint());
  // 0.3 m away: v * 0.1 + v^2 / 4 = 0.3 gives v = 0.9136.
  const LimitedCommand result =
      limiter.Limit({2.0, 0.0}, {0.5, 0.0}, {{Footprint().front + 0.3, 0.0}});
  EXPECT_TRUE(result.limited);
  EXPECT_NEAR(result.command.v, 0.9136, 0.02);
  EXPECT_LE(result.command.v, 0.9137);
}

TEST(SafetyLimiterTest, KeepsTheArcWhileSlowing) {
  const SafetyLimiter limiter(Parameters(), Footprint());
  const LimitedCommand result =
      limiter.Limit({2.0, 0.5}, {0.0, 0.0}, {{0.8, 0.0}});
  ASSERT_TRUE(result.limited);
  ASSERT_GT(result.command.v, 0.1);
  EXPECT_NEAR(result.command.w / result.command.v, 0.25, 1e-9);
}

TEST(SafetyLimiterTest, StopsAtOnceWhenBrakingAloneWouldHit) {
  const SafetyLimiter limiter(Parameters(), Footprint());
  const LimitedCommand result =
      limiter.Limit({0.1, 0.0}, {2.0, 0.0}, {{Footprint().front + 0.5, 0.0}});
  EXPECT_TRUE(result.limited);
  EXPECT_EQ(result.command.v, 0.0);
  EXPECT_EQ(result.command.w, 0.0);
}

TEST(SafetyLimiterTest, TurnsWhereItCannotDriveOn) {
  const SafetyLimiter limiter(Parameters(), Footprint());
  const LimitedCommand result =
      limiter.Limit({0.5, 0.5}, {0.0, 0.0}, {{Footprint().front + 0.001, 0.0}});
  EXPECT_TRUE(result.limited);
  EXPECT_EQ(result.command.v, 0.0);
  EXPECT_GT(result.command.w, 0.1);
}

TEST(SafetyLimiterTest, LetsTheRobotLeaveAnObstacleWithinTheMargin) {
  SafetyLimiterParameters parameters = Parameters();
  parameters.margin = 0.05;
  const SafetyLimiter limiter(parameters, Footprint());
  const Points near = {{Footprint().front + 0.02, 0.0}};
  EXPECT_FALSE(limiter.Limit({-0.3, 0.0}, {0.0, 0.0}, near).limited);
  EXPECT_EQ(limiter.Limit({0.3, 0.0}, {0.0, 0.0}, near).command.v, 0.0);
}

TEST(SafetyLimiterTest, StopsOnWhatIsNoNumber) {
  const SafetyLimiter limiter(Parameters(), Footprint());
  const double nan = std::nan("");
  for (const Twist2D& command : {Twist2D{1.0, nan}, {nan, 0.0}}) {
    const LimitedCommand result = limiter.Limit(command, {}, {{0.5, 0.0}});
    EXPECT_TRUE(result.limited);
    EXPECT_EQ(result.command.v, 0.0);
    EXPECT_EQ(result.command.w, 0.0);
  }
  EXPECT_EQ(limiter.Limit({0.1, 0.0}, {nan, 0.0}, {}).command.v, 0.0);
  EXPECT_EQ(limiter.Limit({0.1, 0.0}, {1e300, 0.0}, {{9.0, 0.0}}).command.v,
            0.0);
}

/// Has the robot do what the limiter assumes at worst: it holds the command for
/// the reaction time, then brakes along its arc. Calls `visit` with the time,
/// the pose then and the speed, as a share of the command's, that led there.
template <typename Visit>
void ActOut(const Twist2D& command, const SafetyLimiterParameters& parameters,
            const Visit& visit) {
  const double braking =
      std::max(std::abs(command.v) / parameters.deceleration,
               std::abs(command.w) / parameters.angular_deceleration);
  constexpr double kStep = 0.004;
  Pose2D pose;
  for (double time = 0.0; time < parameters.reaction_time + braking;
       time += kStep) {
    const double speed =
        braking == 0.0
            ? 0.0
            : std::clamp(1.0 - (time - parameters.reaction_time) / braking, 0.0,
                         1.0);
    pose = Integrate(pose, {speed * command.v, speed * command.w}, kStep);
    visit(time + kStep, pose, speed);
  }
}

/// The least distance on that motion.
double LeastDistance(const Twist2D& command, const Points& points,
                     const SafetyLimiterParameters& parameters) {
  double least = 1e9;
  ActOut(command, parameters, [&](double, const Pose2D& pose, double) {
    for (const Eigen::Vector2d& point : points) {
      least =
          std::min(least, Footprint().SignedDistance(pose.Inverse() * point));
    }
  });
  return least;
}

TEST(SafetyLimiterTest, WhatItPassesOnCanAlwaysStop) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-1.3, 1.3);
  std::uniform_real_distribution<double> speed(-1.0, 2.0);
  std::uniform_real_distribution<double> turn(-4.0, 4.0);
  SafetyLimiterParameters parameters = Parameters();
  parameters.margin = 0.02;
  const Footprint footprint;
  const SafetyLimiter limiter(parameters, footprint);
  int limited = 0;
  constexpr int kRuns = 100000;
  for (int run = 0; run < kRuns; ++run) {
    Points points;
    while (points.size() < 12) {
      const Eigen::Vector2d point(place(random), place(random));
      if (footprint.SignedDistance(point) > 0.0) points.push_back(point);
    }
    double before = 1e9;
    for (const Eigen::Vector2d& point : points) {
      before = std::min(before, footprint.SignedDistance(point));
    }
    const LimitedCommand result =
        limiter.Limit({speed(random), turn(random)}, {0.0, 0.0}, points);
    limited += result.limited ? 1 : 0;
    // Between two checked poses the outline moves 2 cm, which a corner can use
    // to come nearer by less than the margin.
    EXPECT_GT(LeastDistance(result.command, points, parameters),
              std::min(before, parameters.margin) - 0.01)
        << "run " << run;
  }
  EXPECT_GT(limited, kRuns / 10);
  EXPECT_LT(limited, kRuns - kRuns / 20);
}

/// The same for a disc on a straight way: the least distance while the robot is
/// still moving faster than `slow` (m/s).
double LeastDistanceWhileMoving(const Twist2D& command,
                                const MovingObstacle& mover, double slow,
                                const SafetyLimiterParameters& parameters) {
  double least = 1e9;
  ActOut(
      command, parameters, [&](double time, const Pose2D& pose, double speed) {
        if (std::abs(speed * command.v) < slow) return;
        least = std::min(
            least, Footprint().SignedDistance(pose.Inverse() * mover.At(time)) -
                       mover.radius);
      });
  return least;
}

TEST(SafetyLimiterTest, IsSlowWhenAMoverReachesIt) {
  std::mt19937 random(8);
  std::uniform_real_distribution<double> place(-2.5, 2.5);
  std::uniform_real_distribution<double> way(-1.5, 1.5);
  std::uniform_real_distribution<double> speed(-1.0, 2.0);
  std::uniform_real_distribution<double> turn(-4.0, 4.0);
  const SafetyLimiterParameters parameters = Parameters();
  const Footprint footprint;
  const SafetyLimiter limiter(parameters, footprint);
  int limited = 0;
  constexpr int kRuns = 100000;
  for (int run = 0; run < kRuns; ++run) {
    MovingObstacle mover;
    do {
      mover.position = {place(random), place(random)};
      mover.radius = 0.4;
    } while (footprint.SignedDistance(mover.position) < mover.radius);
    mover.velocity = {way(random), way(random)};
    const LimitedCommand result =
        limiter.Limit({speed(random), turn(random)}, {}, {}, {mover});
    limited += result.limited ? 1 : 0;
    // Between two looks robot and mover come nearer by 2 cm at most.
    EXPECT_GT(LeastDistanceWhileMoving(result.command, mover, 0.1, parameters),
              -0.025)
        << "run " << run;
  }
  EXPECT_GT(limited, kRuns / 20);
}

/// CanStop, asked at every step of 2 cm of every point.
bool CanStopAtEveryStep(const Twist2D& command, double hold,
                        const Points& points,
                        const SafetyLimiterParameters& parameters) {
  const Footprint footprint;
  const double braking =
      std::max(std::abs(command.v) / parameters.deceleration,
               std::abs(command.w) / parameters.angular_deceleration);
  const double duration = hold + 0.5 * braking;
  const double speed = std::abs(command.v) +
                       std::abs(command.w) * footprint.CircumscribedRadius();
  const int steps = static_cast<int>(std::ceil(speed * duration / 0.02));
  for (int step = 1; step <= steps; ++step) {
    const Pose2D pose = Integrate(Pose2D(), command, duration * step / steps);
    for (const Eigen::Vector2d& point : points) {
      const double required =
          std::min(parameters.margin, footprint.SignedDistance(point)) - 1e-4;
      if (footprint.SignedDistance(pose.Inverse() * point) < required) {
        return false;
      }
    }
  }
  return true;
}

TEST(SafetyLimiterTest, SkipsNoStepThatMatters) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(-2.0, 2.0);
  std::uniform_real_distribution<double> speed(-2.0, 2.0);
  std::uniform_real_distribution<double> turn(-4.0, 4.0);
  SafetyLimiterParameters parameters = Parameters();
  parameters.margin = 0.05;
  const SafetyLimiter limiter(parameters, Footprint());
  int stoppable = 0;
  constexpr int kRuns = 20000;
  for (int run = 0; run < kRuns; ++run) {
    Points points;
    for (int i = 0; i < 4; ++i) {
      points.emplace_back(place(random), place(random));
    }
    const Twist2D command{speed(random), turn(random)};
    const bool can_stop = limiter.CanStop(command, 0.1, points);
    ASSERT_EQ(can_stop, CanStopAtEveryStep(command, 0.1, points, parameters))
        << "run " << run;
    stoppable += can_stop ? 1 : 0;
  }
  EXPECT_GT(stoppable, kRuns / 10);
  EXPECT_LT(stoppable, kRuns - kRuns / 10);
}

TEST(SafetyLimiterTest, WaitsForACrossingMoverByHand) {
  SafetyLimiterParameters parameters = Parameters();
  parameters.swerve = 0.0;
  const SafetyLimiter limiter(parameters, Footprint());
  // 1 m/s: 0.1 m and 1 / (2 * 2) m in 0.6 s. The disc, 1 m ahead and 1.1 m to
  // the right, is then 0.5 m to the right and beside the way; at twice the
  // speed it lies across it.
  const double ahead = Footprint().front + 0.45;
  EXPECT_TRUE(limiter.CanStopBefore({1.0, 0.0}, 0.1,
                                    {{{ahead, -1.31}, {0.0, 1.0}, 0.3}}));
  EXPECT_FALSE(limiter.CanStopBefore({1.0, 0.0}, 0.1,
                                     {{{ahead, -1.31}, {0.0, 2.0}, 0.3}}));
  // The same one coming from ahead: 0.35 m of its own and 0.6 m of the mover's.
  const double reach = Footprint().front + 0.3 + 0.35 + 0.6;
  EXPECT_TRUE(limiter.CanStopBefore({1.0, 0.0}, 0.1,
                                    {{{reach + 0.01, 0.0}, {-1.0, 0.0}, 0.3}}));
  EXPECT_FALSE(limiter.CanStopBefore(
      {1.0, 0.0}, 0.1, {{{reach - 0.03, 0.0}, {-1.0, 0.0}, 0.3}}));
}

TEST(SafetyLimiterTest, LetsTheRobotFleeFromAMover) {
  const SafetyLimiter limiter(Parameters(), Footprint());
  const MovingObstacle behind{{-1.0, 0.0}, {1.0, 0.0}, 0.5};
  EXPECT_FALSE(limiter.Limit({1.5, 0.0}, {0.0, 0.0}, {}, {behind}).limited);
  EXPECT_TRUE(limiter.Limit({-0.5, 0.0}, {0.0, 0.0}, {}, {behind}).limited);
}

}  // namespace
}  // namespace vfh_astar
