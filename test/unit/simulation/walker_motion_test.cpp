#include "vfh_astar/simulation/walker_motion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "vfh_astar/footprint.h"
#include "vfh_astar/simulation/jackal.h"

namespace vfh_astar {
namespace {

constexpr double kStep = 0.002;

Walker SomeWalker() {
  Walker walker;
  walker.name = "walker";
  walker.home = {3.0, 2.0};
  walker.radius = 0.25;
  walker.speed = 1.0;
  walker.notice = 4.5;
  walker.ahead = 2.0;
  walker.keep = 0.5;
  walker.stand = 1.0;
  walker.times = 2;
  return walker;
}

SeenRobot RobotAt(const Pose2D& pose, double speed) {
  return {pose, OutlineOf(Footprint(), pose), speed};
}

bool Anywhere(const Shape&) { return true; }

/// Lets time pass while a robot is where it is.
class WalkerMotionTest : public testing::Test {
 protected:
  void Pass(double seconds, const SeenRobot& robot) {
    for (const double end = time_ + seconds; time_ < end - 0.5 * kStep;) {
      time_ += kStep;
      motion_.Update(time_, {robot}, Anywhere);
    }
  }
  Eigen::Vector2d place() const { return motion_.shape().center; }

  WalkerMotion motion_{SomeWalker()};
  double time_ = 0.0;
};

TEST_F(WalkerMotionTest, WaitsForARobotThatIsNearAndMoves) {
  Pass(5.0, RobotAt({-3.0, 0.0, 0.0}, 1.0));
  EXPECT_EQ(place(), Eigen::Vector2d(3.0, 2.0)) << "too far";
  Pass(5.0, RobotAt({1.0, 0.0, 0.0}, 0.0));
  EXPECT_EQ(place(), Eigen::Vector2d(3.0, 2.0)) << "it stands";
}

TEST_F(WalkerMotionTest, StepsAheadAtItsSpeedThenStands) {
  // It gets there in 2 s; by then the robot will be at (1, 0), 2 m before it.
  const SeenRobot robot = RobotAt({-0.5, 0.0, 0.0}, 0.75);
  Pass(1.0, robot);
  EXPECT_NEAR(place().x(), 3.0, 1e-3);
  EXPECT_NEAR(place().y(), 1.0, 0.01);
  Pass(1.0, robot);
  EXPECT_NEAR(place().y(), 0.0, 0.01);
  Pass(0.5, robot);
  EXPECT_NEAR(place().y(), 0.0, 1e-9);
}

TEST_F(WalkerMotionTest, StepsIntoTheNewWayThenGoesHome) {
  Pass(2.5, RobotAt({1.0, 0.0, 0.0}, 0.2));
  EXPECT_NEAR(place().y(), 0.0, 1e-9) << "in the way along x";
  // The robot has turned: its way now leads along y.
  const SeenRobot turned = RobotAt({2.0, -1.0, 0.5 * kPi}, 0.2);
  Pass(2.8, turned);
  EXPECT_NEAR(place().x(), 2.0, 1e-9);
  EXPECT_NEAR(place().y(), 1.0, 0.5);
  Pass(10.0, turned);
  EXPECT_EQ(place(), Eigen::Vector2d(3.0, 2.0));
  Pass(10.0, turned);
  EXPECT_EQ(place(), Eigen::Vector2d(3.0, 2.0)) << "two times are enough";
}

TEST_F(WalkerMotionTest, NeverWalksIntoARobot) {
  // It would have to pass the second robot on its way to before the first.
  Pass(0.1, RobotAt({3.0, -4.0, 0.5 * kPi}, 0.2));
  EXPECT_EQ(place(), Eigen::Vector2d(3.0, 2.0)) << "too far";
  Pass(0.1, RobotAt({3.0, -2.4, 0.5 * kPi}, 0.2));
  EXPECT_LT(place().y(), 2.0);
  const SeenRobot in_between = RobotAt({3.0, 0.5, 0.5 * kPi}, 1.0);
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 450; ++i) {
    time_ += kStep;
    motion_.Update(time_, {in_between}, Anywhere);
    least = std::min(least, Distance(motion_.shape(), in_between.outline));
  }
  EXPECT_NEAR(least, 0.5, 0.01);
}

TEST_F(WalkerMotionTest, StopsBeforeObstacles) {
  const Shape wall = MakeBox({3.0, 1.0, 0.0}, {10.0, 0.1});
  const SeenRobot robot = RobotAt({1.0, 0.0, 0.0}, 1.0);
  double lowest = place().y();
  for (int i = 0; i < 5000; ++i) {
    time_ += kStep;
    motion_.Update(time_, {robot}, [&](const Shape& shape) {
      return Distance(shape, wall) > 0.0;
    });
    ASSERT_GT(Distance(motion_.shape(), wall), 0.0);
    lowest = std::min(lowest, place().y());
  }
  EXPECT_NEAR(lowest, 1.05 + 0.25, 0.01);
}

}  // namespace
}  // namespace vfh_astar
