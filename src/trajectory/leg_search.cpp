#include "vfh_astar/trajectory/leg_search.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vfh_astar {
namespace {

// m of curves that all searches together may fit.
constexpr double kMaxEffort = 1000.0;
// m from a leg's end within which a collision is the end's fault.
constexpr double kEndReach = 0.5;
// m of a path that are looked at for the direction of its end.
constexpr double kLastMetres = 2.0;

}  // namespace

CurveEnd EndAlong(const Polyline& line, std::optional<double> heading) {
  return {line.back(), heading.value_or(LastDirection(line)), 0.0};
}

LegSearch::LegSearch(const PoseCheck& check, double fast_room)
    : check_(check),
      fast_room_(fast_room),
      fitter_(check, fast_room),
      effort_left_(kMaxEffort),
      total_effort_left_(kMaxEffort) {}

bool LegSearch::IsExhausted() const {
  return effort_left_ <= 0.0 || total_effort_left_ <= 0.0;
}

void LegSearch::RenewEffort() {
  effort_left_ = kMaxEffort;
  total_effort_left_ = kMaxEffort;
}

ShorteningLimits LegSearch::Limits() const {
  return {check_.footprint().InscribedRadius() + check_.margin(),
          check_.footprint().CircumscribedRadius() + fast_room_};
}

Polyline LegSearch::Shorten(const Polyline& path) const {
  return ShortenPath(path, check_.clearance(), Limits());
}

double LegSearch::DirectionFrom(const Polyline& path) const {
  return FirstShortenedDirection(path, check_.clearance(), Limits());
}

double LegSearch::DirectionInto(const Polyline& path) const {
  const double before = std::max(0.0, Length(path) - kLastMetres);
  return LastDirection(Shorten(SplitAt(path, before).after));
}

std::optional<Turn> LegSearch::FindTurn(const Pose2D& pose,
                                        double heading) const {
  const double angle = NormalizeAngle(heading - pose.theta);
  const double other_way = angle > 0.0 ? angle - 2.0 * kPi : angle + 2.0 * kPi;
  for (const double turn : {angle, other_way}) {
    if (check_.IsTurnFree(pose, turn)) return Turn{pose, turn};
  }
  return std::nullopt;
}

std::vector<LegSearch::LegEnd> LegSearch::EndsOf(const Polyline& line,
                                                 const CurveEnd& start,
                                                 const CurveEnd& end,
                                                 bool reverse) {
  const double inward = std::max(0.0, Length(line) - kEndReach);
  return {{start, SplitAt(line, kEndReach).after.front(), true, reverse},
          {end, SplitAt(line, inward).after.front(), false, reverse}};
}

bool LegSearch::IsHopeless(const LegEnd& end) const {
  const double heading = end.end.heading + (end.reverse ? kPi : 0.0);
  if (!check_.IsFree({end.end.position, heading})) return true;
  constexpr double kSamePlace = 0.01;    // m
  constexpr double kSameLine = 0.05;     // m
  constexpr double kSameHeading = 0.05;  // rad
  return std::any_of(
      hopeless_.begin(), hopeless_.end(), [&end](const LegEnd& known) {
        return known.is_start == end.is_start && known.reverse == end.reverse &&
               (known.end.position - end.end.position).norm() < kSamePlace &&
               (known.beyond - end.beyond).norm() < kSameLine &&
               std::abs(NormalizeAngle(known.end.heading - end.end.heading)) <
                   kSameHeading;
      });
}

bool LegSearch::IsHopeless(const Polyline& line, const CurveEnd& start,
                           const CurveEnd& end, bool reverse) const {
  const std::vector<LegEnd> ends = EndsOf(line, start, end, reverse);
  return IsHopeless(ends[0]) || IsHopeless(ends[1]);
}

void LegSearch::NoteBlocked(const Eigen::Vector2d& place) {
  if (!first_blocked_) first_blocked_ = place;
  last_blocked_ = place;
}

std::optional<Leg> LegSearch::FitLeg(const Polyline& line,
                                     const CurveEnd& start, const CurveEnd& end,
                                     bool reverse) {
  if (IsExhausted()) return std::nullopt;
  const std::vector<LegEnd> ends = EndsOf(line, start, end, reverse);
  for (const LegEnd& each : ends) {
    if (IsHopeless(each)) {
      NoteBlocked(each.end.position);
      return std::nullopt;
    }
  }
  LegResult result = fitter_.Fit({line, start, end, reverse});
  effort_left_ -= result.effort;
  total_effort_left_ -= result.effort;
  if (result.free) return Leg{std::move(result.points), reverse};
  NoteBlocked(result.blocked_at);
  for (const LegEnd& each : ends) {
    if ((each.end.position - result.blocked_at).norm() < kEndReach) {
      hopeless_.push_back(each);
    }
  }
  return std::nullopt;
}

}  // namespace vfh_astar
