#include "vfh_astar/simulation/fan_lanes.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "vfh_astar/geometry.h"

// GCC compiles these for several processors, and picks when the program starts.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define VFH_ASTAR_FOR_WIDEST_VECTORS \
  __attribute__((target_clones("avx2", "default")))
#else
#define VFH_ASTAR_FOR_WIDEST_VECTORS
#endif

namespace vfh_astar {
namespace {

constexpr double kHuge = std::numeric_limits<double>::max();

/// The greater of two numbers of which neither is NaN, as processors have it.
inline double Max(double a, double b) { return a > b ? a : b; }
inline double Min(double a, double b) { return a < b ? a : b; }

/// @param[in] ratio of the smaller to the greater of the vector's sides.
inline double BearingOf(double x, double y, double ratio) {
  const double s = ratio * ratio;
  const double octant =
      ratio *
      (0.9998663 +
       s * (-0.3303048 + s * (0.1801592 + s * (-0.0851562 + s * 0.0208451))));
  const double quadrant =
      std::abs(y) > std::abs(x) ? 0.5 * kPi - octant : octant;
  const double half = x < 0.0 ? kPi - quadrant : quadrant;
  return y < 0.0 ? 2.0 * kPi - half : half;
}

inline double Ratio(double x, double y) {
  return Min(std::abs(x), std::abs(y)) / Max(std::abs(x), std::abs(y));
}

inline double WidthOf(double low, double high) {
  const double width = high < low ? high - low + 2.0 * kPi : high - low;
  return width < 1.5 * kPi ? width : 0.0;
}

}  // namespace

double Bearing(const Eigen::Vector2d& v) {
  return BearingOf(v.x(), v.y(), Ratio(v.x(), v.y()));
}

double Width(double low, double high) { return WidthOf(low, high); }

VFH_ASTAR_FOR_WIDEST_VECTORS
ViewLanes ViewBoxes(const FanFrame& frame, const BoxLanes& boxes) {
  const double origin_x = frame.origin.x(), origin_y = frame.origin.y();
  const double axis_x = frame.axis.x(), axis_y = frame.axis.y();
  ViewLanes views;
  for (int i = 0; i < kFanLanes; ++i) {
    const double min_x = boxes.min_x[i] - origin_x;
    const double min_y = boxes.min_y[i] - origin_y;
    const double max_x = boxes.max_x[i] - origin_x;
    const double max_y = boxes.max_y[i] - origin_y;
    const double away_x = Max(Max(min_x, -max_x), 0.0);
    const double away_y = Max(Max(min_y, -max_y), 0.0);
    const double distance_squared = away_x * away_x + away_y * away_y;
    // The corners farthest to the right and to the left, as seen from the
    // origin.
    const double near_y = min_y > 0.0 ? min_y : max_y;
    const double right_ahead = min_y > 0.0 ? max_x : min_x;
    const double right_behind = max_y < 0.0 ? min_x : max_x;
    const double left_ahead = max_y < 0.0 ? max_x : min_x;
    const double left_behind = min_y > 0.0 ? min_x : max_x;
    const double right_y_beside = max_x < 0.0 ? max_y : near_y;
    const double left_y_beside = max_x < 0.0 ? min_y : near_y;
    const double right_x = max_x < 0.0 ? right_behind : right_ahead;
    const double right_y = min_x > 0.0 ? min_y : right_y_beside;
    const double left_x = min_x > 0.0 ? left_ahead : left_behind;
    const double left_y = min_x > 0.0 ? max_y : left_y_beside;
    const double from_x = axis_x * right_x + axis_y * right_y;
    const double from_y = axis_x * right_y - axis_y * right_x;
    const double to_x = axis_x * left_x + axis_y * left_y;
    const double to_y = axis_x * left_y - axis_y * left_x;
    const double from = BearingOf(from_x, from_y, Ratio(from_x, from_y));
    const double to = BearingOf(to_x, to_y, Ratio(to_x, to_y));
    const double high = from + WidthOf(from, to);
    views.low[i] = distance_squared > 0.0 ? from : 0.0;
    views.high[i] = distance_squared > 0.0 ? high : 2.0 * kPi;
    views.distance_squared[i] = distance_squared;
  }
  return views;
}

VFH_ASTAR_FOR_WIDEST_VECTORS
ViewLanes ViewDiscs(const FanFrame& frame, const DiscLanes& discs,
                    DiscLanes* centers) {
  const double origin_x = frame.origin.x(), origin_y = frame.origin.y();
  const double axis_x = frame.axis.x(), axis_y = frame.axis.y();
  ViewLanes views;
  DiscLanes in_fan;
  for (int i = 0; i < kFanLanes; ++i) {
    const double offset_x = discs.x[i] - origin_x;
    const double offset_y = discs.y[i] - origin_y;
    const double radius = discs.radius[i];
    const double x = axis_x * offset_x + axis_y * offset_y;
    const double y = axis_x * offset_y - axis_y * offset_x;
    const double ratio = Ratio(x, y);
    // Not more than the distance and 2 % less at most, without a root: between
    // 0 and 1 the root of 1 + s lies above its chord.
    const double near =
        Max(std::abs(x), std::abs(y)) * (1.0 + 0.414213 * ratio * ratio);
    // Not less than the arc sine, and equal to it where it is a right angle.
    const double sine = radius / near;
    const double half = sine * (1.0 + (0.5 * kPi - 1.0) * sine * sine);
    const double bearing = BearingOf(x, y, ratio);
    views.low[i] = near > radius ? bearing - half : 0.0;
    views.high[i] = near > radius ? bearing + half : 2.0 * kPi;
    views.distance_squared[i] = x * x + y * y;
    in_fan.x[i] = x;
    in_fan.y[i] = y;
    in_fan.radius[i] = radius;
  }
  *centers = in_fan;
  return views;
}

VFH_ASTAR_FOR_WIDEST_VECTORS
std::array<int, kFanLanes> PlacesFromFar(const FanLanes& distances) {
  std::array<int, kFanLanes> places;
  for (int i = 0; i < kFanLanes; ++i) {
    int place = 0;
    for (int j = 0; j < kFanLanes; ++j) {
      place +=
          j < i ? distances[j] >= distances[i] : distances[j] > distances[i];
    }
    places[i] = place;
  }
  return places;
}

VFH_ASTAR_FOR_WIDEST_VECTORS
double MeetDisc(const Eigen::Vector2d& center, double radius, const double* x,
                const double* y, double* ranges) {
  const double center_x = center.x(), center_y = center.y();
  const double radius_squared = radius * radius;
  FanLanes met;
  for (int i = 0; i < kFanLanes; ++i) {
    const double aside = center_x * y[i] - center_y * x[i];
    const double along = center_x * x[i] + center_y * y[i];
    const double half_chord_squared = radius_squared - aside * aside;
    // Infinite for a beam that misses, else 0. Arithmetic instead of branches,
    // which would be guessed wrong at both sides of each disc.
    const double missed =
        Min(Min(half_chord_squared, along), 0.0) * -kHuge * kHuge;
    const double range =
        along - std::sqrt(Max(half_chord_squared, 0.0)) + missed;
    met[i] = Min(ranges[i], range);
  }
  double farthest = met[0];
  for (int i = 0; i < kFanLanes; ++i) {
    ranges[i] = met[i];
    farthest = Max(farthest, met[i]);
  }
  return farthest;
}

}  // namespace vfh_astar
