#include "vfh_astar/trajectory/trajectory_fitter.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <utility>
#include <variant>

#include "vfh_astar/trajectory/manoeuvre.h"
#include "vfh_astar/trajectory/paper_fit.h"
#include "vfh_astar/trajectory/path_shortening.h"
#include "vfh_astar/trajectory/pose_check.h"
#include "vfh_astar/trajectory/timing.h"

namespace vfh_astar {
namespace {

// Below these the robot counts as standing: what it does then is over within a
// control cycle.
constexpr double kStandingV = 0.05;  // m/s
constexpr double kStandingW = 0.02;  // rad/s
// On tighter arcs (1/m) than this the robot stops before it drives on.
constexpr double kMaxStartCurvature = 8.0;
// A goal nearer than this (m) is reached already.
constexpr double kArrived = 0.02;
// rad by which a heading may stay off before a turn is worth a piece.
constexpr double kAligned = 0.01;

std::string At(const char* what, const Eigen::Vector2d& point) {
  std::array<char, 160> text;
  std::snprintf(text.data(), text.size(), "%s (%.2f, %.2f)", what, point.x(),
                point.y());
  return text.data();
}

FitResult Failure(std::string message) {
  FitResult result;
  result.outcome = Outcome::kNoTrajectory;
  result.message = std::move(message);
  return result;
}

// The path with the start's and the goal's exact places at its ends and without
// repeated points.
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

// The path from its point nearest to `from` on, which lies off it.
Polyline PathFrom(const Eigen::Vector2d& from, const Polyline& path) {
  const auto nearest = std::min_element(
      path.begin(), path.end(),
      [&from](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
        return (a - from).squaredNorm() < (b - from).squaredNorm();
      });
  Polyline rest = {from};
  for (auto point = nearest; point != path.end(); ++point) {
    if ((*point - rest.back()).norm() > 1e-3) rest.push_back(*point);
  }
  return rest;
}

// Points along the arc that the robot is on, for a stop that keeps to it.
Polyline ArcAhead(const Reference& start, double length) {
  constexpr int kParts = 8;
  const double sign = start.twist.v < 0.0 ? -1.0 : 1.0;
  const double curvature = start.twist.w / std::abs(start.twist.v);
  Polyline points;
  for (int i = 0; i <= kParts; ++i) {
    const double s = length * i / kParts;
    points.push_back(Integrate(start.pose, {sign, curvature}, s).position());
  }
  return points;
}

ManoeuvreParameters FinderParameters(const TrajectoryFitterParameters& p) {
  ManoeuvreParameters parameters;
  parameters.turn_threshold = p.turn_threshold;
  parameters.fast_room = p.clearance_fast;
  parameters.may_reverse = p.limits.max_v_reverse > 0.0;
  return parameters;
}

// One request's way to a trajectory.
class PiecewiseFit {
 public:
  PiecewiseFit(const TrajectoryFitterParameters& parameters,
               const FitRequest& request, const ClearanceMap& clearance)
      : parameters_(parameters),
        request_(request),
        check_(parameters.footprint, clearance, parameters.safety_margin,
               request.start.pose),
        finder_(check_, FinderParameters(parameters)),
        path_(CleanPath(request)) {}

  FitResult Run() {
    const Twist2D& twist = request_.start.twist;
    if (std::abs(twist.v) < kStandingV) return FromTurn();
    if (twist.v > 0.0 && std::abs(twist.w) <= kMaxStartCurvature * twist.v) {
      if (const std::optional<FitResult> joined = Join()) return *joined;
    }
    return StopFirst();
  }

 private:
  // From rest, or out of a turn on the spot, which is braked first.
  FitResult FromTurn() {
    const double w = request_.start.twist.w;
    Pose2D pose = request_.start.pose;
    Manoeuvre manoeuvre;
    if (std::abs(w) >= kStandingW) {
      start_w_ = w;
      const double angle =
          w * std::abs(w) / (2.0 * parameters_.limits.max_angular_acceleration);
      manoeuvre.push_back(Turn{pose, angle});
      pose.theta = NormalizeAngle(pose.theta + angle);
    }
    Departure departure;
    departure.pose = pose;
    if (!Complete(departure, path_, manoeuvre)) return Blocked();
    return Timed(manoeuvre);
  }

