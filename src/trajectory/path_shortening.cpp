#include "vfh_astar/trajectory/path_shortening.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>

namespace vfh_astar {
namespace {

// Part of the path's own clearance that a shortcut keeps.
constexpr double kKept = 0.85;

class Shortener {
 public:
  Shortener(const Polyline& path, const ClearanceMap& clearance,
            const ShorteningLimits& limits)
      : path_(path), clearance_(clearance), limits_(limits) {
    for (const Eigen::Vector2d& point : path) {
      path_clearance_.push_back(clearance.At(point));
    }
    first_tight_.assign(path.size(), path.size());
    for (std::size_t i = path.size(); i-- > 0;) {
      if (path_clearance_[i] < limits.needed) {
        first_tight_[i] = i;
      } else if (i + 1 < path.size()) {
        first_tight_[i] = first_tight_[i + 1];
      }
    }
  }

  // The farthest point found that can be reached straight from `from`: the
  // distance doubles while that succeeds, then is halved.
  std::size_t FarthestFrom(std::size_t from) const {
    const std::size_t last = path_.size() - 1;
    std::size_t good = from + 1;
    std::size_t bad = last + 1;
    for (std::size_t step = 2; good < last; step *= 2) {
      const std::size_t next = std::min(from + step, last);
      if (!IsStraight(from, next)) {
        bad = next;
        break;
      }
      good = next;
    }
    while (good + 1 < bad) {
      const std::size_t middle = good + (bad - good) / 2;
      (IsStraight(from, middle) ? good : bad) = middle;
    }
    return good;
  }

 private:
  bool IsStraight(std::size_t from, std::size_t to) const {
    if (first_tight_[from] <= to) return false;
    const Eigen::Vector2d way = path_[to] - path_[from];
    const double length = way.norm();
    const double resolution = clearance_.geometry().resolution;
    double at = 0.0;
    while (at < length) {
      const double part = at / length;
      const double here = clearance_.At(path_[from] + part * way);
      const double beside =
          path_clearance_[from + static_cast<std::size_t>(
                                     part * static_cast<double>(to - from))];
      const double kept =
          std::max(limits_.needed, kKept * std::min(beside, limits_.wanted));
      if (here < kept) return false;
      // Ahead, what is there may shrink and what is kept may grow by a metre
      // in a metre.
      at += std::max(0.5 * resolution, 0.5 * (here - kept));
    }
    return true;
  }

  const Polyline& path_;
  const ClearanceMap& clearance_;
  ShorteningLimits limits_;
  std::vector<double> path_clearance_;
  std::vector<std::size_t> first_tight_;  ///< from a point on, the first that
                                          ///< lies nearer than needed.
};

}  // namespace

Polyline ShortenPath(const Polyline& path, const ClearanceMap& clearance,
                     const ShorteningLimits& limits) {
  assert(!path.empty());
  const Shortener shortener(path, clearance, limits);
  Polyline shortened = {path.front()};
  for (std::size_t i = 0; i + 1 < path.size();) {
    i = shortener.FarthestFrom(i);
    shortened.push_back(path[i]);
  }
  return shortened;
}

double FirstShortenedDirection(const Polyline& path,
                               const ClearanceMap& clearance,
                               const ShorteningLimits& limits) {
  assert(path.size() >= 2);
  const Shortener shortener(path, clearance, limits);
  return FirstDirection({path.front(), path[shortener.FarthestFrom(0)]});
}

}  // namespace vfh_astar
