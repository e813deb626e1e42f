#include "vfh_astar/simulation/beam_fan.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

namespace vfh_astar {
namespace {

using Eigen::Vector2d;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kHuge = std::numeric_limits<double>::max();

constexpr int kBlock = 8;  ///< beams

/// rad by which Bearing is wrong at most, with some to spare.
constexpr double kBearingError = 2e-5;

double Cross(const Vector2d& a, const Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// The angle of a vector from the x axis in [0, 2 pi], by a polynomial that
/// deviates least from the arc tangent (fitted to 1.1e-5 rad), as it only has
/// to tell which beams to try.
double Bearing(const Vector2d& v) {
  const double ax = std::abs(v.x());
  const double ay = std::abs(v.y());
  const double t = std::min(ax, ay) / std::max(ax, ay);
  const double s = t * t;
  double angle =
      t *
      (0.9998663 +
       s * (-0.3303048 + s * (0.1801592 + s * (-0.0851562 + s * 0.0208451))));
  if (ay > ax) angle = 0.5 * kPi - angle;
  if (v.x() < 0.0) angle = kPi - angle;
  return v.y() < 0.0 ? 2.0 * kPi - angle : angle;
}

/// rad from one bearing counter-clockwise to another that is at most half a
/// turn away; 0 where only the error of Bearing has them the other way round.
double Width(double low, double high) {
  const double width = high < low ? high - low + 2.0 * kPi : high - low;
  return width < 1.5 * kPi ? width : 0.0;
}

/// The corners of a box that does not hold the origin, as seen from there: the
/// one farthest to the right, then the one farthest to the left.
std::pair<Vector2d, Vector2d> Silhouette(const Vector2d& min,
                                         const Vector2d& max) {
  if (min.x() > 0.0) {
    return {{min.y() > 0.0 ? max.x() : min.x(), min.y()},
            {max.y() < 0.0 ? max.x() : min.x(), max.y()}};
  }
  if (max.x() < 0.0) {
    return {{max.y() < 0.0 ? min.x() : max.x(), max.y()},
            {min.y() > 0.0 ? min.x() : max.x(), min.y()}};
  }
  if (min.y() > 0.0) return {{max.x(), min.y()}, min};
  return {{min.x(), max.y()}, max};
}

/// m^2 from the origin to a segment.
double DistanceSquared(const Vector2d& from, const Vector2d& to) {
  const Vector2d edge = to - from;
  const double part =
      std::clamp(-from.dot(edge) / edge.squaredNorm(), 0.0, 1.0);
  return (from + part * edge).squaredNorm();
}

}  // namespace

BeamFan::BeamFan(int count, double first_angle, double increment)
    : first_angle_(first_angle),
      beams_per_rad_(1.0 / increment),
      full_angle_((count - 1) * increment),
      ranges_(count, kInfinity),
      reach_squared_((count + kBlock - 1) / kBlock) {
  assert(count >= 1 && increment > 0.0);
  for (int beam = 0; beam < count; ++beam) {
    x_.push_back(std::cos(beam * increment));
    y_.push_back(std::sin(beam * increment));
  }
}

void BeamFan::Aim(const Pose2D& pose, double range) {
  origin_ = pose.position();
  axis_ = Pose2D(origin_, pose.theta + first_angle_).heading();
  range_squared_ = range * range;
  std::fill(ranges_.begin(), ranges_.end(), kInfinity);
  std::fill(reach_squared_.begin(), reach_squared_.end(), range_squared_);
}

Vector2d BeamFan::ToFan(const Vector2d& point) const {
  const Vector2d offset = point - origin_;
  return {axis_.dot(offset), Cross(axis_, offset)};
}

BeamFan::Span BeamFan::BeamsBetween(double low, double high) const {
  // Rounded up and down; the cast cuts off towards 0.
  const double first = (low - kBearingError) * beams_per_rad_ + 1.0;
  const double last = (high + kBearingError) * beams_per_rad_;
  return {static_cast<int>(std::max(0.0, first)),
          static_cast<int>(std::min(last, x_.size() - 1.0))};
}

template <typename Draw>
void BeamFan::ForEachTurn(double low, double high, const Draw& draw) const {
  // A fan begins at angle 0, which may lie in the middle of what is seen.
  for (double turn = -2.0 * kPi; low + turn - kBearingError <= full_angle_;
       turn += 2.0 * kPi) {
    if (high + turn + kBearingError < 0.0) continue;
    const Span span = BeamsBetween(low + turn, high + turn);
    if (span.first <= span.last) draw(span);
  }
}

bool BeamFan::IsHidden(const Span& span, double distance_squared) const {
  for (int block = span.first / kBlock; block <= span.last / kBlock; ++block) {
    if (reach_squared_[block] >= distance_squared) return false;
  }
  return true;
}

bool BeamFan::MaySee(const Vector2d& min, const Vector2d& max) const {
  const Vector2d low = min - origin_;
  const Vector2d high = max - origin_;
  const double distance_squared =
      low.cwiseMax(-high).cwiseMax(Vector2d::Zero()).squaredNorm();
  if (distance_squared > range_squared_) return false;
  if (distance_squared == 0.0) return true;
  const auto [right, left] = Silhouette(low, high);
  const double from = Bearing({axis_.dot(right), Cross(axis_, right)});
  const double to = Bearing({axis_.dot(left), Cross(axis_, left)});
  bool seen = false;
  ForEachTurn(from, from + Width(from, to), [&](const Span& span) {
    seen = seen || !IsHidden(span, distance_squared);
  });
  return seen;
}

void BeamFan::LookAt(const Shape& shape) {
  if (shape.IsDisc()) {
    LookAtDisc(shape.center, shape.radius);
  } else {
    LookAtPolygon(shape.vertices.data(), shape.vertices.size());
  }
}

void BeamFan::LookAtDisc(const Vector2d& center, double radius) {
  const Vector2d at = ToFan(center);
  const double distance = at.norm();
  if (distance <= radius) return CoverAll();
  const double gap = distance - radius;
  if (gap * gap > range_squared_) return;
  // Not less than the arc sine, and equal to it where it is a right angle.
  const double sine = radius / distance;
  const double half = sine * (1.0 + (0.5 * kPi - 1.0) * sine * sine);
  const double bearing = Bearing(at);
  ForEachTurn(bearing - half, bearing + half, [&](const Span& span) {
    if (!IsHidden(span, gap * gap)) DrawDisc(at, radius, span);
  });
}

void BeamFan::DrawDisc(const Vector2d& center, double radius, Span span) {
  ForEachBlock(span, [&](const auto& x, const auto& y, auto* ranges) {
    using Beams = std::decay_t<decltype(x)>;
    const Beams aside = center.x() * y - center.y() * x;
    const Beams along = center.x() * x + center.y() * y;
    const Beams half_chord_squared = radius * radius - aside * aside;
    // Infinite for a beam that misses, else 0. Arithmetic instead of branches,
    // which would be guessed wrong at both sides of each disc.
    const Beams missed =
        half_chord_squared.min(along).min(0.0) * -kHuge * kHuge;
    *ranges = ranges->min(along - half_chord_squared.max(0.0).sqrt() + missed);
  });
}

void BeamFan::LookAtPolygon(const Vector2d* vertices, std::size_t count) {
  const Vector2d first = ToFan(vertices[0]);
  Vector2d from = first;
  bool inside = true;
  for (std::size_t i = 1; i <= count; ++i) {
    const Vector2d to = i < count ? ToFan(vertices[i]) : first;
    // Edges that face away are hidden by those that do not.
    if (Cross(from, to) < 0.0) {
      inside = false;
      LookAtEdge(from, to);
    }
    from = to;
  }
  if (inside) CoverAll();
}

void BeamFan::LookAtEdge(const Vector2d& from, const Vector2d& to) {
  const double distance_squared = DistanceSquared(from, to);
  if (distance_squared > range_squared_) return;
  const double low = Bearing(to);
  ForEachTurn(low, low + Width(low, Bearing(from)), [&](const Span& span) {
    if (IsHidden(span, distance_squared)) return;
    DrawEdge(from, to, std::sqrt(distance_squared), span);
  });
}

void BeamFan::DrawEdge(const Vector2d& from, const Vector2d& to, double nearest,
                       Span span) {
  // Both ends count, so that no beam slips through between two edges.
  const auto meets = [&](int beam) {
    return from.y() * x_[beam] - from.x() * y_[beam] >= 0.0 &&
           to.y() * x_[beam] - to.x() * y_[beam] <= 0.0;
  };
  while (span.first <= span.last && !meets(span.first)) ++span.first;
  while (span.first <= span.last && !meets(span.last)) --span.last;
  if (span.first > span.last) return;
  const Vector2d edge = to - from;
  const double outside = Cross(from, to);
  for (int beam = span.first; beam <= span.last; ++beam) {
    double range = outside / (edge.y() * x_[beam] - edge.x() * y_[beam]);
    // Along an edge that is seen from its end it is one rounding by another.
    range = range < nearest ? nearest : range;
    ranges_[beam] = range < ranges_[beam] ? range : ranges_[beam];
  }
  ForEachBlock(span, [](const auto&, const auto&, auto*) {});
}

void BeamFan::CoverAll() {
  std::fill(ranges_.begin(), ranges_.end(), 0.0);
  std::fill(reach_squared_.begin(), reach_squared_.end(), 0.0);
}

template <typename Draw>
void BeamFan::ForEachBlock(const Span& span, const Draw& draw) {
  const auto visit = [&](int block, auto size) {
    using Beams = Eigen::Array<double, decltype(size)::value, 1, 0, kBlock, 1>;
    const int first = block * kBlock;
    const int count = std::min<int>(kBlock, ranges_.size() - first);
    Eigen::Map<Beams> at(&ranges_[first], count);
    Beams ranges = at;
    draw(Beams(Eigen::Map<const Beams>(&x_[first], count)),
         Beams(Eigen::Map<const Beams>(&y_[first], count)), &ranges);
    at = ranges;
    const double farthest = ranges.maxCoeff();
    reach_squared_[block] = std::min(range_squared_, farthest * farthest);
  };
  // Of a size that the compiler knows, but for what is left at the end.
  const int whole = static_cast<int>(ranges_.size()) / kBlock;
  const int last = span.last / kBlock;
  for (int block = span.first / kBlock; block <= std::min(last, whole - 1);
       ++block) {
    visit(block, std::integral_constant<int, kBlock>());
  }
  if (last == whole) visit(last, std::integral_constant<int, Eigen::Dynamic>());
}

}  // namespace vfh_astar
