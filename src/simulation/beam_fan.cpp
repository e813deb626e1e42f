#include "vfh_astar/simulation/beam_fan.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace vfh_astar {
namespace {

using Eigen::Vector2d;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

constexpr int kBlock = kFanLanes;  ///< beams

/// The ranges of a block.
using Block = Eigen::Map<const Eigen::Array<double, kBlock, 1>>;

double Cross(const Vector2d& a, const Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
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
      reach_((count + kBlock - 1) / kBlock) {
  assert(count >= 1 && increment > 0.0);
  x_.resize(reach_.size() * kBlock);
  y_.resize(reach_.size() * kBlock);
  for (int beam = 0; beam < count; ++beam) {
    x_[beam] = std::cos(beam * increment);
    y_[beam] = std::sin(beam * increment);
  }
}

void BeamFan::Aim(const Pose2D& pose, double range) {
  frame_.origin = pose.position();
  frame_.axis = Pose2D(frame_.origin, pose.theta + first_angle_).heading();
  range_ = range;
  std::fill(ranges_.begin(), ranges_.end(), kInfinity);
  std::fill(reach_.begin(), reach_.end(), range);
}

Vector2d BeamFan::ToFan(const Vector2d& point) const {
  const Vector2d offset = point - frame_.origin;
  return {frame_.axis.dot(offset), Cross(frame_.axis, offset)};
}

inline BeamFan::Span BeamFan::BeamsBetween(double low, double high) const {
  // Rounded up and down; the cast cuts off towards 0.
  const double first = (low - kBearingError) * beams_per_rad_ + 1.0;
  const double last = (high + kBearingError) * beams_per_rad_;
  return {static_cast<int>(std::max(0.0, first)),
          static_cast<int>(std::min(last, ranges_.size() - 1.0))};
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

inline bool BeamFan::IsHidden(const Span& span, double distance_squared,
                              double radius) const {
  // Four blocks at a time, some more than once, as how many there are would be
  // guessed wrong.
  const int last = span.last / kBlock;
  for (int block = span.first / kBlock; block <= last; block += 4) {
    const double reach =
        std::max(std::max(reach_[block], reach_[std::min(block + 1, last)]),
                 std::max(reach_[std::min(block + 2, last)],
                          reach_[std::min(block + 3, last)])) +
        radius;
    if (reach * reach >= distance_squared) return false;
  }
  return true;
}

inline void BeamFan::NoteReach(int block, double farthest) {
  reach_[block] = std::min(range_, farthest);
}

bool BeamFan::MaySee(const View& view) const {
  bool seen = false;
  ForEachTurn(view.low, view.high, [&](const Span& span) {
    seen = seen || !IsHidden(span, view.distance_squared, view.radius);
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
  DiscLanes discs;
  discs.x.fill(center.x());
  discs.y.fill(center.y());
  discs.radius.fill(radius);
  LookAtDiscs(discs, 1);
}

void BeamFan::LookAtDiscs(const DiscLanes& discs, int count) {
  DiscLanes in_fan;
  const ViewLanes views = ViewDiscs(frame_, discs, &in_fan);
  for (int i = 0; i < count; ++i) {
    const Vector2d at(in_fan.x[i], in_fan.y[i]);
    const double radius = in_fan.radius[i];
    const double distance_squared = views.distance_squared[i];
    if (distance_squared <= radius * radius) {
      CoverAll();
      continue;
    }
    ForEachTurn(views.low[i], views.high[i], [&](const Span& span) {
      if (IsHidden(span, distance_squared, radius)) return;
      DrawDisc(at, radius, span);
    });
  }
}

void BeamFan::DrawDisc(const Vector2d& center, double radius,
                       const Span& span) {
  const int whole = static_cast<int>(ranges_.size()) / kBlock;
  const int last = span.last / kBlock;
  for (int block = span.first / kBlock; block <= std::min(last, whole - 1);
       ++block) {
    const int beam = block * kBlock;
    NoteReach(block,
              MeetDisc(center, radius, &x_[beam], &y_[beam], &ranges_[beam]));
  }
  if (last < whole) return;
  const int beam = whole * kBlock;
  FanLanes rest = {};
  std::copy(ranges_.begin() + beam, ranges_.end(), rest.begin());
  NoteReach(whole, MeetDisc(center, radius, &x_[beam], &y_[beam], rest.data()));
  std::copy_n(rest.begin(), ranges_.size() - beam, ranges_.begin() + beam);
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
  const double low = Bearing(to);
  ForEachTurn(low, low + Width(low, Bearing(from)), [&](const Span& span) {
    if (IsHidden(span, distance_squared, 0.0)) return;
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
  const int whole = static_cast<int>(ranges_.size()) / kBlock;
  const int last = span.last / kBlock;
  for (int block = span.first / kBlock; block <= std::min(last, whole - 1);
       ++block) {
    NoteReach(block, Block(&ranges_[block * kBlock]).maxCoeff());
  }
  if (last < whole) return;
  NoteReach(whole,
            *std::max_element(ranges_.begin() + whole * kBlock, ranges_.end()));
}

void BeamFan::CoverAll() {
  std::fill(ranges_.begin(), ranges_.end(), 0.0);
  std::fill(reach_.begin(), reach_.end(), 0.0);
}

}  // namespace vfh_astar
