#include "vfh_astar/trajectory/leg_fitter.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>

#include "vfh_astar/trajectory/curve_smoother.h"

namespace vfh_astar {
namespace {

constexpr double kSpacing = 0.1;      // m between control points.
constexpr int kMinIntervals = 8;      // what the smoother needs.
constexpr double kMaxRadius = 1.0;    // m of a bubble.
constexpr double kShare = 0.6;        // of the room beyond what is needed.
constexpr double kSweepStep = 0.015;  // m that a corner moves between looks.
constexpr int kMaxTightenings = 8;
constexpr double kTightenReach = 0.3;  // m about a collision, either way.

double CornerMotion(const CurvePoint& a, const CurvePoint& b, double radius) {
  return b.length + std::abs(NormalizeAngle(b.heading - a.heading)) * radius;
}

// The robot's pose between two points of the curve.
Pose2D Between(const CurvePoint& a, const CurvePoint& b, double part,
               bool reverse) {
  const double turn = NormalizeAngle(b.heading - a.heading);
  return {a.position + part * (b.position - a.position),
          a.heading + part * turn + (reverse ? kPi : 0.0)};
}

bool IsSpanFree(const CurvePoint& a, const CurvePoint& b, bool reverse,
                const PoseCheck& check) {
  const double radius = check.footprint().CircumscribedRadius();
  const int looks = std::max(
      1, static_cast<int>(std::ceil(CornerMotion(a, b, radius) / kSweepStep)));
  for (int i = 0; i <= looks; ++i) {
    if (!check.IsFree(Between(a, b, static_cast<double>(i) / looks, reverse))) {
      return false;
    }
  }
  return true;
}

// The spans (between two points) in which the footprint is not free.
std::vector<std::size_t> BlockedSpans(const std::vector<CurvePoint>& points,
                                      bool reverse, const PoseCheck& check) {
  std::vector<std::size_t> blocked;
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (!IsSpanFree(points[i - 1], points[i], reverse, check)) {
      blocked.push_back(i - 1);
    }
  }
  return blocked;
}

void Tighten(std::vector<Bubble>& bubbles, double spacing,
             const std::vector<std::size_t>& blocked, int round) {
  const int reach = static_cast<int>(std::ceil(kTightenReach / spacing));
  const double factor = round + 2 < kMaxTightenings ? 0.5 : 0.0;
  std::vector<bool> done(bubbles.size(), false);
  for (const std::size_t span : blocked) {
    const int knot = static_cast<int>(span) / LegFitter::kPointsPerInterval;
    const int first = std::max(0, knot - reach);
    const int last =
        std::min(static_cast<int>(bubbles.size()) - 1, knot + 1 + reach);
    for (int i = first; i <= last; ++i) {
      if (!done[i]) bubbles[i].radius *= factor;
      done[i] = true;
    }
  }
}

}  // namespace

LegFitter::LegFitter(const PoseCheck& check, double fast_room)
    : check_(check), fast_room_(fast_room) {}

double LegFitter::BubbleRadius(const Eigen::Vector2d& centre) const {
  const double room = check_.clearance().At(centre) - check_.margin();
  const double needed = check_.footprint().InscribedRadius();
  const double fast = check_.footprint().CircumscribedRadius() + fast_room_;
  return std::clamp(std::max(kShare * (room - needed), room - fast), 0.0,
                    kMaxRadius);
}

LegResult LegFitter::Fit(const LegRequest& request) const {
  const double length = Length(request.line);
  assert(length > 0.0);
  const int intervals =
      std::max(kMinIntervals, static_cast<int>(std::ceil(length / kSpacing)));
  const double spacing = length / intervals;
  std::vector<Bubble> bubbles;
  for (const Eigen::Vector2d& centre : Resample(request.line, intervals + 1)) {
    bubbles.push_back({centre, BubbleRadius(centre)});
  }

  LegResult result;
  for (int round = 0; round <= kMaxTightenings; ++round) {
    result.points =
        SmoothThroughBubbles(request.start, request.end, spacing, bubbles)
            .Sample(kPointsPerInterval);
    const std::vector<std::size_t> blocked =
        BlockedSpans(result.points, request.reverse, check_);
    if (blocked.empty()) {
      result.free = true;
      return result;
    }
    result.blocked_at = result.points[blocked.front()].position;
    Tighten(bubbles, spacing, blocked, round);
  }
  return result;
}

}  // namespace vfh_astar
