#include "vfh_astar/trajectory/piecewise_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <utility>

#include "vfh_astar/trajectory/timing.h"

namespace vfh_astar {
namespace {

// Below these the robot counts as standing: what it does then is over within a
// control cycle.
constexpr double kStandingV = 0.05;  // m/s
constexpr double kStandingW = 0.02;  // rad/s
// On tighter arcs (1/m) than this the robot stops before it drives on.
constexpr double kMaxStartCurvature = 8.0;
constexpr double kMinStop = 0.02;  // m

std::string At(const char* what, const Eigen::Vector2d& point) {
  std::array<char, 160> text;
  std::snprintf(text.data(), text.size(), "%s (%.2f, %.2f)", what, point.x(),
                point.y());
  return text.data();
}

ManoeuvreParameters FinderParameters(const TrajectoryFitterParameters& p) {
  ManoeuvreParameters parameters;
  parameters.turn_threshold = p.turn_threshold;
  parameters.may_reverse = p.limits.max_v_reverse > 0.0;
  return parameters;
}

// 1/m; see Arc.
double CurvatureOf(const Twist2D& twist) { return twist.w / std::abs(twist.v); }

}  // namespace

Polyline CleanPath(const FitRequest& request) {
  Polyline path = {request.start.pose.position()};
  constexpr double kSame = 1e-3;
  for (std::size_t i = 1; i + 1 < request.path.size(); ++i) {
    if ((request.path[i] - path.back()).norm() > kSame) {
      path.push_back(request.path[i]);
    }
  }
  const Eigen::Vector2d goal = request.goal.position();
  while (path.size() > 1 && (path.back() - goal).norm() <= kSame) {
    path.pop_back();
  }
  path.push_back(goal);
  return path;
}

PiecewiseFit::PiecewiseFit(const TrajectoryFitterParameters& parameters,
                           const FitRequest& request,
                           const ClearanceMap& clearance)
    : parameters_(parameters),
      request_(request),
      check_(parameters.footprint, clearance, parameters.safety_margin,
             request.start.pose),
      search_(check_, parameters.clearance_fast),
      finder_(search_, FinderParameters(parameters)),
      path_(CleanPath(request)) {}

FitResult PiecewiseFit::Run() {
  const Twist2D& twist = request_.start.twist;
  if (std::abs(twist.v) < kStandingV) return FromRest();
  if (twist.v > 0.0 && std::abs(CurvatureOf(twist)) <= kMaxStartCurvature) {
    if (const std::optional<FitResult> joined = Join()) return *joined;
  }
  return StopFirst();
}

// Also out of a turn on the spot, which is braked first.
FitResult PiecewiseFit::FromRest() {
  const double w = request_.start.twist.w;
  Departure departure;
  departure.pose = request_.start.pose;
  Manoeuvre manoeuvre;
  if (std::abs(w) >= kStandingW) {
    const double angle =
        w * std::abs(w) / (2.0 * parameters_.limits.max_angular_acceleration);
    manoeuvre.push_back(Turn{departure.pose, angle});
    departure.pose = EndOf(manoeuvre);
  }
  const std::optional<Manoeuvre> found = Complete(departure, path_);
  if (!found) return Blocked();
  Append(manoeuvre, *found);
  return Time(manoeuvre);
}

// Leaves the running motion without a stop; nothing when its speed is too high
// for every way of doing so.
std::optional<FitResult> PiecewiseFit::Join() {
  const Reference& start = request_.start;
  const double squared = start.twist.v * start.twist.v;
  const double braking = squared / (2.0 * parameters_.limits.max_deceleration);
  if (Length(path_) < std::max(braking, 2.0 * ArrivalFinder::kArrived)) {
    return std::nullopt;
  }
  Departure departure;
  departure.pose = start.pose;
  departure.moving = true;
  departure.curvature = CurvatureOf(start.twist);
  // What the tightest bend at this speed takes.
  const double swing =
      std::max(0.3, squared / parameters_.limits.max_lateral_acceleration);
  for (const double lead : {0.0, 0.5 * swing, swing, 2.0 * swing}) {
    if (Length(path_) < 2.0 * lead) break;
    Polyline path = path_;
    if (lead > 0.0) {
      departure.lead =
          Points({0.5 * lead, departure.curvature, departure.curvature, false},
                 start.pose);
      path = SplitAt(path_, lead).after;
    }
    const std::optional<Manoeuvre> found = Complete(departure, path);
    if (!found) continue;
    FitResult result = Time(*found);
    if (keeps_limits_) return result;
  }
  return std::nullopt;
}

// Brakes along the arc that the robot is on, or on one that bends off where
// that is not free, a little farther where there is no room to go on from; and
// continues from rest.
FitResult PiecewiseFit::StopFirst() {
  const double curvature = CurvatureOf(request_.start.twist);
  for (const double reserve : {1.1, 1.5, 2.5}) {
    for (const double bend : {0.0, -curvature, -0.7, 0.7, -1.4, 1.4}) {
      search_.RenewEffort();
      const std::optional<Leg> leg = StoppingLeg(reserve, curvature + bend);
      if (!leg) continue;
      const std::optional<Manoeuvre> onward = FromStop(*leg);
      if (!onward) continue;
      Manoeuvre manoeuvre = {*leg};
      Append(manoeuvre, *onward);
      FitResult result = Time(manoeuvre);
      // Its own arc is the best that a start beyond its limits can do.
      if (keeps_limits_ || bend == 0.0) return result;
    }
  }
  return Blocked();
}

// On from there, or back the way it came.
std::optional<Manoeuvre> PiecewiseFit::FromStop(const Leg& leg) {
  Departure departure;
  departure.pose = EndOf({leg});
  Polyline back;
  for (const CurvePoint& point : leg.points) back.push_back(point.position);
  std::reverse(back.begin(), back.end());
  back.insert(back.end(), path_.begin() + 1, path_.end());
  for (const Polyline& way :
       {PathFrom(departure.pose.position(), path_), back}) {
    std::optional<Manoeuvre> found = Complete(departure, way);
    if (found) return found;
  }
  return std::nullopt;
}

std::optional<Leg> PiecewiseFit::StoppingLeg(double reserve,
                                             double end_curvature) {
  const Reference& start = request_.start;
  const RobotLimits& limits = parameters_.limits;
  ArcShape arc;
  arc.curvature = CurvatureOf(start.twist);
  arc.end_curvature = end_curvature;
  arc.reverse = start.twist.v < 0.0;
  double braking = limits.max_deceleration;
  if (arc.curvature != 0.0) {
    braking = std::min(
        braking, limits.max_angular_acceleration / std::abs(arc.curvature));
  }
  const double squared = start.twist.v * start.twist.v;
  arc.length = std::max(kMinStop, reserve * squared / (2.0 * braking));
  const Polyline line = Points(arc, start.pose);
  const double travel = start.pose.theta + (arc.reverse ? kPi : 0.0);
  return search_.FitLeg(line, {line.front(), travel, arc.curvature},
                        {line.back(), travel + arc.turn(), arc.end_curvature},
                        arc.reverse);
}

std::optional<Manoeuvre> PiecewiseFit::Complete(const Departure& departure,
                                                const Polyline& path) {
  std::optional<Arrival> arrival = finder_.Find(departure, path, request_.goal);
  if (!arrival) return std::nullopt;
  has_heading_ = arrival->has_heading;
  return std::move(arrival->manoeuvre);
}

FitResult PiecewiseFit::Time(const Manoeuvre& manoeuvre) {
  keeps_limits_ = true;
  std::vector<TrajectoryPiece> pieces;
  for (std::size_t i = 0; i < manoeuvre.size(); ++i) {
    const std::vector<TrajectoryPiece> more =
        Time(manoeuvre[i], /*is_first=*/i == 0);
    pieces.insert(pieces.end(), more.begin(), more.end());
  }
  if (pieces.empty()) pieces.push_back(Stand());
  FitResult result;
  result.trajectory = Trajectory(std::move(pieces));
  if (!has_heading_) {
    result.message = At("no room to turn to the goal's heading at",
                        request_.goal.position());
  }
  return result;
}

std::vector<TrajectoryPiece> PiecewiseFit::Time(
    const std::variant<Leg, Turn>& stage, bool is_first) {
  const Reference& from = request_.start;
  const bool moves = std::abs(from.twist.v) >= kStandingV;
  if (const Turn* turn = std::get_if<Turn>(&stage)) {
    const bool turns = is_first && std::abs(from.twist.w) >= kStandingW;
    return TimeTurn(turn->pose, turn->angle, turns ? from.twist.w : 0.0,
                    parameters_.limits);
  }
  const Leg& leg = std::get<Leg>(stage);
  DriveStart start;
  if (is_first && moves) {
    start.speed = std::abs(from.twist.v);
    start.acceleration = leg.reverse ? -from.acceleration : from.acceleration;
  }
  const RoomSpeed rule = {parameters_.clearance_slow,
                          parameters_.clearance_fast, parameters_.max_v_near};
  TimedPieces timed = TimeDrive(leg.points, leg.reverse, start,
                                parameters_.limits, rule, check_);
  keeps_limits_ = keeps_limits_ && timed.keeps_limits;
  return std::move(timed.pieces);
}

// A moment's rest, for a start that is the goal.
TrajectoryPiece PiecewiseFit::Stand() const {
  TrajectoryPiece piece;
  piece.kind = TrajectoryPiece::Kind::kTurn;
  piece.duration = 0.02;
  piece.x[0] = request_.start.pose.x;
  piece.y[0] = request_.start.pose.y;
  piece.heading[0] = request_.start.pose.theta;
  return piece;
}

FitResult PiecewiseFit::Blocked() const {
  FitResult result;
  result.outcome = Outcome::kNoTrajectory;
  result.message = search_.first_blocked()
                       ? At("no trajectory: the footprint does not fit at",
                            *search_.first_blocked())
                       : At("no trajectory: there is no room to turn at",
                            request_.start.pose.position());
  return result;
}

}  // namespace vfh_astar
