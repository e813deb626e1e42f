#include "vfh_astar/trajectory/manoeuvre.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>

namespace vfh_astar {
namespace {

// m of curves that may be fitted for one way of leaving and arriving, and for
// all of them, before a path counts as hopeless: they bound the time it takes.
constexpr double kFindEffort = 250.0;
constexpr double kMaxEffort = 1000.0;
// m from a leg's end within which a collision is the end's fault.
constexpr double kEndReach = 0.5;
// m between places along the path that are tried for a turn.
constexpr double kPlaceSpacing = 0.1;
// m from where a leg was blocked to where a stop is looked for.
constexpr double kStopReach = 1.5;
// m that the robot shifts along its heading to find room to turn.
constexpr double kMaxShift = 1.0;
constexpr double kMinLeg = 0.05;   // m
constexpr double kAligned = 1e-3;  // rad

double Direction(const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  return std::atan2(to.y() - from.y(), to.x() - from.x());
}

double FirstDirection(const Polyline& line) {
  return Direction(line[0], line[1]);
}

double LastDirection(const Polyline& line) {
  return Direction(line[line.size() - 2], line.back());
}

// The end of a leg along a line, with the line's own heading if none is given.
CurveEnd EndAlong(const Polyline& line,
                  std::optional<double> heading = std::nullopt) {
  return {line.back(), heading.value_or(LastDirection(line)), 0.0};
}

void Append(Manoeuvre& manoeuvre, const Manoeuvre& more) {
  manoeuvre.insert(manoeuvre.end(), more.begin(), more.end());
}

// Places along a path (m from its start) by distance from `centre`.
std::vector<double> PlacesAround(double centre, double reach, double length) {
  std::vector<double> places;
  for (double offset = 0.0; offset <= reach; offset += kPlaceSpacing) {
    for (const double place : {centre - offset, centre + offset}) {
      if (place >= kMinLeg && place <= length - kMinLeg) {
        places.push_back(place);
      }
      if (offset == 0.0) break;
    }
  }
  return places;
}

// The path up to its point nearest to `end`, which lies off it.
Polyline PathTo(const Eigen::Vector2d& end, const Polyline& path) {
  const auto nearest = std::min_element(
      path.begin() + 1, path.end(),
      [&end](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
        return (a - end).squaredNorm() < (b - end).squaredNorm();
      });
  Polyline way(path.begin(), nearest);
  way.push_back(end);
  return way;
}

// m along the path to the point of it that is nearest to `point`.
double NearestPlace(const Polyline& path, const Eigen::Vector2d& point) {
  double best = 0.0;
  double best_distance = INFINITY;
  double passed = 0.0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (i > 0) passed += (path[i] - path[i - 1]).norm();
    const double distance = (path[i] - point).norm();
    if (distance < best_distance) {
      best_distance = distance;
      best = passed;
    }
  }
  return best;
}

}  // namespace

Pose2D EndOf(const Manoeuvre& manoeuvre) {
  assert(!manoeuvre.empty());
  if (const Turn* turn = std::get_if<Turn>(&manoeuvre.back())) {
    return {turn->pose.position(),
            NormalizeAngle(turn->pose.theta + turn->angle)};
  }
  const Leg& leg = std::get<Leg>(manoeuvre.back());
  const CurvePoint& end = leg.points.back();
  return {end.position,
          NormalizeAngle(end.heading + (leg.reverse ? kPi : 0.0))};
}

ManoeuvreFinder::ManoeuvreFinder(const PoseCheck& check,
                                 const ManoeuvreParameters& parameters)
    : check_(check),
      parameters_(parameters),
      fitter_(check, parameters.fast_room),
      effort_left_(0.0),
      total_effort_left_(kMaxEffort) {}

Polyline ManoeuvreFinder::Shorten(const Polyline& path) const {
  ShorteningLimits limits;
  limits.needed = check_.footprint().InscribedRadius() + check_.margin();
  limits.wanted =
      check_.footprint().CircumscribedRadius() + parameters_.fast_room;
  return ShortenPath(path, check_.clearance(), limits);
}

