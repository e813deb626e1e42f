#ifndef TEST_UNIT_TRAJECTORY_FINE_OPTIMUM_H_
#define TEST_UNIT_TRAJECTORY_FINE_OPTIMUM_H_

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "vfh_astar/robot_limits.h"
#include "vfh_astar/trajectory/spline_curve.h"
#include "vfh_astar/trajectory/timing.h"

namespace vfh_astar {

/// The curvature along a curve: between its points the cubic that has theirs
/// and its rate at both.
class BentCurve {
 public:
  explicit BentCurve(std::vector<CurvePoint> points)
      : points_(std::move(points)) {
    for (const CurvePoint& point : points_) {
      ends_.push_back((ends_.empty() ? 0.0 : ends_.back()) + point.length);
    }
  }

  double length() const { return ends_.back(); }  ///< m

  struct Bend {
    double curvature;  ///< 1/m
    double rate;       ///< 1/m^2
  };

  /// @param[in] s m from the start.
  Bend At(double s) const {
    const auto after = std::lower_bound(ends_.begin() + 1, ends_.end() - 1, s);
    const std::size_t i = after - ends_.begin();
    const CurvePoint& a = points_[i - 1];
    const CurvePoint& b = points_[i];
    const double h = b.length;
    const double t = std::clamp((s - ends_[i - 1]) / h, 0.0, 1.0);
    const double change = b.curvature - a.curvature;
    const double bow = h * (a.curvature_rate + b.curvature_rate) - 2.0 * change;
    const double rise = change - h * a.curvature_rate - bow;
    return {a.curvature + t * (h * a.curvature_rate + t * (rise + t * bow)),
            a.curvature_rate + t * (2.0 * rise + 3.0 * t * bow) / h};
  }

 private:
  std::vector<CurvePoint> points_;
  std::vector<double> ends_;
};

/// The least time (s) from rest to rest, with the acceleration constant over
/// steps of 2 mm or less. Slow and plain: the largest squared speed of each
/// step is found by bisection.
class FineOptimum {
 public:
  FineOptimum(const BentCurve& curve, const RobotLimits& limits)
      : limits_(limits),
        count_(static_cast<int>(std::ceil(curve.length() / kMostStep))),
        step_(curve.length() / count_) {
    for (int i = 0; i <= count_; ++i) bends_.push_back(curve.At(i * step_));
  }

  double Duration() const {
    std::vector<double> most(count_ + 1, 0.0);
    for (int i = count_ - 1; i >= 0; --i) {
      const double allowed =
          SpeedAtCurvature(bends_[i].curvature, limits_.max_v, limits_);
      double low = 0.0;
      double high = allowed * allowed;
      for (int halving = 0; halving < 40; ++halving) {
        const double middle = 0.5 * (low + high);
        const Range a = Accelerations(i, middle, most[i + 1]);
        (a.low <= a.high ? low : high) = middle;
      }
      most[i] = low;
    }
    double duration = 0.0;
    double u = 0.0;
    for (int i = 0; i < count_; ++i) {
      const double a = Accelerations(i, u, most[i + 1]).high;
      const double next = std::clamp(u + 2.0 * a * step_, 0.0, most[i + 1]);
      duration += 2.0 * step_ / (std::sqrt(u) + std::sqrt(next));
      u = next;
    }
    return duration;
  }

 private:
  static constexpr double kMostStep = 0.002;  ///< m

  struct Range {
    double low;
    double high;
  };

  /// m/s^2 that keep the limits at a node and lead to at most `next`.
  Range Accelerations(int node, double u, double next) const {
    Range a{std::max(-limits_.max_deceleration, -u / (2.0 * step_)),
            std::min(limits_.max_acceleration, (next - u) / (2.0 * step_))};
    const double curvature = bends_[node].curvature;
    const double free = bends_[node].rate * u;
    const double most = limits_.max_angular_acceleration;
    if (std::abs(curvature) < 1e-9) {
      if (std::abs(free) > most) a.high = a.low - 1.0;
      return a;
    }
    const double one = (most - free) / curvature;
    const double other = (-most - free) / curvature;
    return {std::max(a.low, std::min(one, other)),
            std::min(a.high, std::max(one, other))};
  }

  const RobotLimits& limits_;
  int count_;
  double step_;  ///< m
  std::vector<BentCurve::Bend> bends_;
};

}  // namespace vfh_astar

#endif  // TEST_UNIT_TRAJECTORY_FINE_OPTIMUM_H_
