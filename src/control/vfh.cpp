#include "vfh_astar/control/vfh.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace vfh_astar {
namespace {

int SectorOf(double angle, int sectors) {
  const int sector =
      static_cast<int>(std::floor((angle + kPi) / (2.0 * kPi) * sectors));
  return (sector % sectors + sectors) % sectors;
}

double AngleBetween(double a, double b) {
  return std::abs(NormalizeAngle(a - b));
}

/// True when `angle` lies in [from, from + width].
bool Covers(double from, double width, double angle) {
  const double offset = std::remainder(angle - from - 0.5 * width, 2.0 * kPi);
  return std::abs(offset) <= 0.5 * width + 1e-9;
}

/// The directions through a valley that are worth a cost: a narrow one is taken
/// in the middle, a wide one near its borders or straight towards the target.
std::vector<double> Candidates(const Valley& valley, double wide,
                               double target) {
  if (valley.width >= 2.0 * kPi) return {target};
  if (valley.width < wide) {
    return {NormalizeAngle(valley.from + 0.5 * valley.width)};
  }
  const double right = valley.from + 0.5 * wide;
  const double inner_width = valley.width - wide;
  std::vector<double> directions = {NormalizeAngle(right),
                                    NormalizeAngle(right + inner_width)};
  if (Covers(right, inner_width, target)) directions.push_back(target);
  return directions;
}

}  // namespace

void VfhParameters::Read(ParameterReader& reader) {
  reader.Number("sector_angle", sector_angle, 0.01, 0.8);
  reader.Number("window", window, 0.1, 30.0);
  reader.Number("robot_radius", robot_radius, 0.0, 5.0);
  reader.Integer("smoothing", smoothing, 0, 20);
  reader.Number("threshold_low", threshold_low, 0.0, 1.0);
  reader.Number("threshold_high", threshold_high, 0.0, 1.0);
  reader.Number("wide_valley", wide_valley, 0.0, 3.2);
  reader.Number("target_weight", target_weight, 0.0, 100.0);
  reader.Number("heading_weight", heading_weight, 0.0, 100.0);
  reader.Number("previous_weight", previous_weight, 0.0, 100.0);
  reader.Number("look_ahead", look_ahead, 0.05, 10.0);
  reader.Number("speed", speed, 0.01, 10.0);
  reader.Number("slow_angle", slow_angle, 0.05, 10.0);
  reader.Number("low_pass", low_pass, 0.01, 1.0);
  if (threshold_low > threshold_high) {
    throw ParameterError("parameter vfh/threshold_low is " +
                         std::to_string(threshold_low) +
                         "; expected no more than threshold_high, " +
                         std::to_string(threshold_high));
  }
}

Vfh::Vfh(const VfhParameters& parameters)
    : parameters_(parameters),
      sectors_(
          static_cast<int>(std::lround(2.0 * kPi / parameters.sector_angle))) {
  Reset();
}

void Vfh::Reset() {
  blocked_.assign(sectors_, false);
  previous_direction_.reset();
  filtered_w_ = 0.0;
}

std::vector<double> Vfh::Histogram(
    const std::vector<Eigen::Vector2d>& obstacles) const {
  std::vector<double> density(sectors_, 0.0);
  for (const Eigen::Vector2d& point : obstacles) {
    const double distance = point.norm();
    if (distance > parameters_.window || distance == 0.0) continue;
    // The magnitude c^2 (a - b d) with certainty 1 and a = b * window. A sector
    // keeps its nearest obstacle: the laser's beams are far denser than the
    // sonar cells whose sum the original takes, and their number says nothing.
    const double magnitude = 1.0 - distance / parameters_.window;
    const double angle = std::atan2(point.y(), point.x());
    const double enlargement =
        parameters_.robot_radius >= distance
            ? 0.5 * kPi
            : std::asin(parameters_.robot_radius / distance);
    const int centre = SectorOf(angle, sectors_);
    const int reach =
        static_cast<int>(std::ceil(enlargement / (2.0 * kPi) * sectors_ - 0.5));
    for (int offset = -reach; offset <= reach; ++offset) {
      const int sector = (centre + offset + 2 * sectors_) % sectors_;
      density[sector] = std::max(density[sector], magnitude);
    }
  }
  return density;
}

