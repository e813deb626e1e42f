#include "vfh_astar/trajectory/speed_profile.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>

namespace vfh_astar {
namespace {

// offset + slope * c: a bound on the next coefficient by this one.
struct Line {
  double offset = 0.0;
  double slope = 0.0;
  double At(double c) const { return offset + slope * c; }
};

// The next coefficient lies between the highest of `lower` and the lowest of
// `upper`; this one is at most `here`, whatever the next one is.
struct Step {
  std::array<Line, 2> lower;
  std::array<Line, 2> upper;
  double here = INFINITY;

  double Lowest(double c) const {
    return std::max(lower[0].At(c), lower[1].At(c));
  }
  double Highest(double c) const {
    return std::min(upper[0].At(c), upper[1].At(c));
  }
};

// The constraints at a node between two coefficients, with
// u = near c + (1 - near) c_next and a = (c_next - c) / width.
Step StepAt(const ProfileProblem& problem, std::size_t node, double near,
            double width) {
  Step step;
  step.lower[0] = {-problem.max_deceleration * width, 1.0};
  step.upper[0] = {problem.max_acceleration * width, 1.0};
  step.lower[1] = step.lower[0];
  step.upper[1] = step.upper[0];

  // |mine c + next c_next| <= limit
  const double rate = problem.curvature_rates[node];
  const double bend = problem.curvatures[node] / width;
  const double limit = problem.max_angular_accelerations[node];
  const double mine = rate * near - bend;
  const double next = rate * (1.0 - near) + bend;
  constexpr double kNegligible = 1e-9;
  if (std::abs(next) > kNegligible) {
    step.lower[1] = {-limit / std::abs(next), -mine / next};
    step.upper[1] = {limit / std::abs(next), -mine / next};
  } else if (std::abs(mine) > kNegligible) {
    step.here = limit / std::abs(mine);
  }
  return step;
}

// The largest c from which a next coefficient in [0, next_max] can be reached.
// c = 0 with a next one of 0 keeps every constraint, so that all smaller ones
// can do so, too.
double LargestFeasible(const Step& step, double next_max) {
  double largest = step.here;
  const std::array<Line, 3> lower = {step.lower[0], step.lower[1], Line{}};
  const std::array<Line, 3> upper = {step.upper[0], step.upper[1],
                                     Line{next_max, 0.0}};
  for (const Line& low : lower) {
    for (const Line& high : upper) {
      const double slope = low.slope - high.slope;
      if (slope > 1e-12) {
        largest = std::min(largest, (high.offset - low.offset) / slope);
      }
    }
  }
  return std::max(largest, 0.0);
}

class Optimizer {
 public:
  explicit Optimizer(const ProfileProblem& problem)
      : problem_(problem),
        spans_(problem.lengths.size()),
        largest_(spans_),
        coefficients_(spans_) {}

  SpeedProfile Run() {
    PassBackward();
    PassForward();
    return Describe();
  }

 private:
  double Length(std::size_t span) const { return problem_.lengths[span]; }

  // Between the coefficients of span - 1 and span.
  Step StepInto(std::size_t span) const {
    const double before = Length(span - 1);
    const double after = Length(span);
    return StepAt(problem_, span, after / (before + after), before + after);
  }

  void PassBackward() {
    const std::size_t last = spans_ - 1;
    for (std::size_t i = 0; i < spans_; ++i) {
      largest_[i] = problem_.max_speeds[i] * problem_.max_speeds[i];
    }
    // Rest at the end: u falls to 0 over half a span's width.
    const double bend = std::abs(problem_.curvatures[spans_]);
    double braking = problem_.max_deceleration;
    if (bend > 0.0) {
      braking =
          std::min(braking, problem_.max_angular_accelerations[spans_] / bend);
    }
    largest_[last] = std::min(largest_[last], braking * Length(last));
    for (std::size_t i = last; i > 0; --i) {
      largest_[i - 1] =
          std::min(largest_[i - 1], LargestFeasible(StepInto(i), largest_[i]));
    }
  }