  // Leaves the running motion without a stop; nothing when its speed is too
  // high for every way of doing so.
  std::optional<FitResult> Join() {
    const Reference& start = request_.start;
    Departure departure;
    departure.pose = start.pose;
    departure.moving = true;
    departure.curvature = start.twist.w / start.twist.v;
    const double braking = start.twist.v * start.twist.v /
                           (2.0 * parameters_.limits.max_deceleration);
    if (Length(path_) < std::max(braking, 2.0 * kArrived)) return std::nullopt;
    const double swing =
        std::max(0.3, start.twist.v * start.twist.v /
                          parameters_.limits.max_lateral_acceleration);
    for (const double lead : {0.0, 0.5 * swing, swing, 2.0 * swing}) {
      Polyline path = path_;
      if (lead > 0.0) {
        if (Length(path_) <= 2.0 * lead) break;
        departure.lead = ArcAhead(start, 0.5 * lead);
        path = SplitAt(path_, lead).after;
      }
      Manoeuvre manoeuvre;
      if (!Complete(departure, path, manoeuvre)) continue;
      FitResult result = Timed(manoeuvre);
      if (keeps_limits_) return result;
    }
    return std::nullopt;
  }

  // Brakes along the arc that the robot is on, a little farther where there is
  // no room to go on from, and continues from rest.
  FitResult StopFirst() {
    const Reference& start = request_.start;
    const RobotLimits& limits = parameters_.limits;
    const bool reverse = start.twist.v < 0.0;
    const double curvature = start.twist.w / std::abs(start.twist.v);
    const double travel = start.pose.theta + (reverse ? kPi : 0.0);
    const double braking = std::min(
        limits.max_deceleration,
        limits.max_angular_acceleration / std::max(std::abs(curvature), 1e-6));
    for (const double reserve : {1.1, 1.5, 2.5}) {
      const double length = std::max(
          0.02, reserve * start.twist.v * start.twist.v / 2.0 / braking);
      const Polyline arc = ArcAhead(start, length);
      const CurveEnd end{arc.back(), travel + curvature * length, curvature};
      const std::optional<Leg> leg =
          finder_.FitLeg(arc, {arc.front(), travel, curvature}, end, reverse);
      if (!leg) break;
      Manoeuvre manoeuvre = {*leg};
      Departure departure;
      departure.pose = EndOf(manoeuvre);
      const Eigen::Vector2d stop = departure.pose.position();
      if (Complete(departure, PathFrom(stop, path_), manoeuvre)) {
        return Timed(manoeuvre);
      }
    }
    return Blocked();
  }

  // Adds the way along the path and the turn to the goal's heading.
  bool Complete(const Departure& departure, const Polyline& path,
                Manoeuvre& manoeuvre) {
    note_.clear();
    const double heading = request_.goal.theta;
    if (Length(path) <= kArrived) {
      return TurnAtGoal(departure.pose, manoeuvre);
    }
    const Polyline shortened = finder_.Shorten(path);
    const Eigen::Vector2d last =
        shortened.back() - shortened[shortened.size() - 2];
    const double off =
        std::abs(NormalizeAngle(heading - std::atan2(last.y(), last.x())));
    std::optional<Manoeuvre> found;
    if (off <= parameters_.turn_threshold) {
      found = finder_.Find(departure, path, heading);
    }
    if (!found) found = WithTurnAtGoal(departure, path, off);
    if (!found) return false;
    manoeuvre.insert(manoeuvre.end(), found->begin(), found->end());
    return true;
  }

  bool TurnAtGoal(const Pose2D& pose, Manoeuvre& manoeuvre) {
    if (std::abs(NormalizeAngle(request_.goal.theta - pose.theta)) < kAligned) {
      return true;
    }
    const std::optional<Turn> turn =
        finder_.FindTurn(pose, request_.goal.theta);
    if (!turn) return false;
    manoeuvre.push_back(*turn);
    return true;
  }

  std::optional<Manoeuvre> WithTurnAtGoal(const Departure& departure,
                                          const Polyline& path, double off) {
    std::optional<Manoeuvre> found =
        finder_.Find(departure, path, std::nullopt);
    if (found && TurnAtGoal(EndOf(*found), *found)) return found;

    // No room to turn there: arrive with the heading.
    std::optional<Manoeuvre> other;
    if (off > parameters_.turn_threshold) {
      other = finder_.Find(departure, path, request_.goal.theta);
    }
    if (!other) other = finder_.FindStraightIn(departure, path, request_.goal);
    if (!other && parameters_.limits.max_v_reverse > 0.0) {
      other = finder_.FindTailFirst(departure, path, request_.goal.theta);
    }
    if (other) return other;
    if (found) {
      note_ = At("no room to turn to the goal's heading at",
                 request_.goal.position());
    }
    return found;
  }

