#include "vfh_astar/navigation/oscillation_monitor.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vfh_astar {
namespace {

constexpr double kPeriod = 0.1;

class OscillationMonitorTest : public testing::Test {
 protected:
  OscillationMonitorTest() : monitor_(parameters_) {
    parameters_.time = 5.0;
    parameters_.distance = 0.5;
  }

  /// To and fro within `reach` m of the origin.
  void Swing(double reach, double seconds, bool is_moving = true) {
    for (double t = 0.0; t < seconds; t += kPeriod) {
      monitor_.Move({reach * std::sin(3.0 * t), 0.0}, is_moving, kPeriod);
    }
  }

  OscillationParameters parameters_;
  OscillationMonitor monitor_;
};

TEST_F(OscillationMonitorTest, NoticesAfterTheTime) {
  Swing(0.4, 4.5);
  EXPECT_FALSE(monitor_.IsOscillating());
  Swing(0.4, 1.0);
  EXPECT_TRUE(monitor_.IsOscillating());
}

TEST_F(OscillationMonitorTest, WhoLeavesThePlaceMakesProgress) {
  for (double x = 0.0; x < 3.0; x += 0.02) {
    monitor_.Move({x, 0.0}, true, kPeriod);
    ASSERT_FALSE(monitor_.IsOscillating()) << "0.5 m in 2.5 s";
  }
}

TEST_F(OscillationMonitorTest, WhoStandsDoesNotOscillate) {
  Swing(0.0, 100.0, false);
  EXPECT_FALSE(monitor_.IsOscillating());
  Swing(0.4, 4.5);
  EXPECT_FALSE(monitor_.IsOscillating()) << "the wait does not count later";
}

TEST_F(OscillationMonitorTest, BeginsAnew) {
  Swing(0.4, 6.0);
  monitor_.Reset();
  EXPECT_FALSE(monitor_.IsOscillating());
  Swing(0.4, 4.5);
  EXPECT_FALSE(monitor_.IsOscillating());
}

TEST_F(OscillationMonitorTest, CanBeTurnedOff) {
  parameters_.time = 0.0;
  Swing(0.4, 100.0);
  EXPECT_FALSE(monitor_.IsOscillating());
}

}  // namespace
}  // namespace vfh_astar
