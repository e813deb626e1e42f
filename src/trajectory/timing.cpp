#include "vfh_astar/trajectory/timing.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>

#include "vfh_astar/trajectory/speed_profile.h"

namespace vfh_astar {
double SpeedAtCurvature(double curvature, double max_v,
                        const RobotLimits& limits) {
  const double bend = std::abs(curvature);
  double v = std::min(max_v, limits.max_wheel_speed /
                                 (1.0 + 0.5 * limits.wheel_separation * bend));
  if (bend > 0.0) {
    v = std::min({v, limits.max_w / bend,
                  std::sqrt(limits.max_lateral_acceleration / bend)});
  }
  return v;
}

double SpeedAtRoom(double room, double max_v, const RoomSpeed& rule) {
  const double near_speed = std::min(rule.near_speed, max_v);
  if (room >= rule.fast_room) return max_v;
  if (room <= rule.slow_room) {
    const double share =
        rule.slow_room > 0.0 ? std::max(room / rule.slow_room, 0.25) : 1.0;
    return near_speed * share;
  }
  const double share =
      (room - rule.slow_room) / (rule.fast_room - rule.slow_room);
  return near_speed + share * (max_v - near_speed);
}

namespace {

// rad between the nodes of a turn.
constexpr double kTurnSpan = 0.1;
constexpr int kMinTurnSpans = 8;

// Values that lie below the given ones and change gradually: the least of each
// window, averaged over the window. Cells make the room along a curve flicker,
// which speed need not follow.
std::vector<double> SmoothBelow(const std::vector<double>& values) {
  constexpr int kReach = 2;
  const int count = static_cast<int>(values.size());
  const auto window = [&](const std::vector<double>& from, int i) {
    return std::pair(from.begin() + std::max(0, i - kReach),
                     from.begin() + std::min(count, i + kReach + 1));
  };
  std::vector<double> least(values.size());
  std::vector<double> smooth(values.size());
  for (int i = 0; i < count; ++i) {
    const auto [first, last] = window(values, i);
    least[i] = *std::min_element(first, last);
  }
  for (int i = 0; i < count; ++i) {
    const auto [first, last] = window(least, i);
    smooth[i] =
        std::accumulate(first, last, 0.0) / static_cast<double>(last - first);
  }
  return smooth;
}

// m/s that the room allows at each point. A start that is faster is given the
// way it takes to brake: the room is a wish, and no reason to stop.
std::vector<double> RoomSpeeds(const std::vector<CurvePoint>& points,
                               bool reverse, const DriveStart& start,
                               const RobotLimits& limits, const RoomSpeed& rule,
                               const PoseCheck& check) {
  constexpr double kBraking = 0.9;  // of what the limits allow.
  const double max_v = reverse ? limits.max_v_reverse : limits.max_v;
  std::vector<double> speeds;
  for (const CurvePoint& point : points) {
    const Pose2D pose(point.position, point.heading + (reverse ? kPi : 0.0));
    speeds.push_back(SpeedAtRoom(check.Room(pose), max_v, rule));
  }
  speeds = SmoothBelow(speeds);
  double squared = start.speed * start.speed;
  for (std::size_t i = 0; i < points.size() && squared > 0.0; ++i) {
    speeds[i] = std::max(speeds[i], std::sqrt(squared));
    squared -= 2.0 * kBraking * limits.max_deceleration * points[i].length;
  }
  return speeds;
}

ProfileProblem DriveProblem(const std::vector<CurvePoint>& points, bool reverse,
                            const DriveStart& start, const RobotLimits& limits,
                            const RoomSpeed& rule, const PoseCheck& check) {
  const double max_v = reverse ? limits.max_v_reverse : limits.max_v;
  ProfileProblem problem;
  problem.max_acceleration = limits.max_acceleration;
  problem.max_deceleration = limits.max_deceleration;
  problem.max_angular_accelerations.assign(points.size(),
                                           limits.max_angular_acceleration);
  problem.start_speed = start.speed;
  problem.start_acceleration = start.acceleration;
  const std::vector<double> room_speeds =
      RoomSpeeds(points, reverse, start, limits, rule, check);
  double allowed_before = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const CurvePoint& point = points[i];
    const double allowed = std::min(
        SpeedAtCurvature(point.curvature, max_v, limits), room_speeds[i]);
    problem.curvatures.push_back(point.curvature);
    problem.curvature_rates.push_back(point.curvature_rate);
    if (i > 0) {
      problem.lengths.push_back(point.length);
      problem.max_speeds.push_back(std::min(allowed_before, allowed));
    }
    allowed_before = allowed;
  }
  return problem;
}

struct MotionState {
  Jet x;
  Jet y;
};

// Position, velocity and acceleration on a curve driven with speed v and
// acceleration a along it.
MotionState StateAt(const CurvePoint& point, double v, double a) {
  const double c = std::cos(point.heading);
  const double s = std::sin(point.heading);
  const double lateral = point.curvature * v * v;
  MotionState state;
  state.x = {point.position.x(), v * c, a * c - lateral * s, 0.0};
  state.y = {point.position.y(), v * s, a * s + lateral * c, 0.0};
  return state;
}

std::vector<TrajectoryPiece> Pieces(const std::vector<CurvePoint>& points,
                                    bool reverse, const SpeedProfile& profile) {
  std::vector<TrajectoryPiece> pieces;
  pieces.reserve(points.size() - 1);
  MotionState from =
      StateAt(points[0], profile.speeds[0], profile.accelerations[0]);
  for (std::size_t i = 1; i < points.size(); ++i) {
    const MotionState to =
        StateAt(points[i], profile.speeds[i], profile.accelerations[i]);
    TrajectoryPiece piece;
    piece.kind = reverse ? TrajectoryPiece::Kind::kReverse
                         : TrajectoryPiece::Kind::kForward;
    piece.duration = profile.durations[i - 1];
    piece.x = HermiteQuintic(from.x, to.x, piece.duration);
    piece.y = HermiteQuintic(from.y, to.y, piece.duration);
    pieces.push_back(piece);
    from = to;
  }
  return pieces;
}

// How many times over its limits a piece goes, at worst: in the square of the
// speed, and in the angular acceleration.
struct Excess {
  double speed = 0.0;
  double angular = 0.0;
};

Excess ExcessOf(const TrajectoryPiece& piece, double max_v,
                const RobotLimits& limits) {
  // Slower than this w is of no account, and ill-conditioned.
  constexpr double kSlow = 0.03;  // m/s
  Excess excess;
  for (const double tau : {0.0, 0.15, 0.4, 0.6, 0.85, 1.0}) {
    const Jet x = Evaluate(piece.x, piece.duration, tau);
    const Jet y = Evaluate(piece.y, piece.duration, tau);
    const double squared = x.first * x.first + y.first * y.first;
    if (squared < kSlow * kSlow) continue;
    const double w = (y.second * x.first - x.second * y.first) / squared;
    const double v = std::sqrt(squared);
    const double allowed = SpeedAtCurvature(w / v, max_v, limits);
    const double dw = (y.third * x.first - x.third * y.first -
                       2.0 * w * (x.first * x.second + y.first * y.second)) /
                      squared;
    excess.speed = std::max(excess.speed, squared / (allowed * allowed));
    excess.angular = std::max(excess.angular,
                              std::abs(dw) / limits.max_angular_acceleration);
  }
  return excess;
}

// Lowers the bounds of spans whose pieces go beyond their limits between the
// nodes, where the curvature changes fast. True when there was one.
bool Correct(ProfileProblem& problem,
             const std::vector<TrajectoryPiece>& pieces, double max_v,
             const RobotLimits& limits) {
  constexpr double kAllowed = 1.005;
  bool corrected = false;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Excess excess = ExcessOf(pieces[i], max_v, limits);
    if (excess.speed > kAllowed) {
      problem.max_speeds[i] /= std::sqrt(excess.speed);
      corrected = true;
    }
    if (excess.angular > kAllowed) {
      problem.max_angular_accelerations[i] /= excess.angular;
      problem.max_angular_accelerations[i + 1] /= excess.angular;
      corrected = true;
    }
  }
  return corrected;
}

}  // namespace

