#include "vfh_astar/beam_directions.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vfh_astar {
namespace {

TEST(BeamDirectionsTest, StayTrueOverAScan) {
  LaserScan scan;
  scan.angle_min = -2.35;
  for (const double increment : {0.00436, -0.00436}) {
    scan.angle_increment = increment;
    scan.ranges.assign(1080, 1.0F);
    BeamDirections direction(scan, 3.0);
    for (std::size_t beam = 0; beam < scan.ranges.size(); ++beam) {
      ASSERT_NEAR(direction.x(), std::cos(3.0 + scan.Angle(beam)), 1e-12);
      ASSERT_NEAR(direction.y(), std::sin(3.0 + scan.Angle(beam)), 1e-12);
      direction.Next();
    }
  }
}

}  // namespace
}  // namespace vfh_astar
