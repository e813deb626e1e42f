#ifndef VFH_ASTAR_MAPPING_MOTION_MODEL_H_
#define VFH_ASTAR_MAPPING_MOTION_MODEL_H_

#include <Eigen/Core>

#include "vfh_astar/geometry.h"
#include "vfh_astar/parameters.h"

namespace vfh_astar {

/// How far wheel odometry may be off; the names are gmapping's, the values are
/// standard deviations.
struct MotionModelParameters {
  double srr = 0.1;             ///< m per m driven.
  double srt = 0.2;             ///< m per rad turned.
  double str = 0.1;             ///< rad per m driven.
  double stt = 0.2;             ///< rad per rad turned.
  double linear_floor = 0.02;   ///< m, of any motion.
  double angular_floor = 0.02;  ///< rad, of any motion.

  void Read(ParameterReader& reader);
};

/// The covariance of a motion as odometry reports it, in the frame of the pose
/// where it begins: (x, y, theta).
Eigen::Matrix3d MotionCovariance(const MotionModelParameters& parameters,
                                 const Pose2D& motion);

/// The information about a pose reached from a certain one.
/// @param[in] from where the motion began, in the map's frame.
/// @return over (x, y, theta) of the pose reached, in the map's frame.
Eigen::Matrix3d MotionInformation(const MotionModelParameters& parameters,
                                  const Pose2D& from, const Pose2D& motion);

}  // namespace vfh_astar

#endif  // VFH_ASTAR_MAPPING_MOTION_MODEL_H_