void Vfh::UpdateBlocked(const std::vector<double>& histogram) {
  for (int sector = 0; sector < sectors_; ++sector) {
    const double threshold = blocked_[sector] ? parameters_.threshold_low
                                              : parameters_.threshold_high;
    blocked_[sector] = histogram[sector] > threshold;
  }
}

std::optional<double> Vfh::ChooseDirection(double target) const {
  std::optional<double> best;
  double best_cost = std::numeric_limits<double>::infinity();
  for (const Valley& valley : FindValleys(blocked_)) {
    for (const double direction :
         Candidates(valley, parameters_.wide_valley, target)) {
      const double cost =
          parameters_.target_weight * AngleBetween(direction, target) +
          parameters_.heading_weight * std::abs(direction) +
          parameters_.previous_weight *
              AngleBetween(direction, previous_direction_.value_or(direction));
      if (cost < best_cost) {
        best_cost = cost;
        best = direction;
      }
    }
  }
  return best;
}

VfhResult Vfh::Update(const std::vector<Eigen::Vector2d>& obstacles,
                      double target) {
  VfhResult result;
  result.histogram = SmoothCircle(Histogram(obstacles), parameters_.smoothing);
  UpdateBlocked(result.histogram);
  result.blocked = blocked_;
  const std::optional<double> direction = ChooseDirection(target);
  previous_direction_ = direction;
  if (!direction) {
    filtered_w_ = 0.0;
    return result;
  }
  result.open = true;
  result.direction = *direction;
  double slowing =
      parameters_.slow_angle >= kPi
          ? 1.0
          : std::max(0.0, 1.0 - std::abs(*direction) / parameters_.slow_angle);
  // The arc through a point behind would first lead away from it, into what is
  // being avoided.
  if (std::abs(*direction) > 0.5 * kPi) slowing = 0.0;
  const double turn = 2.0 * parameters_.speed *
                      std::sin(std::clamp(*direction, -0.5 * kPi, 0.5 * kPi)) /
                      parameters_.look_ahead;
  filtered_w_ =
      (1.0 - parameters_.low_pass) * filtered_w_ + parameters_.low_pass * turn;
  result.command = {slowing * parameters_.speed, filtered_w_};
  return result;
}

std::vector<double> SmoothCircle(const std::vector<double>& values, int reach) {
  const int size = static_cast<int>(values.size());
  std::vector<double> smoothed(values.size());
  for (int i = 0; i < size; ++i) {
    // Triangular weights, as in Borenstein and Koren's equation 5.
    double sum = 0.0;
    double weights = 0.0;
    for (int offset = -reach; offset <= reach; ++offset) {
      const double weight = reach + 1 - std::abs(offset);
      sum += weight * values[((i + offset) % size + size) % size];
      weights += weight;
    }
    smoothed[i] = sum / weights;
  }
  return smoothed;
}

std::vector<Valley> FindValleys(const std::vector<bool>& blocked) {
  const int sectors = static_cast<int>(blocked.size());
  const double width = 2.0 * kPi / sectors;
  const auto wall = std::find(blocked.begin(), blocked.end(), true);
  if (wall == blocked.end()) return {{-kPi, 2.0 * kPi}};
  const int first = static_cast<int>(wall - blocked.begin());
  std::vector<Valley> valleys;
  int open = 0;
  // Once around from a blocked sector to itself, so that no valley is cut.
  for (int step = 1; step <= sectors; ++step) {
    const int sector = (first + step) % sectors;
    if (!blocked[sector]) {
      ++open;
      continue;
    }
    if (open > 0) {
      const int begin = ((sector - open) % sectors + sectors) % sectors;
      valleys.push_back({-kPi + begin * width, open * width});
    }
    open = 0;
  }
  return valleys;
}

}  // namespace vfh_astar
