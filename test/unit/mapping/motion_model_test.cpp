#include "vfh_astar/mapping/motion_model.h"

#include <gtest/gtest.h>

namespace vfh_astar {
namespace {

MotionModelParameters Simple() {
  MotionModelParameters parameters;
  parameters.srr = 0.3;
  parameters.srt = 0.5;
  parameters.str = 0.1;
  parameters.stt = 0.2;
  parameters.linear_floor = 0.1;
  parameters.angular_floor = 0.2;
  return parameters;
}

TEST(MotionModel, VariancesAddUp) {
  const Eigen::Matrix3d covariance = MotionCovariance(Simple(), {3, 4, -2});
  // 5 m and 2 rad: 0.1^2 + 1.5^2 + 1^2, and 0.2^2 + 0.5^2 + 0.4^2.
  EXPECT_NEAR(covariance(0, 0), 3.26, 1e-9);
  EXPECT_NEAR(covariance(1, 1), 3.26, 1e-9);
  EXPECT_NEAR(covariance(2, 2), 0.45, 1e-9);
}

TEST(MotionModel, InformationIsTheInverse) {
  const Pose2D motion(1.0, 0.0, 0.5);
  const Eigen::Matrix3d information =
      MotionInformation(Simple(), {5.0, 5.0, 1.1}, motion);
  EXPECT_TRUE((information * MotionCovariance(Simple(), motion))
                  .isApprox(Eigen::Matrix3d::Identity(), 1e-9));
}

}  // namespace
}  // namespace vfh_astar
