#include "vfh_astar/trajectory/speed_profile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <random>

namespace vfh_astar {
namespace {

ProfileProblem Straight(int spans, double length, double max_speed) {
  ProfileProblem problem;
  problem.lengths.assign(spans, length);
  problem.max_speeds.assign(spans, max_speed);
  problem.curvatures.assign(spans + 1, 0.0);
  problem.curvature_rates.assign(spans + 1, 0.0);
  problem.max_angular_accelerations.assign(spans + 1, 8.0);
  problem.max_acceleration = 2.0;
  problem.max_deceleration = 2.5;
  return problem;
}

double Duration(const SpeedProfile& profile) {
  return std::accumulate(profile.durations.begin(), profile.durations.end(),
                         0.0);
}

TEST(SpeedProfile, TrapezoidByHand) {
  // 10 m at up to 2 m/s: 1 m in 1 s, 8.2 m in 4.1 s, 0.8 m in 0.8 s.
  const SpeedProfile profile = OptimizeSpeed(Straight(200, 0.05, 2.0));
  EXPECT_TRUE(profile.keeps_limits);
  EXPECT_NEAR(Duration(profile), 5.9, 0.03);
  EXPECT_EQ(profile.speeds.front(), 0.0);
  EXPECT_EQ(profile.speeds.back(), 0.0);
  EXPECT_NEAR(profile.speeds[100], 2.0, 1e-12);
  EXPECT_NEAR(profile.accelerations.front(), 2.0, 1e-12);
  EXPECT_NEAR(profile.accelerations.back(), -2.5, 1e-12);
}

TEST(SpeedProfile, TriangleByHand) {
  // 0.9 m without reaching the top speed: v^2 = 2 * 0.9 / (1 / 2 + 1 / 2.5),
  // v = sqrt 2, t = v (1 / 2 + 1 / 2.5).
  const SpeedProfile profile = OptimizeSpeed(Straight(90, 0.01, 5.0));
  EXPECT_NEAR(Duration(profile), std::sqrt(2.0) * 0.9, 0.01);
}

TEST(SpeedProfile, StartsWithItsSpeedAndAcceleration) {
  ProfileProblem problem = Straight(100, 0.05, 2.0);
  problem.start_speed = 1.0;
  problem.start_acceleration = -0.5;
  const SpeedProfile profile = OptimizeSpeed(problem);
  EXPECT_DOUBLE_EQ(profile.speeds.front(), 1.0);
  EXPECT_NEAR(profile.accelerations.front(), -0.5, 1e-12);
  EXPECT_TRUE(profile.keeps_limits);
}

TEST(SpeedProfile, TooFastAStartBrakes) {
  ProfileProblem problem = Straight(100, 0.05, 1.0);
  problem.start_speed = 2.0;
  const SpeedProfile profile = OptimizeSpeed(problem);
  EXPECT_FALSE(profile.keeps_limits);
  // From 2 to 1 m/s at 2.5 m/s^2 takes 0.6 m.
  EXPECT_NEAR(profile.accelerations[6], -2.5, 1e-9);
  EXPECT_NEAR(profile.speeds[14], 1.0, 1e-9);
}

// The optimum without a limit on angular acceleration, on a grid of 1 mm.
double FineOptimum(double length, const std::function<double(double)>& max_v,
                   const ProfileProblem& problem) {
  const double step = 1e-3;
  const int n = static_cast<int>(std::lround(length / step));
  std::vector<double> u(n + 1);
  for (int i = 0; i <= n; ++i) u[i] = std::pow(max_v(i * step), 2);
  u[0] = std::min(u[0], problem.start_speed * problem.start_speed);
  u[n] = 0.0;
  for (int i = 1; i <= n; ++i) {
    u[i] = std::min(u[i], u[i - 1] + 2 * problem.max_acceleration * step);
  }
  for (int i = n; i > 0; --i) {
    u[i - 1] = std::min(u[i - 1], u[i] + 2 * problem.max_deceleration * step);
  }
  double duration = 0.0;
  for (int i = 0; i < n; ++i) {
    duration += 2 * step / (std::sqrt(u[i]) + std::sqrt(u[i + 1]));
  }
  return duration;
}

TEST(SpeedProfile, WithinTwoPercentOfTheOptimum) {
  std::mt19937 random(3);
  std::uniform_real_distribution<> amplitude(0.2, 1.5);
  std::uniform_real_distribution<> wave(0.8, 4.0);
  for (int trial = 0; trial < 200; ++trial) {
    const double a = amplitude(random);
    const double b = wave(random);
    const double c = wave(random);
    const auto max_v = [&](double s) {
      const double bend =
          std::abs(a * (std::sin(s * b) + 0.5 * std::sin(s * c + 1.0)));
      return std::min(2.0, std::sqrt(2.0 / std::max(bend, 1e-9)));
    };
    ProfileProblem problem = Straight(200, 0.05, 2.0);
    for (int i = 0; i < 200; ++i) {
      problem.max_speeds[i] = std::min(max_v(0.05 * i), max_v(0.05 * (i + 1)));
    }
    const double optimum = FineOptimum(10.0, max_v, problem);
    const double duration = Duration(OptimizeSpeed(problem));
    EXPECT_LT(duration, 1.02 * optimum);
    EXPECT_GT(duration, 0.998 * optimum);
  }
}

// u and its slope everywhere, from the values at the nodes.
void ExpectLimitsKept(const ProfileProblem& problem,
                      const SpeedProfile& profile) {
  for (std::size_t i = 0; i < problem.lengths.size(); ++i) {
    const double length = problem.lengths[i];
    // A jump of the bound from span to span is rounded off.
    const auto first = problem.max_speeds.begin() + (i > 0 ? i - 1 : i);
    const auto last =
        problem.max_speeds.begin() + std::min(i + 2, problem.lengths.size());
    const double max_speed = *std::max_element(first, last);
    const double u = profile.speeds[i] * profile.speeds[i];
    const double a = profile.accelerations[i];
    const double b = profile.accelerations[i + 1];
    for (double part = 0.0; part <= 1.0; part += 0.1) {
      const double x = part * length;
      const double squared = u + 2 * a * x + (b - a) * x * x / length;
      EXPECT_GE(squared, -1e-12);
      EXPECT_LE(std::sqrt(std::max(squared, 0.0)), max_speed * (1 + 1e-9));
      const double acceleration = a + part * (b - a);
      EXPECT_LE(acceleration, problem.max_acceleration * (1 + 1e-9));
      EXPECT_GE(acceleration, -problem.max_deceleration * (1 + 1e-9));
    }
    const double end = profile.speeds[i + 1] * profile.speeds[i + 1];
    EXPECT_NEAR(u + (a + b) * length, end, 1e-9);
    EXPECT_LE(
        std::abs(problem.curvature_rates[i] * u + problem.curvatures[i] * a),
        problem.max_angular_accelerations[i] * (1 + 1e-9));
  }
}

TEST(SpeedProfile, KeepsLimitsOnRandomChains) {
  std::mt19937 random(4);
  std::uniform_real_distribution<> unit(0.0, 1.0);
  for (int trial = 0; trial < 2000; ++trial) {
    const int spans = 1 + static_cast<int>(60 * unit(random));
    ProfileProblem problem = Straight(spans, 0.05, 2.0);
    const double bend = 4.0 * unit(random);
    const double wave = 3.0 * unit(random);
    double speed = 2.0;
    double at = 0.0;
    for (int i = 0; i < spans; ++i) {
      problem.lengths[i] = 0.02 + 0.06 * unit(random);
      speed = std::clamp(speed * (0.9 + 0.2 * unit(random)), 0.2, 2.0);
      problem.max_speeds[i] = speed;
    }
    for (int i = 0; i <= spans; ++i) {
      problem.curvatures[i] = bend * std::sin(wave * at);
      problem.curvature_rates[i] = bend * wave * std::cos(wave * at);
      if (i < spans) at += problem.lengths[i];
    }
    const SpeedProfile profile = OptimizeSpeed(problem);
    ASSERT_TRUE(profile.keeps_limits);
    for (const double duration : profile.durations) ASSERT_GT(duration, 0.0);
    ExpectLimitsKept(problem, profile);
  }
}

TEST(SpeedProfile, AngularAccelerationBindsByHand) {
  // On an arc of curvature 8, dw/dt = 8 a: with 8 rad/s^2 that is 1 m/s^2 for
  // speeding up and braking alike.
  ProfileProblem problem = Straight(100, 0.01, 5.0);
  problem.curvatures.assign(101, 8.0);
  const SpeedProfile profile = OptimizeSpeed(problem);
  EXPECT_NEAR(Duration(profile), 2.0, 0.02);
  EXPECT_NEAR(profile.accelerations[10], 1.0, 1e-9);
  EXPECT_NEAR(profile.accelerations[90], -1.0, 1e-9);
}

TEST(SpeedProfile, DurationsIntegrateTheSpeed) {
  // Against the trapezium rule on a fine grid, where speed does not vanish.
  ProfileProblem problem = Straight(40, 0.05, 1.5);
  problem.start_speed = 0.7;
  const SpeedProfile profile = OptimizeSpeed(problem);
  for (int i = 0; i < 38; ++i) {
    const double a = profile.accelerations[i];
    const double b = profile.accelerations[i + 1];
    double duration = 0.0;
    const int parts = 2000;
    for (int k = 0; k < parts; ++k) {
      const double x = 0.05 * (k + 0.5) / parts;
      const double u = profile.speeds[i] * profile.speeds[i] + 2 * a * x +
                       (b - a) * x * x / 0.05;
      duration += 0.05 / parts / std::sqrt(u);
    }
    EXPECT_NEAR(profile.durations[i], duration, 1e-5);
  }
}

}  // namespace
}  // namespace vfh_astar
