#include "vfh_astar/trajectory/curve_smoother.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>

namespace vfh_astar {
namespace {

using Points = std::vector<Eigen::Vector2d>;

constexpr int kBand = 3;
constexpr int kFixed = SplineCurve::kEndPoints;

// Lengths (m) over which second and third differences weigh alike.
constexpr double kCurvatureScale = 1.5;
// Penalty of ADMM: a wave of this many points is smoothed away in one step.
// It decides how fast the iteration converges, not where to.
constexpr double kWavePoints = 24.0;
constexpr int kMaxIterations = 60;
constexpr double kTolerance = 1e-3;  // m by which a bubble may be left.

// Row of the normal equations: offsets -3..3 in diagonal-first order.
std::array<double, kBand + 1> Stencil(double spacing) {
  const double w = spacing * spacing / (kCurvatureScale * kCurvatureScale);
  return {20.0 + 6.0 * w, -15.0 - 4.0 * w, 6.0 + w, -1.0};
}

// L D L^T of a symmetric banded matrix whose rows are all alike.
class BandedFactor {
 public:
  BandedFactor(const std::array<double, kBand + 1>& row, std::size_t size)
      : lower_(size), diagonal_(size) {
    for (std::size_t i = 0; i < size; ++i) {
      const int reach = static_cast<int>(std::min<std::size_t>(kBand, i));
      lower_[i].fill(0.0);
      for (int k = reach; k >= 1; --k) {
        double value = row[k];
        for (int m = reach; m > k; --m) {
          value -= lower_[i][m] * lower_[i - k][m - k] * diagonal_[i - m];
        }
        lower_[i][k] = value / diagonal_[i - k];
      }
      double pivot = row[0];
      for (int k = 1; k <= reach; ++k) {
        pivot -= lower_[i][k] * lower_[i][k] * diagonal_[i - k];
      }
      diagonal_[i] = pivot;
    }
  }

  void SolveInPlace(Points& x) const {
    const std::size_t size = x.size();
    for (std::size_t i = 0; i < size; ++i) {
      const std::size_t reach = std::min<std::size_t>(kBand, i);
      for (std::size_t k = 1; k <= reach; ++k) x[i] -= lower_[i][k] * x[i - k];
    }
    for (std::size_t i = size; i-- > 0;) {
      x[i] /= diagonal_[i];
      const std::size_t reach = std::min<std::size_t>(kBand, size - 1 - i);
      for (std::size_t k = 1; k <= reach; ++k) {
        x[i] -= lower_[i + k][k] * x[i + k];
      }
    }
  }

 private:
  std::vector<std::array<double, kBand + 1>> lower_;
  std::vector<double> diagonal_;
};

Eigen::Vector2d Project(const Eigen::Vector2d& point, const Bubble& bubble) {
  const Eigen::Vector2d offset = point - bubble.centre;
  const double distance = offset.norm();
  if (distance <= bubble.radius) return point;
  return bubble.centre + bubble.radius / distance * offset;
}

// What the fixed control points put on the right-hand side of the free ones.
Points FixedTerms(const Points& control,
                  const std::array<double, kBand + 1>& stencil) {
  const int free = static_cast<int>(control.size()) - 2 * kFixed;
  Points terms(free, Eigen::Vector2d::Zero());
  for (int i = 0; i < free; ++i) {
    for (int k = 1; k <= kBand; ++k) {
      if (i - k < 0) terms[i] -= stencil[k] * control[kFixed + i - k];
      if (i + k >= free) terms[i] -= stencil[k] * control[kFixed + i + k];
    }
  }
  return terms;
}

// Moves the free control points; `discs` holds a bubble for each of them.
void Minimise(Points& control, const std::vector<Bubble>& discs,
              double spacing) {
  const std::size_t free = discs.size();
  std::array<double, kBand + 1> stencil = Stencil(spacing);
  const Points fixed_terms = FixedTerms(control, stencil);
  const double penalty = std::pow(2.0 * 3.14159265358979 / kWavePoints, 6);
  stencil[0] += penalty;
  const BandedFactor factor(stencil, free);

  Points inside(free);
  Points dual(free, Eigen::Vector2d::Zero());
  Points x(free);
  for (std::size_t i = 0; i < free; ++i) inside[i] = discs[i].centre;
  for (int iteration = 0; iteration < kMaxIterations; ++iteration) {
    for (std::size_t i = 0; i < free; ++i) {
      x[i] = fixed_terms[i] + penalty * (inside[i] - dual[i]);
    }
    factor.SolveInPlace(x);
    double gap = 0.0;
    double change = 0.0;
    for (std::size_t i = 0; i < free; ++i) {
      const Eigen::Vector2d before = inside[i];
      inside[i] = Project(x[i] + dual[i], discs[i]);
      dual[i] += x[i] - inside[i];
      gap = std::max(gap, (x[i] - inside[i]).squaredNorm());
      change = std::max(change, (inside[i] - before).squaredNorm());
    }
    if (std::max(gap, change) < kTolerance * kTolerance) break;
  }
  std::copy(x.begin(), x.end(), control.begin() + kFixed);
}

}  // namespace

SplineCurve SmoothThroughBubbles(const CurveEnd& start, const CurveEnd& end,
                                 double spacing,
                                 const std::vector<Bubble>& bubbles) {
  // Control point i lies at knot i - 2.
  const std::size_t knots = bubbles.size();
  assert(knots >= 9);
  Points control(knots + 4);
  const auto first = SplineCurve::EndPoints(start, spacing);
  const auto last = SplineCurve::EndPoints(end, spacing);
  std::copy(first.begin(), first.end(), control.begin());
  std::copy(last.begin(), last.end(), control.end() - kFixed);
  const std::vector<Bubble> discs(bubbles.begin() + 3, bubbles.end() - 3);
  Minimise(control, discs, spacing);
  return SplineCurve(std::move(control));
}

}  // namespace vfh_astar