  void PassForward() {
    coefficients_[0] = First();
    for (std::size_t i = 1; i < spans_; ++i) {
      const Step step = StepInto(i);
      const double before = coefficients_[i - 1];
      if (before <= largest_[i - 1] + 1e-9) {
        const double fastest = std::min(step.Highest(before), largest_[i]);
        coefficients_[i] = std::max(fastest, 0.0);
      } else {
        coefficients_[i] = std::clamp(largest_[i], step.lower[0].At(before),
                                      step.upper[0].At(before));
      }
    }
  }

  // The first span's coefficient, half a span behind the start: the constraints
  // of a step from the start's squared speed.
  double First() {
    const double start = problem_.start_speed * problem_.start_speed;
    const Step step = StepAt(problem_, 0, 1.0, Length(0));
    const double slowest = step.lower[0].At(start);
    double fastest = std::min(step.Highest(start), largest_[0]);
    if (problem_.start_acceleration && start > 0.0) {
      const double kept = start + *problem_.start_acceleration * Length(0);
      fastest = std::min(fastest, std::max(kept, step.Lowest(start)));
    }
    keeps_limits_ = largest_[0] >= slowest - 1e-9;
    return std::max({fastest, slowest, 0.0});
  }

  SpeedProfile Describe() const {
    std::vector<double> u(spans_ + 1);
    std::vector<double> slope(spans_ + 1);
    u[0] = problem_.start_speed * problem_.start_speed;
    slope[0] = 2.0 * (coefficients_[0] - u[0]) / Length(0);
    for (std::size_t i = 1; i < spans_; ++i) {
      const double width = Length(i - 1) + Length(i);
      u[i] = (Length(i) * coefficients_[i - 1] +
              Length(i - 1) * coefficients_[i]) /
             width;
      slope[i] = 2.0 * (coefficients_[i] - coefficients_[i - 1]) / width;
    }
    u[spans_] = 0.0;
    slope[spans_] = -2.0 * coefficients_[spans_ - 1] / Length(spans_ - 1);

    SpeedProfile profile;
    profile.keeps_limits = keeps_limits_;
    for (std::size_t i = 0; i <= spans_; ++i) {
      profile.speeds.push_back(std::sqrt(u[i]));
      profile.accelerations.push_back(0.5 * slope[i]);
    }
    for (std::size_t i = 0; i < spans_; ++i) {
      profile.durations.push_back(
          Duration(Length(i), u[i], slope[i], slope[i + 1]));
    }
    return profile;
  }

  // Integral of 1 / sqrt(u) over a span, u quadratic. Length is substituted by
  // x = length (3 z^2 - 2 z^3), which takes the root's singularity out of both
  // ends.
  static double Duration(double length, double u, double slope,
                         double end_slope) {
    static constexpr std::array<double, 6> kNodes = {
        0.0337652428984240, 0.1693953067668678, 0.3806904069584016,
        0.6193095930415985, 0.8306046932331322, 0.9662347571015760};
    static constexpr std::array<double, 6> kWeights = {
        0.0856622461895852, 0.1803807865240693, 0.2339569672863455,
        0.2339569672863455, 0.1803807865240693, 0.0856622461895852};
    const double bend = 0.5 * (end_slope - slope) / length;
    double duration = 0.0;
    for (std::size_t i = 0; i < kNodes.size(); ++i) {
      const double z = kNodes[i];
      const double x = length * z * z * (3.0 - 2.0 * z);
      const double squared = u + x * (slope + x * bend);
      duration += kWeights[i] * 6.0 * length * z * (1.0 - z) /
                  std::sqrt(std::max(squared, 1e-12));
    }
    return duration;
  }

  const ProfileProblem& problem_;
  std::size_t spans_;
  std::vector<double> largest_;
  std::vector<double> coefficients_;
  bool keeps_limits_ = true;
};

}  // namespace

SpeedProfile OptimizeSpeed(const ProfileProblem& problem) {
  assert(!problem.lengths.empty());
  assert(problem.max_speeds.size() == problem.lengths.size());
  assert(problem.curvatures.size() == problem.lengths.size() + 1);
  assert(problem.curvature_rates.size() == problem.lengths.size() + 1);
  assert(problem.max_angular_accelerations.size() ==
         problem.lengths.size() + 1);
  return Optimizer(problem).Run();
}

}  // namespace vfh_astar
