#include "vfh_astar/mapping/correlative_search.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace vfh_astar {
namespace {

constexpr double kResolution = 0.1;

/// The best value of a window by trying everything.
double ExhaustiveValue(const HitField& field,
                       const std::vector<Eigen::Vector2d>& points,
                       const Pose2D& centre, const SearchWindow& window) {
  double best = -1.0;
  const int reach = static_cast<int>(std::ceil(window.linear / kResolution));
  const int turns =
      static_cast<int>(std::ceil(window.angular / window.angular_step));
  for (int turn = -turns; turn <= turns; ++turn) {
    const double angle = turn * window.angular_step;
    const Pose2D turned(centre.position(), centre.theta + angle);
    for (int y = -reach; y <= reach; ++y) {
      for (int x = -reach; x <= reach; ++x) {
        double sum = 0.0;
        for (const Eigen::Vector2d& point : points) {
          const Eigen::Vector2d at = turned * point / kResolution;
          const cv::Rect cell(static_cast<int>(std::floor(at.x())) + x,
                              static_cast<int>(std::floor(at.y())) + y, 1, 1);
          sum += field.Values(cell).front() / 255.0;
        }
        const double shift =
            kResolution * kResolution * (static_cast<double>(x) * x + y * y);
        best =
            std::max(best, sum / points.size() - window.linear_penalty * shift -
                               window.angular_penalty * angle * angle);
      }
    }
  }
  return best;
}

TEST(CorrelativeSearch, FindsWhatTryingEverythingFinds) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(-3.0, 3.0);
  for (int trial = 0; trial < 20; ++trial) {
    HitField field(kResolution, 0.1, 0.6);
    std::vector<Eigen::Vector2d> points;
    for (int i = 0; i < 60; ++i) {
      field.Add({{place(random), place(random)}}, {});
    }
    for (int i = 0; i < 15; ++i)
      points.emplace_back(place(random), place(random));
    SearchWindow window;
    window.linear = 0.7;
    window.angular = 0.15;
    window.angular_step = 0.05;
    window.linear_penalty = trial % 2 == 0 ? 0.0 : 0.1;
    window.angular_penalty = trial % 2 == 0 ? 0.0 : 1.0;
    const Pose2D centre(place(random), place(random), place(random));
    const auto found = SearchPose(field, points, centre, window, -1.0);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->value, ExhaustiveValue(field, points, centre, window),
                1e-9);
  }
}

TEST(CorrelativeSearch, FindsAKnownOffset) {
  std::mt19937 random(6);
  std::uniform_real_distribution<double> place(-3.0, 3.0);
  std::vector<Eigen::Vector2d> points;
  for (int i = 0; i < 40; ++i)
    points.emplace_back(place(random), place(random));
  HitField field(kResolution, 0.1, 1.0);
  const Pose2D truth(11.3, -4.2, 0.9);
  field.Add(points, truth);
  SearchWindow window;
  window.linear = 2.0;
  const auto found = SearchPose(field, points, {12.8, -5.6, 1.2}, window, 0.5);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->pose.x, truth.x, kResolution);
  EXPECT_NEAR(found->pose.y, truth.y, kResolution);
  EXPECT_NEAR(found->pose.theta, truth.theta, 0.02);
}

TEST(CorrelativeSearch, NothingIsFoundWhereNothingFits) {
  HitField field(kResolution, 0.1, 1.0);
  field.Add({{0.0, 0.0}}, {});
  EXPECT_FALSE(SearchPose(field, {{5.0, 5.0}, {6.0, 5.0}}, {}, {}, 0.1));
  EXPECT_FALSE(SearchPose(field, {}, {}, {}, 0.1));
}

}  // namespace
}  // namespace vfh_astar
