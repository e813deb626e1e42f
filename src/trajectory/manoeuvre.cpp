#include "vfh_astar/trajectory/manoeuvre.h"

#include <cassert>

namespace vfh_astar {

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

void Append(Manoeuvre& manoeuvre, const Manoeuvre& more) {
  manoeuvre.insert(manoeuvre.end(), more.begin(), more.end());
}

}  // namespace vfh_astar