TimedPieces TimeDrive(const std::vector<CurvePoint>& points, bool reverse,
                      const DriveStart& start, const RobotLimits& limits,
                      const RoomSpeed& rule, const PoseCheck& check) {
  assert(points.size() >= 2);
  constexpr int kMaxCorrections = 10;
  const double max_v = reverse ? limits.max_v_reverse : limits.max_v;
  ProfileProblem problem =
      DriveProblem(points, reverse, start, limits, rule, check);
  TimedPieces timed;
  for (int i = 0; i <= kMaxCorrections; ++i) {
    const SpeedProfile profile = OptimizeSpeed(problem);
    timed.keeps_limits = profile.keeps_limits;
    timed.pieces = Pieces(points, reverse, profile);
    if (!Correct(problem, timed.pieces, max_v, limits)) break;
  }
  return timed;
}

std::vector<TrajectoryPiece> TimeTurn(const Pose2D& pose, double angle,
                                      double w, const RobotLimits& limits) {
  assert(angle != 0.0 && w * angle >= 0.0);
  const double sign = angle > 0.0 ? 1.0 : -1.0;
  const int spans = std::max(
      kMinTurnSpans, static_cast<int>(std::ceil(std::abs(angle) / kTurnSpan)));
  const double span = std::abs(angle) / spans;
  ProfileProblem problem;
  problem.lengths.assign(spans, span);
  problem.max_speeds.assign(spans, limits.max_w);
  problem.curvatures.assign(spans + 1, 0.0);
  problem.curvature_rates.assign(spans + 1, 0.0);
  problem.max_angular_accelerations.assign(spans + 1,
                                           limits.max_angular_acceleration);
  problem.max_acceleration = limits.max_angular_acceleration;
  problem.max_deceleration = limits.max_angular_acceleration;
  problem.start_speed = std::abs(w);
  const SpeedProfile profile = OptimizeSpeed(problem);

  const auto state = [&](int node) {
    return Jet{pose.theta + sign * node * span, sign * profile.speeds[node],
               sign * profile.accelerations[node], 0.0};
  };
  std::vector<TrajectoryPiece> pieces;
  for (int i = 0; i < spans; ++i) {
    TrajectoryPiece piece;
    piece.kind = TrajectoryPiece::Kind::kTurn;
    piece.duration = profile.durations[i];
    piece.x[0] = pose.x;
    piece.y[0] = pose.y;
    piece.heading = HermiteQuintic(state(i), state(i + 1), piece.duration);
    pieces.push_back(piece);
  }
  return pieces;
}

}  // namespace vfh_astar
