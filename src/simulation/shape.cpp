#include "vfh_astar/simulation/shape.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace vfh_astar {
namespace {

using Eigen::Vector2d;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double Cross(const Vector2d& a, const Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

double SignedArea(const std::vector<Vector2d>& outline) {
  double twice = 0.0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    twice += Cross(outline[i], outline[(i + 1) % outline.size()]);
  }
  return 0.5 * twice;
}

double DistanceToSegment(const Vector2d& p, const Vector2d& a,
                         const Vector2d& b) {
  const Vector2d edge = b - a;
  const double length = edge.squaredNorm();
  const double along =
      length > 0.0 ? std::clamp((p - a).dot(edge) / length, 0.0, 1.0) : 0.0;
  return (p - a - along * edge).norm();
}

/// Distance from a point to a polygon, 0 inside.
double DistanceToPolygon(const Vector2d& point, const Shape& polygon) {
  if (Contains(polygon, point)) return 0.0;
  double least = kInfinity;
  const auto& v = polygon.vertices;
  for (std::size_t i = 0; i < v.size(); ++i) {
    least =
        std::min(least, DistanceToSegment(point, v[i], v[(i + 1) % v.size()]));
  }
  return least;
}

/// The outward unit normal of the edge from vertex i.
Vector2d OutwardNormal(const Shape& polygon, std::size_t i) {
  const auto& v = polygon.vertices;
  const Vector2d edge = v[(i + 1) % v.size()] - v[i];
  return Vector2d(edge.y(), -edge.x()).normalized();
}

/// How far `other` stays outside of `polygon` beyond its best separating edge.
struct Separation {
  double distance = -kInfinity;  // m, negative when overlapping.
  std::size_t edge = 0;
  Vector2d normal = Vector2d::Zero();  // out of the polygon.
};

Separation FindSeparation(const Shape& polygon, const Shape& other) {
  Separation best;
  for (std::size_t i = 0; i < polygon.vertices.size(); ++i) {
    const Vector2d normal = OutwardNormal(polygon, i);
    double least = kInfinity;
    for (const Vector2d& vertex : other.vertices) {
      least = std::min(least, normal.dot(vertex - polygon.vertices[i]));
    }
    if (least > best.distance) best = {least, i, normal};
  }
  return best;
}

bool IsEar(const std::vector<Vector2d>& outline, std::size_t i) {
  const std::size_t n = outline.size();
  const Vector2d& a = outline[(i + n - 1) % n];
  const Vector2d& b = outline[i];
  const Vector2d& c = outline[(i + 1) % n];
  if (Cross(b - a, c - b) <= 0.0) return false;
  for (const Vector2d& p : outline) {
    if (p == a || p == b || p == c) continue;
    if (Cross(b - a, p - a) >= 0.0 && Cross(c - b, p - b) >= 0.0 &&
        Cross(a - c, p - c) >= 0.0) {
      return false;
    }
  }
  return true;
}

bool SegmentsCross(const Vector2d& a, const Vector2d& b, const Vector2d& c,
                   const Vector2d& d) {
  return Cross(b - a, c - a) * Cross(b - a, d - a) < 0.0 &&
         Cross(d - c, a - c) * Cross(d - c, b - c) < 0.0;
}

bool CrossesItself(const std::vector<Vector2d>& outline) {
  const std::size_t n = outline.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 1; j < n; ++j) {
      if (SegmentsCross(outline[i], outline[(i + 1) % n], outline[j],
                        outline[(j + 1) % n])) {
        return true;
      }
    }
  }
  return false;
}

std::vector<ContactPoint> FindDiscContact(const Shape& a, const Shape& disc) {
  Vector2d nearest = Vector2d::Zero();
  double least = kInfinity;
  std::size_t nearest_edge = 0;
  for (std::size_t i = 0; i < a.vertices.size(); ++i) {
    const Vector2d& start = a.vertices[i];
    const Vector2d edge = a.vertices[(i + 1) % a.vertices.size()] - start;
    const double along = std::clamp(
        (disc.center - start).dot(edge) / edge.squaredNorm(), 0.0, 1.0);
    const Vector2d point = start + along * edge;
    const double distance = (disc.center - point).norm();
    if (distance < least) {
      least = distance;
      nearest = point;
      nearest_edge = i;
    }
  }
  if (Contains(a, disc.center)) {
    return {{nearest, -OutwardNormal(a, nearest_edge), least + disc.radius}};
  }
  if (least > disc.radius) return {};
  return {{nearest, (nearest - disc.center) / least, disc.radius - least}};
}

}  // namespace

Shape Shape::At(const Pose2D& pose) const {
  Shape moved = *this;
  moved.center = pose * center;
  for (Vector2d& vertex : moved.vertices) vertex = pose * vertex;
  return moved;
}

Shape MakeDisc(const Vector2d& center, double radius) {
  assert(radius > 0.0);
  return {center, radius, {}};
}

Shape MakeConvexPolygon(std::vector<Vector2d> vertices) {
  assert(vertices.size() >= 3 && SignedArea(vertices) > 0.0);
  Vector2d center = Vector2d::Zero();
  for (const Vector2d& vertex : vertices) center += vertex;
  center /= static_cast<double>(vertices.size());
  double radius = 0.0;
  for (const Vector2d& vertex : vertices) {
    radius = std::max(radius, (vertex - center).norm());
  }
  return {center, radius, std::move(vertices)};
}

