#include "vfh_astar/mapping/correlative_search.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <opencv2/core/fast_math.hpp>
#include <opencv2/core/types.hpp>

namespace vfh_astar {
namespace {

constexpr int kTopLevel = 4;

/// A part of a field, and for each level the largest value in the square of
/// 2^level cells that begins at a cell.
class MaximaPyramid {
 public:
  /// @param[in] cells what the squares of the top level may touch.
  MaximaPyramid(const HitField& field, const cv::Rect& cells)
      : stride_(cells.width) {
    levels_.push_back(field.Values(cells));
    std::vector<std::uint8_t> wide;
    for (int level = 1; level <= kTopLevel; ++level) {
      const int step = 1 << (level - 1);
      TakeLarger(levels_.back(), step, wide);
      levels_.emplace_back();
      TakeLarger(wide, step * stride_, levels_.back());
    }
  }

  int stride() const { return stride_; }
  const std::uint8_t* level(int level) const { return levels_[level].data(); }

 private:
  /// Past a row's end comes the next row: such squares are outside the part.
  static void TakeLarger(const std::vector<std::uint8_t>& from,
                         std::size_t step, std::vector<std::uint8_t>& to) {
    to = from;
    if (from.size() <= step) return;
    const std::size_t count = from.size() - step;
    const std::uint8_t* const near = from.data();
    const std::uint8_t* const far = near + step;
    std::uint8_t* const out = to.data();
    for (std::size_t i = 0; i < count; ++i) out[i] = std::max(near[i], far[i]);
  }

  int stride_;
  std::vector<std::vector<std::uint8_t>> levels_;
};

/// A scan at one of the angles, in the centre's place.
struct TurnedScan {
  double angle;    ///< rad from the centre's.
  double penalty;  ///< for the angle.
  std::vector<cv::Point> cells;
  std::vector<int> offsets;  ///< of the cells in the pyramid.
};

/// The shifts of a square of 2^level cells, beginning at (x, y).
struct Candidate {
  int turn;
  int x;
  int y;
  double bound;  ///< no pose in the square has a greater value.
};

class Search {
 public:
  Search(const HitField& field, const std::vector<Eigen::Vector2d>& points,
         const Pose2D& centre, const SearchWindow& window, double min_value)
      : resolution_(field.resolution()),
        window_(window),
        reach_(static_cast<int>(std::ceil(window.linear / resolution_))),
        turned_(Turn(points, centre)),
        pyramid_(field, Place()),
        best_{-1, 0, 0, min_value} {}

  std::optional<SearchResult> Run(const Pose2D& centre) {
    const int step = 1 << kTopLevel;
    std::vector<Candidate> candidates;
    for (std::size_t turn = 0; turn < turned_.size(); ++turn) {
      for (int y = -reach_; y <= reach_; y += step) {
        for (int x = -reach_; x <= reach_; x += step) {
          Add(static_cast<int>(turn), x, y, kTopLevel, candidates);
        }
      }
    }
    Descend(candidates, kTopLevel);
    if (best_.turn < 0) return std::nullopt;
    const TurnedScan& turned = turned_[best_.turn];
    return SearchResult{
        {centre.x + resolution_ * best_.x, centre.y + resolution_ * best_.y,
         NormalizeAngle(centre.theta + turned.angle)},
        best_.bound + Penalty(turned, best_.x, best_.y, 0),
        best_.bound};
  }

 private:
  std::vector<TurnedScan> Turn(const std::vector<Eigen::Vector2d>& points,
                               const Pose2D& centre) const {
    const int turns =
        static_cast<int>(std::ceil(window_.angular / window_.angular_step));
    std::vector<TurnedScan> turned(2 * turns + 1);
    for (int i = -turns; i <= turns; ++i) {
      TurnedScan& scan = turned[i + turns];
      scan.angle = i * window_.angular_step;
      scan.penalty = window_.angular_penalty * scan.angle * scan.angle;
      scan.cells.reserve(points.size());
      const double c = std::cos(centre.theta + scan.angle) / resolution_;
      const double s = std::sin(centre.theta + scan.angle) / resolution_;
      const double x = centre.x / resolution_;
      const double y = centre.y / resolution_;
      for (const Eigen::Vector2d& point : points) {
        scan.cells.emplace_back(cvFloor(x + c * point.x() - s * point.y()),
                                cvFloor(y + s * point.x() + c * point.y()));
      }
    }
    return turned;
  }

  /// Finds the part of the field that the search may touch, and where in it the
  /// scans' cells lie.
  cv::Rect Place() {
    cv::Point low = turned_.front().cells.front();
    cv::Point high = low;
    for (const TurnedScan& scan : turned_) {
      for (const cv::Point& cell : scan.cells) {
        low = {std::min(low.x, cell.x), std::min(low.y, cell.y)};
        high = {std::max(high.x, cell.x), std::max(high.y, cell.y)};
      }
    }
    // A square may begin at the largest shift and reach beyond it.
    const int beyond = reach_ + 2 * (1 << kTopLevel);
    const cv::Rect part(low - cv::Point(reach_, reach_),
                        high + cv::Point(beyond, beyond));
    for (TurnedScan& scan : turned_) {
      scan.offsets.reserve(scan.cells.size());
      for (const cv::Point& cell : scan.cells) {
        scan.offsets.push_back((cell.y - part.y) * part.width + cell.x -
                               part.x);
      }
    }
    return part;
  }

  double Penalty(const TurnedScan& scan, int x, int y, int level) const {
    const auto distance = [&](int first) {
      const int last = first + (1 << level) - 1;
      return resolution_ * std::max({0, first, -last});
    };
    return scan.penalty + window_.linear_penalty * (distance(x) * distance(x) +
                                                    distance(y) * distance(y));
  }

  void Add(int turn, int x, int y, int level,
           std::vector<Candidate>& candidates) const {
    const TurnedScan& scan = turned_[turn];
    const double penalty = Penalty(scan, x, y, level);
    if (1.0 - penalty <= best_.bound) return;
    const std::uint8_t* const values =
        pyramid_.level(level) + y * pyramid_.stride() + x;
    int sum = 0;
    for (const int offset : scan.offsets) sum += values[offset];
    const double bound = sum / (255.0 * scan.offsets.size()) - penalty;
    if (bound > best_.bound) candidates.push_back({turn, x, y, bound});
  }

  void Descend(std::vector<Candidate>& candidates, int level) {
    // Ties are broken by the order of the search, so that the result depends
    // on nothing else.
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const Candidate& a, const Candidate& b) {
                       return a.bound > b.bound;
                     });
    for (const Candidate& candidate : candidates) {
      if (candidate.bound <= best_.bound) return;
      if (level == 0) {
        best_ = candidate;
        return;
      }
      const int half = 1 << (level - 1);
      std::vector<Candidate> parts;
      for (const int y : {candidate.y, candidate.y + half}) {
        for (const int x : {candidate.x, candidate.x + half}) {
          if (x > reach_ || y > reach_) continue;
          Add(candidate.turn, x, y, level - 1, parts);
        }
      }
      Descend(parts, level - 1);
    }
  }

  double resolution_;
  SearchWindow window_;
  int reach_;  ///< cells
  std::vector<TurnedScan> turned_;
  MaximaPyramid pyramid_;
  Candidate best_;
};

}  // namespace

std::optional<SearchResult> SearchPose(
    const HitField& field, const std::vector<Eigen::Vector2d>& points,
    const Pose2D& centre, const SearchWindow& window, double min_value) {
  if (points.empty()) return std::nullopt;
  return Search(field, points, centre, window, min_value).Run(centre);
}

}  // namespace vfh_astar
