#include "vfh_astar/simulation/world_fields.h"

#include <cmath>
#include <string>

namespace vfh_astar {

Eigen::Vector2d ReadPoint(const YamlField& field) {
  const std::vector<double> n = field.Numbers(2, kFarthestPlace, "[x, y] in m");
  return {n[0], n[1]};
}

Eigen::Vector2d ReadSize(const YamlField& field) {
  if (field.size() != 2) field.Fail("[length, width] in m");
  std::vector<double> size;
  for (const YamlField& item : field.Items()) {
    size.push_back(item.Number(kSmallestSize, kLargestSize));
  }
  return {size[0], size[1]};
}

Pose2D ReadPose(const YamlField& field) {
  const std::vector<double> n =
      field.Numbers(3, kFarthestPlace, "[x, y, yaw] in m and rad");
  return {n[0], n[1], NormalizeAngle(n[2])};
}

Pose2D ReadGoal(const YamlField& field, const Pose2D& start) {
  const std::string form = "[x, y] in m, or [x, y, yaw] in m and rad";
  if (field.size() != 2) {
    const std::vector<double> n = field.Numbers(3, kFarthestPlace, form);
    return {n[0], n[1], NormalizeAngle(n[2])};
  }
  const Eigen::Vector2d place = ReadPoint(field);
  const Eigen::Vector2d way = place - start.position();
  return {place, std::atan2(way.y(), way.x())};
}

std::vector<Keyframe> ReadKeyframes(const YamlField& field) {
  std::vector<Keyframe> keyframes;
  for (const YamlField& item : field.Items()) {
    const std::vector<double> n =
        item.Numbers(3, kLongestTime, "[t, x, y] in s and m");
    if (n[0] < 0.0) item.Fail("a time of 0 or more");
    if (!keyframes.empty() && n[0] <= keyframes.back().time) {
      item.Fail("a later time than the keyframe before");
    }
    keyframes.push_back({n[0], Eigen::Vector2d(n[1], n[2])});
  }
  if (keyframes.empty()) field.Fail("one [t, x, y] or more, in s and m");
  return keyframes;
}

double ReadPeriod(const YamlField& field,
                  const std::vector<Keyframe>& keyframes) {
  const double period = field.Number(0.0, kLongestTime);
  if (period != 0.0 && period < keyframes.back().time) {
    field.Fail("0 or no less than the time of the last keyframe");
  }
  return period;
}

}  // namespace vfh_astar
