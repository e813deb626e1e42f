#include "vfh_astar/trajectory/trajectory.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <utility>

namespace vfh_astar {
namespace {

using Kind = TrajectoryPiece::Kind;

// Below this speed (m/s) the direction of the velocity is rounding error, and
// that of the first derivative that does not vanish stands in for it.
constexpr double kStandstill = 1e-6;

struct Motion {
  Jet x;
  Jet y;
};

Motion MotionAt(const TrajectoryPiece& piece, double tau) {
  return {Evaluate(piece.x, piece.duration, tau),
          Evaluate(piece.y, piece.duration, tau)};
}

// The derivative of the position by tau.
Eigen::Vector2d ChangeAt(const TrajectoryPiece& piece, double tau) {
  Eigen::Vector2d change = Eigen::Vector2d::Zero();
  for (int i = 5; i > 0; --i) {
    change = change * tau + i * Eigen::Vector2d(piece.x[i], piece.y[i]);
  }
  return change;
}

// m driven between the piece's start and `tau`, by Gauss-Legendre quadrature.
double LengthWithin(const TrajectoryPiece& piece, double tau) {
  if (piece.kind == Kind::kTurn) return 0.0;
  static constexpr std::array<double, 5> kNodes = {
      0.0469100770306680, 0.2307653449471584, 0.5, 0.7692346550528416,
      0.9530899229693320};
  static constexpr std::array<double, 5> kWeights = {
      0.1184634425280946, 0.2393143352496832, 0.2844444444444444,
      0.2393143352496832, 0.1184634425280946};
  double length = 0.0;
  for (std::size_t i = 0; i < kNodes.size(); ++i) {
    length += kWeights[i] * ChangeAt(piece, kNodes[i] * tau).norm();
  }
  return length * tau;
}

Reference SampleTurn(const TrajectoryPiece& piece, double tau) {
  const Jet heading = Evaluate(piece.heading, piece.duration, tau);
  const Motion motion = MotionAt(piece, tau);
  Reference reference;
  reference.pose = {motion.x.value, motion.y.value,
                    NormalizeAngle(heading.value)};
  reference.twist.w = heading.first;
  return reference;
}

// The direction of travel where the velocity vanishes, and the sign with which
// speed changes there: a piece leaves a standstill in its first half and
// reaches one in its second.
struct Standstill {
  Eigen::Vector2d direction;
  double acceleration;
};

Standstill StandstillAt(const Motion& motion, double tau) {
  const double sign = tau < 0.5 ? 1.0 : -1.0;
  const Eigen::Vector2d second(motion.x.second, motion.y.second);
  if (second.norm() > kStandstill) {
    return {sign * second, sign * second.norm()};
  }
  return {{motion.x.third, motion.y.third}, 0.0};
}

Reference SampleDrive(const TrajectoryPiece& piece, double tau) {
  const Motion motion = MotionAt(piece, tau);
  const double k = piece.kind == Kind::kReverse ? -1.0 : 1.0;
  const double vx = motion.x.first;
  const double vy = motion.y.first;
  const double squared = vx * vx + vy * vy;

  Reference reference;
  Eigen::Vector2d direction(vx, vy);
  if (squared > kStandstill * kStandstill) {
    const double speed = std::sqrt(squared);
    reference.twist.v = k * speed;
    reference.twist.w = (motion.y.second * vx - motion.x.second * vy) / squared;
    reference.acceleration =
        k * (motion.x.second * vx + motion.y.second * vy) / speed;
  } else {
    const Standstill standstill = StandstillAt(motion, tau);
    direction = standstill.direction;
    reference.acceleration = k * standstill.acceleration;
  }
  reference.pose = {motion.x.value, motion.y.value,
                    std::atan2(k * direction.y(), k * direction.x())};
  return reference;
}

Reference SamplePiece(const TrajectoryPiece& piece, double tau) {
  return piece.kind == Kind::kTurn ? SampleTurn(piece, tau)
                                   : SampleDrive(piece, tau);
}

}  // namespace

Trajectory::Trajectory(std::vector<TrajectoryPiece> pieces)
    : pieces_(std::move(pieces)) {
  start_times_.reserve(pieces_.size());
  start_lengths_.reserve(pieces_.size() + 1);
  double length = 0.0;
  for (const TrajectoryPiece& piece : pieces_) {
    assert(piece.duration > 0.0);
    start_times_.push_back(duration_);
    start_lengths_.push_back(length);
    duration_ += piece.duration;
    length += LengthWithin(piece, 1.0);
  }
  start_lengths_.push_back(length);
}

std::size_t Trajectory::PieceAt(double t) const {
  assert(!empty());
  const auto after =
      std::upper_bound(start_times_.begin() + 1, start_times_.end(), t);
  return static_cast<std::size_t>(after - start_times_.begin()) - 1;
}

double Trajectory::Length(double t) const {
  if (empty() || t <= 0.0) return 0.0;
  if (t >= duration_) return start_lengths_.back();
  const std::size_t i = PieceAt(t);
  return start_lengths_[i] +
         LengthWithin(pieces_[i], (t - start_times_[i]) / pieces_[i].duration);
}

double Trajectory::TimeAtLength(double length) const {
  if (empty() || length >= start_lengths_.back()) return duration_;
  if (length < 0.0) return 0.0;
  const auto after =
      std::upper_bound(start_lengths_.begin(), start_lengths_.end(), length);
  const std::size_t i =
      static_cast<std::size_t>(after - start_lengths_.begin()) - 1;
  const TrajectoryPiece& piece = pieces_[i];
  const double wanted = length - start_lengths_[i];
  double low = 0.0;
  double high = 1.0;
  // The secant is exact at constant speed; every other step halves, because
  // speed may vanish at either end of the piece.
  constexpr double kTolerance = 1e-6;
  double reached = 0.0;
  double beyond = start_lengths_[i + 1] - start_lengths_[i];
  for (bool halve = false; wanted - reached > kTolerance && high - low > 1e-9;
       halve = !halve) {
    const double share =
        halve ? 0.5
              : (wanted - 0.5 * kTolerance - reached) / (beyond - reached);
    const double middle = low + share * (high - low);
    const double here = LengthWithin(piece, middle);
    if (here <= wanted) {
      low = middle;
      reached = here;
    } else {
      high = middle;
      beyond = here;
    }
  }
  return start_times_[i] + low * piece.duration;
}

Reference Trajectory::Sample(double t) const {
  assert(!empty());
  if (t < 0.0 || t > duration_) {
    const bool before = t < 0.0;
    Reference reference =
        SamplePiece(before ? pieces_.front() : pieces_.back(), before ? 0 : 1);
    reference.twist = {};
    reference.acceleration = 0.0;
    return reference;
  }
  const std::size_t i = PieceAt(t);
  const double tau = (t - start_times_[i]) / pieces_[i].duration;
  return SamplePiece(pieces_[i], std::min(tau, 1.0));
}

}  // namespace vfh_astar