Shape MakeBox(const Pose2D& pose, const Vector2d& size) {
  const Vector2d half = 0.5 * size;
  return MakeConvexPolygon({pose * Vector2d(half.x(), half.y()),
                            pose * Vector2d(-half.x(), half.y()),
                            pose * Vector2d(-half.x(), -half.y()),
                            pose * Vector2d(half.x(), -half.y())});
}

std::vector<Shape> MakePolygon(std::vector<Vector2d> outline) {
  if (outline.size() < 3 || CrossesItself(outline)) return {};
  const double area = SignedArea(outline);
  if (std::abs(area) < 1e-9) return {};
  if (area < 0.0) std::reverse(outline.begin(), outline.end());
  std::vector<Shape> triangles;
  while (outline.size() > 3) {
    std::size_t ear = 0;
    while (ear < outline.size() && !IsEar(outline, ear)) ++ear;
    const std::size_t n = outline.size();
    if (ear == n) {
      // Only corners without area are left where no ear is found.
      ear = 0;
      while (ear < n &&
             std::abs(Cross(outline[ear] - outline[(ear + n - 1) % n],
                            outline[(ear + 1) % n] - outline[ear])) > 1e-12) {
        ++ear;
      }
      if (ear == n) return {};
    } else {
      triangles.push_back(MakeConvexPolygon(
          {outline[(ear + n - 1) % n], outline[ear], outline[(ear + 1) % n]}));
    }
    outline.erase(outline.begin() + static_cast<std::ptrdiff_t>(ear));
  }
  if (SignedArea(outline) > 1e-12) {
    triangles.push_back(MakeConvexPolygon(outline));
  }
  return triangles;
}

std::vector<Shape> MakeWall(const std::vector<Vector2d>& points,
                            double thickness, bool closed) {
  assert(points.size() >= 2 && thickness > 0.0);
  std::vector<Shape> parts;
  const std::size_t segments = closed ? points.size() : points.size() - 1;
  for (std::size_t i = 0; i < segments; ++i) {
    const Vector2d& from = points[i];
    const Vector2d& to = points[(i + 1) % points.size()];
    const Vector2d edge = to - from;
    // Longer by half the thickness at both ends, so that square corners fill.
    parts.push_back(
        MakeBox(Pose2D(0.5 * (from + to), std::atan2(edge.y(), edge.x())),
                Vector2d(edge.norm() + thickness, thickness)));
  }
  return parts;
}

bool Contains(const Shape& shape, const Vector2d& point) {
  if (shape.IsDisc()) {
    return (point - shape.center).squaredNorm() <= shape.radius * shape.radius;
  }
  const auto& v = shape.vertices;
  for (std::size_t i = 0; i < v.size(); ++i) {
    if (Cross(v[(i + 1) % v.size()] - v[i], point - v[i]) < 0.0) return false;
  }
  return true;
}

double Distance(const Shape& a, const Shape& b) {
  if (a.IsDisc() && b.IsDisc()) {
    return std::max(0.0, (a.center - b.center).norm() - a.radius - b.radius);
  }
  if (b.IsDisc()) {
    return std::max(0.0, DistanceToPolygon(b.center, a) - b.radius);
  }
  if (a.IsDisc()) return Distance(b, a);
  if (FindSeparation(a, b).distance <= 0.0 &&
      FindSeparation(b, a).distance <= 0.0) {
    return 0.0;
  }
  double least = kInfinity;
  for (const Vector2d& p : a.vertices) {
    least = std::min(least, DistanceToPolygon(p, b));
  }
  for (const Vector2d& p : b.vertices) {
    least = std::min(least, DistanceToPolygon(p, a));
  }
  return least;
}

std::vector<ContactPoint> FindContact(const Shape& a, const Shape& b) {
  assert(!a.IsDisc());
  if ((a.center - b.center).norm() > a.radius + b.radius) return {};
  if (b.IsDisc()) return FindDiscContact(a, b);
  const Separation of_a = FindSeparation(a, b);
  if (of_a.distance > 0.0) return {};
  const Separation of_b = FindSeparation(b, a);
  if (of_b.distance > 0.0) return {};
  const bool a_is_reference = of_a.distance >= of_b.distance;
  const Separation& reference = a_is_reference ? of_a : of_b;
  const Shape& fixed = a_is_reference ? a : b;
  const Shape& incident = a_is_reference ? b : a;

  std::size_t facing = 0;
  double most_opposed = kInfinity;
  for (std::size_t i = 0; i < incident.vertices.size(); ++i) {
    const double along = OutwardNormal(incident, i).dot(reference.normal);
    if (along < most_opposed) {
      most_opposed = along;
      facing = i;
    }
  }
  const auto& fv = fixed.vertices;
  const Vector2d start = fv[reference.edge];
  const Vector2d edge = fv[(reference.edge + 1) % fv.size()] - start;
  const double length = edge.norm();
  const Vector2d tangent = edge / length;
  const Vector2d p = incident.vertices[facing];
  const Vector2d q = incident.vertices[(facing + 1) % incident.vertices.size()];
  const double p_along = tangent.dot(p - start);
  const double q_along = tangent.dot(q - start);
  std::vector<ContactPoint> contacts;
  for (const double end : {p_along, q_along}) {
    const double along = std::clamp(end, 0.0, length);
    const double part =
        q_along == p_along ? 0.0 : (along - p_along) / (q_along - p_along);
    const Vector2d point = p + std::clamp(part, 0.0, 1.0) * (q - p);
    const double depth = -reference.normal.dot(point - start);
    if (depth < 0.0) continue;
    contacts.push_back(
        {point, a_is_reference ? Vector2d(-reference.normal) : reference.normal,
         depth});
  }
  return contacts;
}

}  // namespace vfh_astar