std::optional<Turn> ManoeuvreFinder::FindTurn(const Pose2D& pose,
                                              double heading) const {
  const double angle = NormalizeAngle(heading - pose.theta);
  const double other_way = angle > 0.0 ? angle - 2.0 * kPi : angle + 2.0 * kPi;
  for (const double turn : {angle, other_way}) {
    if (check_.IsTurnFree(pose, turn)) return Turn{pose, turn};
  }
  return std::nullopt;
}

ManoeuvreFinder::LegEnd ManoeuvreFinder::StartOf(const Polyline& line,
                                                 const CurveEnd& start,
                                                 bool reverse) {
  return {start, SplitAt(line, kEndReach).after.front(), true, reverse};
}

ManoeuvreFinder::LegEnd ManoeuvreFinder::EndOf(const Polyline& line,
                                               const CurveEnd& end,
                                               bool reverse) {
  const double inward = std::max(0.0, Length(line) - kEndReach);
  return {end, SplitAt(line, inward).after.front(), false, reverse};
}

bool ManoeuvreFinder::IsHopeless(const LegEnd& end) const {
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

std::optional<Leg> ManoeuvreFinder::FitLeg(const Polyline& line,
                                           const CurveEnd& start,
                                           const CurveEnd& end, bool reverse) {
  if (total_effort_left_ <= 0.0) return std::nullopt;
  const std::array<LegEnd, 2> ends = {StartOf(line, start, reverse),
                                      EndOf(line, end, reverse)};
  for (const LegEnd& each : ends) {
    if (IsHopeless(each)) {
      blocked_at_ = each.end.position;
      return std::nullopt;
    }
  }
  LegResult result = fitter_.Fit({line, start, end, reverse});
  effort_left_ -= result.effort;
  total_effort_left_ -= result.effort;
  if (result.free) return Leg{std::move(result.points), reverse};
  blocked_at_ = result.blocked_at;
  for (const LegEnd& each : ends) {
    if ((each.end.position - result.blocked_at).norm() < kEndReach) {
      hopeless_.push_back(each);
    }
  }
  return std::nullopt;
}

std::optional<Manoeuvre> ManoeuvreFinder::Drive(
    const Departure& departure, const Polyline& path,
    std::optional<double> end_heading) {
  Polyline line = departure.lead;
  const Polyline shortened = Shorten(path);
  line.insert(line.end(), shortened.begin(), shortened.end());
  const Pose2D& pose = departure.pose;
  const CurveEnd start{pose.position(), pose.theta, departure.curvature};
  const std::optional<Leg> leg =
      FitLeg(line, start, EndAlong(line, end_heading), false);
  if (leg) return Manoeuvre{*leg};
  return DriveWithStop(departure, path, end_heading);
}

std::optional<Manoeuvre> ManoeuvreFinder::DriveWithStop(
    const Departure& departure, const Polyline& path,
    std::optional<double> end_heading) {
  // A stop on the way does not help an end.
  const CurveEnd start{departure.pose.position(), departure.pose.theta,
                       departure.curvature};
  Polyline whole = departure.lead;
  const Polyline shortened = Shorten(path);
  whole.insert(whole.end(), shortened.begin(), shortened.end());
  if (IsHopeless(StartOf(whole, start, false)) ||
      IsHopeless(EndOf(whole, EndAlong(whole, end_heading), false))) {
    return std::nullopt;
  }
  const double length = Length(path);
  const double blocked = NearestPlace(path, *blocked_at_);
  for (const double place : PlacesAround(blocked, kStopReach, length)) {
    if (effort_left_ <= 0.0) return std::nullopt;
    const SplitLine parts = SplitAt(path, place);
    const Polyline onward = Shorten(parts.after);
    const Polyline before = Shorten(parts.before);
    // A cheap look before the fit: the turn between the lines' directions.
    const Pose2D stop(onward.front(), LastDirection(before));
    if (!FindTurn(stop, FirstDirection(onward))) continue;

    Polyline line = departure.lead;
    line.insert(line.end(), before.begin(), before.end());
    const std::optional<Leg> leg = FitLeg(line, start, EndAlong(line), false);
    if (!leg) continue;
    Manoeuvre manoeuvre = {*leg};
    const std::optional<Manoeuvre> rest =
        TurnThenDrive(vfh_astar::EndOf(manoeuvre), parts.after, end_heading);
    if (!rest) continue;
    Append(manoeuvre, *rest);
    return manoeuvre;
  }
  return std::nullopt;
}

std::optional<Manoeuvre> ManoeuvreFinder::TurnThenDrive(
    const Pose2D& pose, const Polyline& path,
    std::optional<double> end_heading) {
  const double direction = FirstDirection(Shorten(path));
  Manoeuvre manoeuvre;
  if (std::abs(NormalizeAngle(direction - pose.theta)) > kAligned) {
    const std::optional<Turn> turn = FindTurn(pose, direction);
    if (!turn) return std::nullopt;
    manoeuvre.push_back(*turn);
  }
  Departure departure;
  departure.pose = {pose.position(), direction};
  const std::optional<Manoeuvre> rest = Drive(departure, path, end_heading);
  if (!rest) return std::nullopt;
  Append(manoeuvre, *rest);
  return manoeuvre;
}

std::optional<Manoeuvre> ManoeuvreFinder::BackOutThenDrive(
    const Pose2D& pose, const Polyline& path,
    std::optional<double> end_heading) {
  const double length = Length(path);
  const CurveEnd start{pose.position(), NormalizeAngle(pose.theta + kPi), 0.0};
  for (double place = 2.0 * kPlaceSpacing; place < length - kMinLeg;
       place += kPlaceSpacing) {
    const SplitLine parts = SplitAt(path, place);
    const Polyline line = Shorten(parts.before);
    const Pose2D stop(parts.after.front(), LastDirection(line) + kPi);
    if (!FindTurn(stop, FirstDirection(Shorten(parts.after)))) continue;
    const std::optional<Leg> leg = FitLeg(line, start, EndAlong(line), true);
    if (!leg) return std::nullopt;
    Manoeuvre manoeuvre = {*leg};
    const std::optional<Manoeuvre> rest =
        TurnThenDrive(vfh_astar::EndOf(manoeuvre), parts.after, end_heading);
    if (!rest) continue;
    Append(manoeuvre, *rest);
    return manoeuvre;
  }
  // There is room nowhere: the whole way backwards.
  const Polyline line = Shorten(path);
  CurveEnd end = EndAlong(line);
  if (end_heading) end.heading = *end_heading + kPi;
  const std::optional<Leg> leg = FitLeg(line, start, end, true);
  if (!leg) return std::nullopt;
  return Manoeuvre{*leg};
}

std::optional<Manoeuvre> ManoeuvreFinder::ShiftThenDrive(
    const Pose2D& pose, const Polyline& path,
    std::optional<double> end_heading) {
  for (double shift = kPlaceSpacing; shift <= kMaxShift;
       shift += kPlaceSpacing) {
    for (const bool reverse : {false, true}) {
      if (reverse && !parameters_.may_reverse) continue;
      const double travel = pose.theta + (reverse ? kPi : 0.0);
      const Eigen::Vector2d place =
          pose.position() +
          shift * Eigen::Vector2d(std::cos(travel), std::sin(travel));
      if (!check_.IsFree({place, pose.theta})) continue;
      Polyline onward = {place};
      onward.insert(onward.end(), path.begin(), path.end());
      onward = Shorten(onward);
      if (!FindTurn({place, pose.theta}, FirstDirection(onward))) continue;
      const std::optional<Leg> leg =
          FitLeg({pose.position(), place}, {pose.position(), travel, 0.0},
                 {place, travel, 0.0}, reverse);
      if (!leg) continue;
      Manoeuvre manoeuvre = {*leg};
      const std::optional<Manoeuvre> rest =
          TurnThenDrive(vfh_astar::EndOf(manoeuvre), onward, end_heading);
      if (!rest) continue;
      Append(manoeuvre, *rest);
      return manoeuvre;
    }
  }
  return std::nullopt;
}

std::optional<Manoeuvre> ManoeuvreFinder::Find(
    const Departure& departure, const Polyline& path,
    std::optional<double> end_heading) {
  effort_left_ = std::min(kFindEffort + 5.0 * Length(path), total_effort_left_);
  if (departure.moving) return Drive(departure, path, end_heading);
  const Pose2D& pose = departure.pose;
  const double off =
      std::abs(NormalizeAngle(FirstDirection(Shorten(path)) - pose.theta));
  std::optional<Manoeuvre> found;
  if (off <= parameters_.turn_threshold) {
    found = Drive(departure, path, end_heading);
  }
  if (!found) found = TurnThenDrive(pose, path, end_heading);
  if (!found && off > 0.5 * kPi && parameters_.may_reverse) {
    found = BackOutThenDrive(pose, path, end_heading);
  }
  if (!found && off > parameters_.turn_threshold && off <= 0.5 * kPi) {
    found = Drive(departure, path, end_heading);
  }
  if (!found) found = ShiftThenDrive(pose, path, end_heading);
  return found;
}

std::optional<Manoeuvre> ManoeuvreFinder::FindStraightIn(
    const Departure& departure, const Polyline& path, const Pose2D& goal) {
  for (double back = kPlaceSpacing; back <= kMaxShift; back += kPlaceSpacing) {
    for (const bool reverse : {false, true}) {
      if (reverse && !parameters_.may_reverse) continue;
      const double travel = goal.theta + (reverse ? kPi : 0.0);
      const Eigen::Vector2d place =
          goal.position() -
          back * Eigen::Vector2d(std::cos(travel), std::sin(travel));
      const Polyline way = PathTo(place, path);
      const Pose2D arrival(place, LastDirection(Shorten(way)));
      if (!FindTurn(arrival, goal.theta)) continue;
      const std::optional<Leg> last =
          FitLeg({place, goal.position()}, {place, travel, 0.0},
                 {goal.position(), travel, 0.0}, reverse);
      if (!last) continue;
      std::optional<Manoeuvre> manoeuvre = Find(departure, way, std::nullopt);
      if (!manoeuvre) return std::nullopt;
      const std::optional<Turn> turn =
          FindTurn(vfh_astar::EndOf(*manoeuvre), goal.theta);
      if (!turn) continue;
      manoeuvre->push_back(*turn);
      manoeuvre->push_back(*last);
      return manoeuvre;
    }
  }
  return std::nullopt;
}

std::optional<Manoeuvre> ManoeuvreFinder::FindTailFirst(
    const Departure& departure, const Polyline& path, double heading) {
  const double length = Length(path);
  for (double back = 3.0 * kPlaceSpacing; back < length - kMinLeg;
       back += kPlaceSpacing) {
    const SplitLine parts = SplitAt(path, length - back);
    const Polyline line = Shorten(parts.after);
    const double travel = FirstDirection(line);
    const Pose2D stop(line.front(), LastDirection(Shorten(parts.before)));
    if (!FindTurn(stop, travel + kPi)) continue;
    const std::optional<Leg> last =
        FitLeg(line, {line.front(), travel, 0.0},
               {line.back(), heading + kPi, 0.0}, true);
    if (!last) return std::nullopt;
    std::optional<Manoeuvre> manoeuvre =
        Find(departure, parts.before, std::nullopt);
    if (!manoeuvre) return std::nullopt;
    const std::optional<Turn> turn =
        FindTurn(vfh_astar::EndOf(*manoeuvre), travel + kPi);
    if (!turn) continue;
    manoeuvre->push_back(*turn);
    manoeuvre->push_back(*last);
    return manoeuvre;
  }
  return std::nullopt;
}

}  // namespace vfh_astar
