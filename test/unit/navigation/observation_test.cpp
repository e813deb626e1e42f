#include "vfh_astar/navigation/observation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace vfh_astar {
namespace {

class ObservationTest : public testing::Test {
 protected:
  ObservationTest() {
    scan_.stamp = 10.0;
    scan_.angle_min = 0.0;
    scan_.angle_increment = 0.5 * kPi;
    scan_.range_min = 0.1;
    scan_.range_max = 5.0;
    scan_.ranges = {1.0f};
    input_.time = 10.0;
    input_.map_from_odom = Pose2D();
    input_.odometry_stamp = 10.0;
    input_.scan = &scan_;
  }

  LaserScan scan_;
  NavigatorInput input_;
  NavigatorParameters parameters_;
};

TEST_F(ObservationTest, PredictsThePoseToNow) {
  input_.map_from_odom = Pose2D(1.0, 0.0, 0.5 * kPi);
  input_.odom_from_base = Pose2D(2.0, 0.0, 0.0);
  input_.twist = {1.0, 0.0};
  input_.time = 10.1;
  const Observation observation = Observe(input_, parameters_);
  ASSERT_FALSE(observation.fault.has_value());
  // 2.1 m along the odometry's x, which is the map's y.
  EXPECT_NEAR(observation.pose.x, 1.0, 1e-9);
  EXPECT_NEAR(observation.pose.y, 2.1, 1e-9);
}

TEST_F(ObservationTest, MovesTheHitsToWhereTheyLieNow) {
  input_.base_from_laser = Pose2D(0.5, 0.0, 0.0);
  input_.twist = {2.0, 0.0};
  input_.time = 10.1;
  const Observation observation = Observe(input_, parameters_);
  ASSERT_EQ(observation.obstacles.size(), 1u);
  // 1.5 m ahead when it was seen, and the robot has driven 0.2 m since.
  EXPECT_NEAR(observation.obstacles[0].x(), 1.3, 1e-6);
  EXPECT_NEAR(observation.obstacles[0].y(), 0.0, 1e-6);
}

TEST_F(ObservationTest, OnlyHitsAreObstacles) {
  const float infinity = std::numeric_limits<float>::infinity();
  scan_.angle_increment = 0.1;
  scan_.ranges = {1.0f, infinity, -infinity, std::nanf(""), 0.05f, 6.0f, 2.0f};
  EXPECT_EQ(Observe(input_, parameters_).obstacles.size(), 2u);
}

TEST_F(ObservationTest, NamesWhatIsMissing) {
  NavigatorInput input = input_;
  input.scan = nullptr;
  EXPECT_EQ(Observe(input, parameters_).fault->outcome, Outcome::kNoScan);
  input = input_;
  input.odometry_stamp.reset();
  EXPECT_EQ(Observe(input, parameters_).fault->outcome, Outcome::kNoOdometry);
  input = input_;
  input.map_from_odom.reset();
  EXPECT_EQ(Observe(input, parameters_).fault->outcome,
            Outcome::kTransformError);
}

TEST_F(ObservationTest, NamesWhatIsTooOld) {
  input_.time = 10.24;
  EXPECT_FALSE(Observe(input_, parameters_).fault.has_value());
  input_.time = 10.26;
  const Observation old_scan = Observe(input_, parameters_);
  ASSERT_TRUE(old_scan.fault.has_value());
  EXPECT_EQ(old_scan.fault->outcome, Outcome::kNoScan);
  EXPECT_EQ(old_scan.fault->message,
            "the latest usable scan is 0.26 s old; expected 0.25 s or less");
  input_.scan_defect = "the scan has no beams";
  EXPECT_EQ(Observe(input_, parameters_).fault->message,
            "the latest usable scan is 0.26 s old; expected 0.25 s or less; "
            "the scan has no beams");
  scan_.stamp = 10.26;
  EXPECT_EQ(Observe(input_, parameters_).fault->outcome, Outcome::kNoOdometry);
}

TEST_F(ObservationTest, ATransformThatNobodyRenewsIsTooOld) {
  input_.map_from_odom_stamp = 9.01;
  EXPECT_FALSE(Observe(input_, parameters_).fault.has_value());
  input_.map_from_odom_stamp = 8.5;
  const Observation observation = Observe(input_, parameters_);
  ASSERT_TRUE(observation.fault.has_value());
  EXPECT_EQ(observation.fault->outcome, Outcome::kTransformError);
  EXPECT_EQ(observation.fault->message,
            "the transform from map to odom is 1.50 s old; expected 1.00 s or "
            "less");
  parameters_.watchdog.transform_timeout = 2.0;
  EXPECT_FALSE(Observe(input_, parameters_).fault.has_value());
}

TEST_F(ObservationTest, ATransformMayBeDatedAheadOrForEver) {
  input_.map_from_odom_stamp = 10.05;
  EXPECT_FALSE(Observe(input_, parameters_).fault.has_value());
  input_.map_from_odom_stamp.reset();
  EXPECT_FALSE(Observe(input_, parameters_).fault.has_value());
}

TEST_F(ObservationTest, RefusesOdometryFromTheFuture) {
  input_.odometry_stamp = 40.0;
  const Observation observation = Observe(input_, parameters_);
  ASSERT_TRUE(observation.fault.has_value());
  EXPECT_EQ(observation.fault->outcome, Outcome::kNoOdometry);
}

TEST(FootprintClearanceTest, ByHand) {
  const Footprint footprint{0.5, 0.3, 0.2};
  EXPECT_EQ(FootprintClearance(footprint, {}),
            std::numeric_limits<double>::infinity());
  EXPECT_NEAR(FootprintClearance(footprint, {{1.0, 0.0}, {0.0, 0.9}}), 0.5,
              1e-12);
  EXPECT_NEAR(FootprintClearance(footprint, {{0.8, 0.6}}), 0.5, 1e-12)
      << "from the corner, 0.3 and 0.4 m away";
  EXPECT_NEAR(FootprintClearance(footprint, {{0.45, 0.0}}), -0.05, 1e-12);
}

}  // namespace
}  // namespace vfh_astar
