#include "vfh_astar/mapping/motion_model.h"

#include <Eigen/LU>
#include <cmath>

namespace vfh_astar {
namespace {

double Square(double value) { return value * value; }

}  // namespace

void MotionModelParameters::Read(ParameterReader& reader) {
  reader.Number("srr", srr, 0.0, 2.0);
  reader.Number("srt", srt, 0.0, 2.0);
  reader.Number("str", str, 0.0, 2.0);
  reader.Number("stt", stt, 0.0, 2.0);
}

Eigen::Matrix3d MotionCovariance(const MotionModelParameters& parameters,
                                 const Pose2D& motion) {
  const double driven = motion.position().norm();
  const double turned = std::abs(motion.theta);
  const double linear = Square(parameters.linear_floor) +
                        Square(parameters.srr * driven) +
                        Square(parameters.srt * turned);
  const double angular = Square(parameters.angular_floor) +
                         Square(parameters.str * driven) +
                         Square(parameters.stt * turned);
  return Eigen::Vector3d(linear, linear, angular).asDiagonal();
}

Eigen::Matrix3d MotionInformation(const MotionModelParameters& parameters,
                                  const Pose2D& from, const Pose2D& motion) {
  const double c = std::cos(from.theta);
  const double s = std::sin(from.theta);
  Eigen::Matrix3d turn;
  turn << c, -s, 0.0, s, c, 0.0, 0.0, 0.0, 1.0;
  return turn * MotionCovariance(parameters, motion).inverse() *
         turn.transpose();
}

}  // namespace vfh_astar
