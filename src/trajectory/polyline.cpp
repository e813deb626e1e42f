#include "vfh_astar/trajectory/polyline.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>

namespace vfh_astar {
namespace {

constexpr double kSamePoint = 1e-3;  // m

double Direction(const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  return std::atan2(to.y() - from.y(), to.x() - from.x());
}

Polyline::const_iterator Nearest(const Polyline& line,
                                 const Eigen::Vector2d& point) {
  return std::min_element(
      line.begin(), line.end(),
      [&point](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
        return (a - point).squaredNorm() < (b - point).squaredNorm();
      });
}

}  // namespace

double Length(const Polyline& line) {
  double length = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i) {
    length += (line[i] - line[i - 1]).norm();
  }
  return length;
}

double FirstDirection(const Polyline& line) {
  assert(line.size() >= 2);
  return Direction(line[0], line[1]);
}

double LastDirection(const Polyline& line) {
  assert(line.size() >= 2);
  return Direction(line[line.size() - 2], line.back());
}

Polyline Resample(const Polyline& line, int count) {
  assert(line.size() >= 2 && count >= 2);
  const double spacing = Length(line) / (count - 1);
  Polyline points = {line.front()};
  double passed = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Eigen::Vector2d way = line[i] - line[i - 1];
    const double length = way.norm();
    while (static_cast<int>(points.size()) < count - 1) {
      const double wanted = spacing * static_cast<double>(points.size());
      if (wanted > passed + length) break;
      points.push_back(line[i - 1] + (wanted - passed) / length * way);
    }
    passed += length;
  }
  while (static_cast<int>(points.size()) < count) points.push_back(line.back());
  return points;
}

SplitLine SplitAt(const Polyline& line, double length) {
  assert(line.size() >= 2);
  SplitLine parts;
  double passed = 0.0;
  std::size_t i = 1;
  parts.before.push_back(line.front());
  for (; i + 1 < line.size(); ++i) {
    const double step = (line[i] - line[i - 1]).norm();
    if (passed + step > length) break;
    passed += step;
    parts.before.push_back(line[i]);
  }
  const Eigen::Vector2d way = line[i] - line[i - 1];
  const double share =
      way.norm() > 0.0 ? std::clamp((length - passed) / way.norm(), 0.0, 1.0)
                       : 1.0;
  const Eigen::Vector2d point = line[i - 1] + share * way;
  parts.before.push_back(point);
  parts.after.push_back(point);
  parts.after.insert(parts.after.end(), line.begin() + i, line.end());
  return parts;
}

double NearestPlace(const Polyline& line, const Eigen::Vector2d& point) {
  return Length(Polyline(line.begin(), Nearest(line, point) + 1));
}

Polyline PathFrom(const Eigen::Vector2d& from, const Polyline& path) {
  Polyline rest = {from};
  for (auto point = Nearest(path, from); point != path.end(); ++point) {
    if ((*point - rest.back()).norm() > kSamePoint) rest.push_back(*point);
  }
  return rest;
}

Polyline PathTo(const Eigen::Vector2d& to, const Polyline& path) {
  Polyline way(path.begin(), std::max(path.begin() + 1, Nearest(path, to)));
  if ((way.back() - to).norm() > kSamePoint || way.size() == 1) {
    way.push_back(to);
  }
  return way;
}

Polyline Points(const ArcShape& arc, const Pose2D& from) {
  constexpr int kParts = 12;
  const double step = arc.length / kParts;
  Pose2D pose = from;
  Polyline points = {from.position()};
  for (int i = 0; i < kParts; ++i) {
    const double part = (i + 0.5) / kParts;
    const double curvature =
        arc.curvature + part * (arc.end_curvature - arc.curvature);
    pose = Integrate(pose, {arc.reverse ? -1.0 : 1.0, curvature}, step);
    points.push_back(pose.position());
  }
  return points;
}

}  // namespace vfh_astar
