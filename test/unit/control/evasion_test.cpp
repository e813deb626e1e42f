#include "vfh_astar/control/evasion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "vfh_astar/control/command_shaping.h"
#include "vfh_astar/control/safety_limiter.h"

namespace vfh_astar {
namespace {

EvasionScene Scene(const Twist2D& twist,
                   const std::vector<MovingObstacle>& movers) {
  EvasionScene scene;
  scene.twist = twist;
  scene.target = {4.0, 0.0};
  scene.movers = movers;
  return scene;
}

class EvasionTest : public testing::Test {
 protected:
  /// Drives for a while among movers that do not yield, with the limiter last.
  /// @return m of the least distance to one; negative in contact.
  double Drive(EvasionScene scene, double duration) {
    Pose2D pose;
    const Pose2D start;
    const Eigen::Vector2d target = scene.target;
    const std::vector<MovingObstacle> movers = scene.movers;
    double least = 1e9;
    for (double time = 0.0; time < duration; time += 0.025) {
      scene.target = pose.Inverse() * target;
      for (std::size_t i = 0; i < movers.size(); ++i) {
        MovingObstacle mover = movers[i];
        mover.position = mover.At(time);
        scene.movers[i] = Transform(pose.Inverse(), mover);
        least = std::min(
            least,
            footprint_.SignedDistance(scene.movers[i].position) - mover.radius);
      }
      scene.is_allowed = [&](const Twist2D& command) {
        return limiter_.IsSafe(
            LimitAcceleration(command, scene.twist, limits_, 0.025), {},
            scene.movers);
      };
      const Twist2D command = LimitAcceleration(evasion_.Update(scene).command,
                                                scene.twist, limits_, 0.025);
      scene.twist =
          limiter_.Limit(command, scene.twist, {}, scene.movers).command;
      pose = Integrate(pose, scene.twist, 0.025);
    }
    end_ = pose;
    return least;
  }

  Footprint footprint_;
  RobotLimits limits_ = RobotLimits::ForCommands();
  Evasion evasion_{EvasionParameters(), footprint_, limits_};
  SafetyLimiter limiter_{SafetyLimiterParameters(), footprint_};
  Pose2D end_;
};

TEST_F(EvasionTest, DrivesStraightToTheTargetWhereNothingIsInTheWay) {
  const EvasionResult result =
      evasion_.Update(Scene({1.0, 0.0}, {{{0.0, 5.0}, {0.0, 1.0}, 0.5}}));
  EXPECT_GT(result.command.v, 1.0);
  EXPECT_NEAR(result.command.w, 0.0, 1e-9);
  EXPECT_TRUE(std::isinf(result.contact_time));
}

TEST_F(EvasionTest, LetsACrossingMoverPass) {
  EXPECT_GT(Drive(Scene({1.0, 0.0}, {{{2.0, -2.0}, {0.0, 1.0}, 0.5}}), 7.0),
            0.1);
  EXPECT_LT((end_.position() - Eigen::Vector2d(4.0, 0.0)).norm(), 1.0);
}

TEST_F(EvasionTest, YieldsToWhatComesTowardsAStandingRobot) {
  EXPECT_GT(Drive(Scene({0.0, 0.0}, {{{3.5, 0.2}, {-1.2, 0.0}, 0.5}}), 3.5),
            0.05);
  EXPECT_GT(Drive(Scene({0.0, 0.0}, {{{0.0, 3.5}, {0.0, -1.2}, 0.5}}), 3.5),
            0.05);
}

TEST_F(EvasionTest, DoesNotDriveIntoWhatStands) {
  EvasionScene scene = Scene({0.0, 0.0}, {{{3.0, -0.5}, {-1.2, 0.0}, 0.5}});
  // A wall to the left of the robot, 0.5 m away.
  scene.room = [](const Eigen::Vector2d& point) { return 0.5 - point.y(); };
  const EvasionResult result = evasion_.Update(scene);
  EXPECT_LT(std::sin(result.direction) * result.command.v, 0.3);
}

TEST_F(EvasionTest, TakesOnlyWhatWillBeLetThrough) {
  EvasionScene scene = Scene({0.0, 0.0}, {{{3.0, 0.0}, {-1.0, 0.0}, 0.5}});
  scene.is_allowed = [](const Twist2D& command) { return command.v <= 0.0; };
  EXPECT_LE(evasion_.Update(scene).command.v, 0.0);
}

TEST_F(EvasionTest, OfRandomMoversMostCanBeEvaded) {
  std::mt19937 random(6);
  std::uniform_real_distribution<double> angle(-kPi, kPi);
  std::uniform_real_distribution<double> aim(-0.3, 0.3);
  std::uniform_real_distribution<double> speed(0.5, 1.4);
  int touched = 0;
  constexpr int kRuns = 100;
  for (int run = 0; run < kRuns; ++run) {
    evasion_.Reset();
    const double from = angle(random);
    MovingObstacle mover;
    mover.position = 4.0 * Pose2D(0.0, 0.0, from).heading();
    mover.velocity =
        speed(random) * Pose2D(0.0, 0.0, from + kPi + aim(random)).heading();
    mover.radius = 0.5;
    touched += Drive(Scene({0.5, 0.0}, {mover}), 5.0) < 0.0 ? 1 : 0;
  }
  EXPECT_LE(touched, 2);
}

TEST_F(EvasionTest, WhatStandsDoesNotHideWhatComes) {
  EvasionScene scene = Scene({0.0, 0.0}, {{{0.0, 2.0}, {0.0, -1.0}, 0.4}});
  // Wherever it goes there is less room: every drive ends with its first step.
  scene.room = [](const Eigen::Vector2d& point) {
    return point.norm() < 0.01 ? 0.3 : 0.2;
  };
  // 2 m less the radii and the margin, at 1 m/s and what the margin grows by.
  EXPECT_LT(evasion_.Update(scene).contact_time, 1.5);
}

}  // namespace
}  // namespace vfh_astar
