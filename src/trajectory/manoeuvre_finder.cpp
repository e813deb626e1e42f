#include "vfh_astar/trajectory/manoeuvre_finder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace vfh_astar {
namespace {

// m of curves that one call may fit, with five times the path's length.
constexpr double kFindEffort = 250.0;
// m between places along the path that are tried for a turn.
constexpr double kPlaceSpacing = 0.1;
// m from where a leg was blocked to where a stop is looked for.
constexpr double kStopReach = 1.5;
// m that the robot shifts to find room to turn.
constexpr double kMaxShift = 1.2;
// 1/m of the arcs that it shifts along; gentle ones lead away from a wall
// without the far corner touching it.
constexpr std::array<double, 5> kShiftCurvatures = {0.0, -0.3, 0.3, -1.0, 1.0};
constexpr double kMinLeg = 0.05;   // m
constexpr double kAligned = 1e-3;  // rad

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

}  // namespace

ManoeuvreFinder::ManoeuvreFinder(LegSearch& search,
                                 const ManoeuvreParameters& parameters)
    : search_(search), parameters_(parameters) {}

std::optional<Manoeuvre> ManoeuvreFinder::Drive(
    const Departure& departure, const Polyline& path,
    std::optional<double> end_heading) {
  Polyline line = departure.lead;
  const Polyline shortened = search_.Shorten(path);
  line.insert(line.end(), shortened.begin(), shortened.end());
  const Pose2D& pose = departure.pose;
  const CurveEnd start{pose.position(), pose.theta, departure.curvature};
  const std::optional<Leg> leg =
      search_.FitLeg(line, start, EndAlong(line, end_heading), false);
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
  const Polyline shortened = search_.Shorten(path);
  whole.insert(whole.end(), shortened.begin(), shortened.end());
  if (search_.IsHopeless(whole, start, EndAlong(whole, end_heading), false)) {
    return std::nullopt;
  }
  const double length = Length(path);
  const double blocked = NearestPlace(path, search_.last_blocked());
  for (const double place : PlacesAround(blocked, kStopReach, length)) {
    if (search_.IsExhausted()) return std::nullopt;
    const SplitLine parts = SplitAt(path, place);
    // A cheap look before the fit: the turn between the lines' directions.
    const Pose2D stop(parts.after.front(), search_.DirectionInto(parts.before));
    if (!search_.FindTurn(stop, search_.DirectionFrom(parts.after))) continue;

    Polyline line = departure.lead;
    const Polyline before = search_.Shorten(parts.before);
    line.insert(line.end(), before.begin(), before.end());
    const std::optional<Leg> leg =
        search_.FitLeg(line, start, EndAlong(line), false);
    if (!leg) continue;
    Manoeuvre manoeuvre = {*leg};
    const std::optional<Manoeuvre> rest =
        TurnThenDrive(EndOf(manoeuvre), parts.after, end_heading);
    if (!rest) continue;
    Append(manoeuvre, *rest);
    return manoeuvre;
  }
  return std::nullopt;
}

std::optional<Manoeuvre> ManoeuvreFinder::TurnThenDrive(
    const Pose2D& pose, const Polyline& path,
    std::optional<double> end_heading) {
  const double direction = search_.DirectionFrom(path);
  Manoeuvre manoeuvre;
  if (std::abs(NormalizeAngle(direction - pose.theta)) > kAligned) {
    const std::optional<Turn> turn = search_.FindTurn(pose, direction);
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
    const Polyline line = search_.Shorten(parts.before);
    const Pose2D stop(parts.after.front(), LastDirection(line) + kPi);
    if (!search_.FindTurn(stop, search_.DirectionFrom(parts.after))) continue;
    const std::optional<Leg> leg =
        search_.FitLeg(line, start, EndAlong(line), true);
    if (!leg) return std::nullopt;
    Manoeuvre manoeuvre = {*leg};
    const std::optional<Manoeuvre> rest =
        TurnThenDrive(EndOf(manoeuvre), parts.after, end_heading);
    if (!rest) continue;
    Append(manoeuvre, *rest);
    return manoeuvre;
  }
  // There is room nowhere: the whole way backwards.
  const Polyline line = search_.Shorten(path);
  CurveEnd end = EndAlong(line);
  if (end_heading) end.heading = *end_heading + kPi;
  const std::optional<Leg> leg = search_.FitLeg(line, start, end, true);
  if (!leg) return std::nullopt;
  return Manoeuvre{*leg};
}

std::optional<Manoeuvre> ManoeuvreFinder::ShiftThenDrive(
    const Pose2D& pose, const Polyline& path,
    std::optional<double> end_heading) {
  for (double shift = kPlaceSpacing; shift <= kMaxShift;
       shift += kPlaceSpacing) {
    for (const double curvature : kShiftCurvatures) {
      for (const bool reverse : {false, true}) {
        if (reverse && !parameters_.may_reverse) continue;
        const std::optional<Leg> leg =
            FitShift(pose, {shift, curvature, curvature, reverse}, path);
        if (!leg) continue;
        Manoeuvre manoeuvre = {*leg};
        const Pose2D place = EndOf(manoeuvre);
        const std::optional<Manoeuvre> rest =
            TurnThenDrive(place, PathFrom(place.position(), path), end_heading);
        if (!rest) continue;
        Append(manoeuvre, *rest);
        return manoeuvre;
      }
    }
  }
  return std::nullopt;
}

std::optional<Leg> ManoeuvreFinder::FitShift(const Pose2D& from,
                                             const ArcShape& arc,
                                             const Polyline& path) {
  const Polyline line = Points(arc, from);
  const Pose2D place(line.back(), from.theta + arc.turn());
  if (!search_.check().IsFree(place)) return std::nullopt;
  const double onward = search_.DirectionFrom(PathFrom(place.position(), path));
  if (!search_.FindTurn(place, onward)) return std::nullopt;
  const double tail = arc.reverse ? kPi : 0.0;
  return search_.FitLeg(line, {line.front(), from.theta + tail, arc.curvature},
                        {line.back(), place.theta + tail, arc.curvature},
                        arc.reverse);
}

std::optional<Manoeuvre> ManoeuvreFinder::Find(
    const Departure& departure, const Polyline& path,
    std::optional<double> end_heading) {
  search_.Begin(kFindEffort + 5.0 * Length(path));
  if (departure.moving) return Drive(departure, path, end_heading);
  const Pose2D& pose = departure.pose;
  const double off =
      std::abs(NormalizeAngle(search_.DirectionFrom(path) - pose.theta));
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

}  // namespace vfh_astar
