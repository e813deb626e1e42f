#include "vfh_astar/trajectory/arrival_finder.h"

#include <cmath>
#include <utility>

namespace vfh_astar {
namespace {

// m between places that are tried for a turn.
constexpr double kPlaceSpacing = 0.1;
// m that the robot drives straight into the goal.
constexpr double kMaxStraight = 1.2;
constexpr double kMinLeg = 0.05;  // m
// rad by which a heading may stay off before a turn is worth it.
constexpr double kAligned = 0.01;

}  // namespace

ArrivalFinder::ArrivalFinder(LegSearch& search,
                             const ManoeuvreParameters& parameters)
    : search_(search), parameters_(parameters), finder_(search, parameters) {}

std::optional<Arrival> ArrivalFinder::Find(const Departure& departure,
                                           const Polyline& path,
                                           const Pose2D& goal) {
  if (Length(path) <= kArrived) {
    Manoeuvre turn;
    if (!AddTurn(departure.pose, goal.theta, turn)) return std::nullopt;
    return Arrival{std::move(turn), true};
  }
  const double off =
      std::abs(NormalizeAngle(goal.theta - search_.DirectionInto(path)));
  if (off <= parameters_.turn_threshold) {
    std::optional<Manoeuvre> bending =
        finder_.Find(departure, path, goal.theta);
    if (bending) return Arrival{std::move(*bending), true};
  }
  std::optional<Manoeuvre> plain = finder_.Find(departure, path, std::nullopt);
  if (plain && AddTurn(EndOf(*plain), goal.theta, *plain)) {
    return Arrival{std::move(*plain), true};
  }
  std::optional<Manoeuvre> other = WithHeading(departure, path, goal);
  if (other) return Arrival{std::move(*other), true};
  if (plain) return Arrival{std::move(*plain), false};
  return std::nullopt;
}

bool ArrivalFinder::AddTurn(const Pose2D& pose, double heading,
                            Manoeuvre& manoeuvre) const {
  if (std::abs(NormalizeAngle(heading - pose.theta)) < kAligned) return true;
  const std::optional<Turn> turn = search_.FindTurn(pose, heading);
  if (!turn) return false;
  manoeuvre.push_back(*turn);
  return true;
}

std::optional<Manoeuvre> ArrivalFinder::WithHeading(const Departure& departure,
                                                    const Polyline& path,
                                                    const Pose2D& goal) {
  std::optional<Manoeuvre> found = finder_.Find(departure, path, goal.theta);
  if (!found) found = StraightIn(departure, path, goal);
  if (!found && parameters_.may_reverse) {
    found = TailFirst(departure, path, goal.theta);
  }
  return found;
}

std::optional<Manoeuvre> ArrivalFinder::StraightIn(const Departure& departure,
                                                   const Polyline& path,
                                                   const Pose2D& goal) {
  for (double back = kPlaceSpacing; back <= kMaxStraight;
       back += kPlaceSpacing) {
    for (const bool reverse : {false, true}) {
      if (reverse && !parameters_.may_reverse) continue;
      const double travel = goal.theta + (reverse ? kPi : 0.0);
      const Eigen::Vector2d place =
          goal.position() -
          back * Eigen::Vector2d(std::cos(travel), std::sin(travel));
      const Polyline way = PathTo(place, path);
      const Pose2D arrival(place, search_.DirectionInto(way));
      if (!search_.FindTurn(arrival, goal.theta)) continue;
      const std::optional<Leg> last =
          search_.FitLeg({place, goal.position()}, {place, travel, 0.0},
                         {goal.position(), travel, 0.0}, reverse);
      if (!last) continue;
      std::optional<Manoeuvre> manoeuvre =
          finder_.Find(departure, way, std::nullopt);
      if (!manoeuvre) return std::nullopt;
      const std::optional<Turn> turn =
          search_.FindTurn(EndOf(*manoeuvre), goal.theta);
      if (!turn) continue;
      manoeuvre->push_back(*turn);
      manoeuvre->push_back(*last);
      return manoeuvre;
    }
  }
  return std::nullopt;
}

std::optional<Manoeuvre> ArrivalFinder::TailFirst(const Departure& departure,
                                                  const Polyline& path,
                                                  double heading) {
  const double length = Length(path);
  for (double back = 3.0 * kPlaceSpacing; back < length - kMinLeg;
       back += kPlaceSpacing) {
    const SplitLine parts = SplitAt(path, length - back);
    const Polyline line = search_.Shorten(parts.after);
    const double travel = FirstDirection(line);
    const Pose2D stop(line.front(), search_.DirectionInto(parts.before));
    if (!search_.FindTurn(stop, travel + kPi)) continue;
    const std::optional<Leg> last =
        search_.FitLeg(line, {line.front(), travel, 0.0},
                       {line.back(), heading + kPi, 0.0}, true);
    if (!last) return std::nullopt;
    std::optional<Manoeuvre> manoeuvre =
        finder_.Find(departure, parts.before, std::nullopt);
    if (!manoeuvre) return std::nullopt;
    const std::optional<Turn> turn =
        search_.FindTurn(EndOf(*manoeuvre), travel + kPi);
    if (!turn) continue;
    manoeuvre->push_back(*turn);
    manoeuvre->push_back(*last);
    return manoeuvre;
  }
  return std::nullopt;
}

}  // namespace vfh_astar
