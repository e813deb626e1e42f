#include "vfh_astar/navigation/driver.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <deque>

namespace vfh_astar {
namespace {

constexpr double kPeriod = 0.025;  // s
constexpr int kLate = 4;           // cycles until the robot obeys.

/// An S from rest at (0, 0) to rest at (4, 1.5) in 4 s.
Trajectory Bends() {
  const Jet middle_x = {2.0, 1.6, 0.0, 0.0};
  const Jet middle_y = {0.75, 1.2, 0.0, 0.0};
  TrajectoryPiece first;
  first.duration = 2.0;
  first.x = HermiteQuintic({0.0, 0.0, 1.0, 0.0}, middle_x, 2.0);
  first.y = HermiteQuintic({0.0, 0.0, 0.0, 0.0}, middle_y, 2.0);
  TrajectoryPiece second;
  second.duration = 2.0;
  second.x = HermiteQuintic(middle_x, {4.0, 0.0, -1.0, 0.0}, 2.0);
  second.y = HermiteQuintic(middle_y, {1.5, 0.0, 0.0, 0.0}, 2.0);
  return Trajectory({first, second});
}

/// The greatest error in position, m, of a robot that obeys kLate cycles late
/// and is driven as one that does so after `delay` seconds.
double GreatestError(double delay) {
  NavigatorParameters parameters;
  parameters.actuation_delay = delay;
  parameters.replan.lag = 0.0;
  Driver driver(parameters);
  driver.follower().Follow(Bends(), std::nullopt, 0.0);
  std::deque<Twist2D> on_their_way(kLate);
  Observation observation;
  double greatest = 0.0;
  for (double t = 0.0; t < 4.0; t += kPeriod) {
    const Twist2D wanted = driver.Track(observation, kPeriod, false);
    on_their_way.push_back(driver.Limit(wanted, observation, kPeriod).command);
    observation.twist = on_their_way.front();
    on_their_way.pop_front();
    observation.pose = Integrate(observation.pose, observation.twist, kPeriod);
    const Pose2D reference = driver.follower().At(kPeriod).pose;
    greatest = std::max(
        greatest, (observation.pose.position() - reference.position()).norm());
  }
  return greatest;
}

TEST(DriverTest, MakesUpForTheDelay) {
  const double compensated = GreatestError(kLate * kPeriod);
  EXPECT_LT(compensated, 0.03);
  EXPECT_GT(GreatestError(0.0), 2.0 * compensated);
}

}  // namespace
}  // namespace vfh_astar
