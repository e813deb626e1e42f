#include "vfh_astar/trajectory/leg_fitter.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <optional>

#include "vfh_astar/trajectory/curve_smoother.h"

namespace vfh_astar {
namespace {

constexpr double kSpacing = 0.1;     // m between control points.
constexpr int kMinIntervals = 8;     // what the smoother needs.
constexpr double kMaxRadius = 1.0;   // m of a bubble.
constexpr double kShare = 0.6;       // of the room beyond what is needed.
constexpr double kSweepStep = 0.01;  // m that a corner moves between looks.
// 1/m; a sharper bend is a cusp, which a turn on the spot takes faster.
constexpr double kMaxCurvature = 12.0;
constexpr int kMaxTightenings = 12;
constexpr double kTightening = 0.4;
constexpr double kLeastRadius = 0.01;  // m
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

// 1/m, as the curve shows it at the points and between them: at a cusp that
// folds back along itself the points see none.
double CurvatureOf(const CurvePoint& before, const CurvePoint& point) {
  const double turn = std::abs(NormalizeAngle(point.heading - before.heading));
  return std::max(std::abs(point.curvature), turn / point.length);
}

std::optional<Eigen::Vector2d> FindCusp(const std::vector<CurvePoint>& points) {
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (CurvatureOf(points[i - 1], points[i]) > kMaxCurvature) {
      return points[i].position;
    }
  }
  return std::nullopt;
}

// Shrinks the bubbles about the blocked spans; a bubble that would become very
// small vanishes. False when there is nothing left to shrink about one of them.
bool Tighten(std::vector<Bubble>& bubbles, double spacing,
             const std::vector<CurvePoint>& points,
             const std::vector<std::size_t>& blocked) {
  const int reach = static_cast<int>(std::ceil(kTightenReach / spacing));
  const std::vector<Bubble> before = bubbles;
  for (const std::size_t span : blocked) {
    const int knot = static_cast<int>(points[span].knot);
    const int first = std::max(0, knot - reach);
    const int last =
        std::min(static_cast<int>(bubbles.size()) - 1, knot + 1 + reach);
    double largest = 0.0;
    for (int i = first; i <= last; ++i) {
      largest = std::max(largest, before[i].radius);
      bubbles[i].radius = kTightening * before[i].radius;
      if (bubbles[i].radius < kLeastRadius) bubbles[i].radius = 0.0;
    }
    if (largest == 0.0) return false;
  }
  return true;
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
            .Sample();
    result.effort += length;
    const std::vector<std::size_t> blocked =
        BlockedSpans(result.points, request.reverse, check_);
    if (blocked.empty()) {
      const std::optional<Eigen::Vector2d> cusp = FindCusp(result.points);
      result.free = !cusp;
      result.blocked_at = cusp.value_or(result.blocked_at);
      return result;
    }
    result.blocked_at = result.points[blocked.front()].position;
    if (!Tighten(bubbles, spacing, result.points, blocked)) break;
  }
  return result;
}

}  // namespace vfh_astar
