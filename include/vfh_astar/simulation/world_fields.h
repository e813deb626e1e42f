#ifndef VFH_ASTAR_SIMULATION_WORLD_FIELDS_H_
#define VFH_ASTAR_SIMULATION_WORLD_FIELDS_H_

#include <Eigen/Core>
#include <vector>

#include "vfh_astar/geometry.h"
#include "vfh_astar/simulation/world.h"
#include "vfh_astar/yaml_field.h"

namespace vfh_astar {

// What the world formats that are YAML or JSON have in common. Each throws
// YamlFieldError.

/// Farther from the origin than any world reaches, m.
inline constexpr double kFarthestPlace = 1e5;
/// Smaller than any solid, m.
inline constexpr double kSmallestSize = 1e-3;
/// Larger than any solid, m.
inline constexpr double kLargestSize = 1e4;
/// s, longer than any run.
inline constexpr double kLongestTime = 1e6;

/// [x, y] in m.
Eigen::Vector2d ReadPoint(const YamlField& field);

/// [length, width] in m, along a box's own x and y.
Eigen::Vector2d ReadSize(const YamlField& field);

/// [x, y, yaw] in m and rad.
Pose2D ReadPose(const YamlField& field);

/// [x, y] or [x, y, yaw]; without yaw it looks the way one comes from `start`.
Pose2D ReadGoal(const YamlField& field, const Pose2D& start);

/// A list of one [t, x, y] or more, in s and m, from t = 0 on, times rising.
std::vector<Keyframe> ReadKeyframes(const YamlField& field);

/// s; 0, or no less than the time of the last keyframe.
double ReadPeriod(const YamlField& field,
                  const std::vector<Keyframe>& keyframes);

}  // namespace vfh_astar

#endif  // VFH_ASTAR_SIMULATION_WORLD_FIELDS_H_