  FitResult Blocked() const {
    if (finder_.blocked_at()) {
      return Failure(At("no trajectory: the footprint does not fit at",
                        *finder_.blocked_at()));
    }
    return Failure(At("no trajectory: there is no room to turn at",
                      request_.start.pose.position()));
  }

  FitResult Timed(const Manoeuvre& manoeuvre) {
    keeps_limits_ = true;
    std::vector<TrajectoryPiece> pieces;
    for (std::size_t i = 0; i < manoeuvre.size(); ++i) {
      const std::vector<TrajectoryPiece> more =
          Timed(manoeuvre[i], /*is_first=*/i == 0);
      pieces.insert(pieces.end(), more.begin(), more.end());
    }
    if (pieces.empty()) pieces.push_back(Stand());
    FitResult result;
    result.trajectory = Trajectory(std::move(pieces));
    result.message = note_;
    return result;
  }

  std::vector<TrajectoryPiece> Timed(const std::variant<Leg, Turn>& stage,
                                     bool is_first) {
    if (const Turn* turn = std::get_if<Turn>(&stage)) {
      return TimeTurn(turn->pose, turn->angle, is_first ? start_w_ : 0.0,
                      parameters_.limits);
    }
    const Leg& leg = std::get<Leg>(stage);
    DriveStart start;
    const Reference& from = request_.start;
    if (is_first && std::abs(from.twist.v) >= kStandingV &&
        (from.twist.v < 0.0) == leg.reverse) {
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
  TrajectoryPiece Stand() const {
    TrajectoryPiece piece;
    piece.kind = TrajectoryPiece::Kind::kTurn;
    piece.duration = 0.02;
    piece.x[0] = request_.start.pose.x;
    piece.y[0] = request_.start.pose.y;
    piece.heading[0] = request_.start.pose.theta;
    return piece;
  }

  const TrajectoryFitterParameters& parameters_;
  const FitRequest& request_;
  PoseCheck check_;
  ManoeuvreFinder finder_;
  Polyline path_;
  double start_w_ = 0.0;      ///< rad/s, of a turn that is braked first.
  bool keeps_limits_ = true;  ///< of what was timed last.
  std::string note_;
};

}  // namespace

void TrajectoryFitterParameters::Read(ParameterReader& reader) {
  reader.Choice("fit", fit, {"piecewise", "quintic"});
  reader.Group("footprint", footprint);
  reader.Group("limits", limits);
  reader.Integer("occupied_threshold", occupied_threshold, 1, 100);
  reader.Number("safety_margin", safety_margin, 0.0, 1.0);
  reader.Number("time_per_metre", time_per_metre, 0.05, 100.0);
  reader.Number("clearance_slow", clearance_slow, 0.0, 5.0);
  reader.Number("clearance_fast", clearance_fast, 0.0, 5.0);
  reader.Number("max_v_near", max_v_near, 0.05, 20.0);
  reader.Number("turn_threshold", turn_threshold, 0.0, kPi);
  if (clearance_fast < clearance_slow) {
    throw ParameterError("clearance_fast is " + std::to_string(clearance_fast) +
                         ", expected at least clearance_slow (" +
                         std::to_string(clearance_slow) + ")");
  }
}

TrajectoryFitter::TrajectoryFitter(const TrajectoryFitterParameters& parameters)
    : parameters_(parameters) {}

FitResult TrajectoryFitter::Fit(const FitRequest& request,
                                const ClearanceMap& clearance) const {
  assert(!request.path.empty());
  if (parameters_.fit == "piecewise") {
    return PiecewiseFit(parameters_, request, clearance).Run();
  }
  const Polyline path = CleanPath(request);
  if (Length(path) <= kArrived) {
    return PiecewiseFit(parameters_, request, clearance).Run();
  }
  FitResult result;
  const Eigen::Vector2d velocity =
      request.start.twist.v * request.start.pose.heading();
  result.trajectory =
      FitSingleQuintic(path, velocity, parameters_.time_per_metre);
  return result;
}

}  // namespace vfh_astar
