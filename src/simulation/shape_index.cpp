#include "vfh_astar/simulation/shape_index.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace vfh_astar {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// m. Buckets of a fraction of the mean spacing mostly hold one shape or none.
constexpr double kSmallestBucket = 0.1;
constexpr double kLargestBucket = 0.5;
constexpr double kBucketsPerSpacing = 6.0;
constexpr double kMostBuckets = 4e6;

/// m by which a leap ends beyond a bucket's border, so that rounding does not
/// leave the ray in the bucket that it has left; shapes count as this much
/// larger when they are sorted in.
constexpr double kOverlap = 1e-7;

// The bits of a quadrant's number.
constexpr int kRightward = 1;
constexpr int kUpward = 2;

}  // namespace

ShapeIndex::ShapeIndex(std::vector<Shape> shapes) : shapes_(std::move(shapes)) {
  if (shapes_.empty()) return;
  for (const Shape& shape : shapes_) AddTarget(shape);
  ChooseBuckets();
  SortIntoBuckets();
  MeasureEmptiness();
}

ShapeIndex::Bounds ShapeIndex::BoundsOf(const Shape& shape) {
  if (shape.IsDisc()) {
    const Eigen::Vector2d radius(shape.radius, shape.radius);
    return {shape.center - radius, shape.center + radius};
  }
  Bounds bounds{shape.vertices.front(), shape.vertices.front()};
  for (const Eigen::Vector2d& vertex : shape.vertices) {
    bounds.min = bounds.min.cwiseMin(vertex);
    bounds.max = bounds.max.cwiseMax(vertex);
  }
  return bounds;
}

void ShapeIndex::AddTarget(const Shape& shape) {
  Target target{shape.center.x(), shape.center.y(), shape.radius * shape.radius,
                static_cast<std::int32_t>(edges_.size()), 0};
  const std::size_t count = shape.vertices.size();
  target.edge_count = static_cast<std::int32_t>(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Vector2d& from = shape.vertices[i];
    const Eigen::Vector2d edge = shape.vertices[(i + 1) % count] - from;
    edges_.push_back({from.x(), from.y(), edge.x(), edge.y()});
  }
  targets_.push_back(target);
}

void ShapeIndex::ChooseBuckets() {
  bounds_ = BoundsOf(shapes_.front());
  for (const Shape& shape : shapes_) {
    const Bounds bounds = BoundsOf(shape);
    bounds_.min = bounds_.min.cwiseMin(bounds.min);
    bounds_.max = bounds_.max.cwiseMax(bounds.max);
  }
  const Eigen::Vector2d size = bounds_.max - bounds_.min;
  const double spacing =
      std::sqrt(size.prod() / static_cast<double>(shapes_.size()));
  bucket_size_ = std::max(
      std::clamp(spacing / kBucketsPerSpacing, kSmallestBucket, kLargestBucket),
      std::sqrt(size.prod() / kMostBuckets));
  // A margin, so that rounding never has a ray look beyond the buckets.
  bounds_.min.array() -= 0.5 * bucket_size_;
  columns_ = static_cast<int>(std::floor(size.x() / bucket_size_)) + 2;
  rows_ = static_cast<int>(std::floor(size.y() / bucket_size_)) + 2;
}

int ShapeIndex::Column(double x) const {
  return static_cast<int>(std::floor(
      std::clamp((x - bounds_.min.x()) / bucket_size_, -1.0, columns_ + 0.0)));
}

int ShapeIndex::Row(double y) const {
  return static_cast<int>(std::floor(
      std::clamp((y - bounds_.min.y()) / bucket_size_, -1.0, rows_ + 0.0)));
}

bool ShapeIndex::Reaches(const Shape& shape, int column, int row) const {
  const Eigen::Vector2d middle =
      bounds_.min + bucket_size_ * Eigen::Vector2d(column + 0.5, row + 0.5);
  const Shape bucket =
      MakeBox(Pose2D(middle, 0.0), Eigen::Vector2d::Constant(bucket_size_));
  return Distance(bucket, shape) <= kOverlap;
}

void ShapeIndex::SortIntoBuckets() {
  std::vector<std::vector<std::int32_t>> buckets(
      static_cast<std::size_t>(columns_) * rows_);
  for (std::size_t i = 0; i < shapes_.size(); ++i) {
    const Bounds bounds = BoundsOf(shapes_[i]);
    const int last_row = std::min(rows_ - 1, Row(bounds.max.y() + kOverlap));
    const int last_column =
        std::min(columns_ - 1, Column(bounds.max.x() + kOverlap));
    for (int row = std::max(0, Row(bounds.min.y() - kOverlap)); row <= last_row;
         ++row) {
      for (int column = std::max(0, Column(bounds.min.x() - kOverlap));
           column <= last_column; ++column) {
        if (!Reaches(shapes_[i], column, row)) continue;
        buckets[Bucket(column, row)].push_back(static_cast<std::int32_t>(i));
      }
    }
  }
  for (const std::vector<std::int32_t>& bucket : buckets) {
    starts_.push_back(static_cast<std::int32_t>(members_.size()));
    members_.insert(members_.end(), bucket.begin(), bucket.end());
  }
  starts_.push_back(static_cast<std::int32_t>(members_.size()));
}

void ShapeIndex::MeasureEmptiness() {
  constexpr int kMost = std::numeric_limits<std::uint8_t>::max();
  for (int quadrant = 0; quadrant < 4; ++quadrant) {
    // A square grows from its corner as far as the squares of the three
    // neighbours that it covers do, so those have to be known first.
    const int dx = (quadrant & kRightward) != 0 ? 1 : -1;
    const int dy = (quadrant & kUpward) != 0 ? 1 : -1;
    std::vector<std::uint8_t>& squares = open_squares_[quadrant];
    squares.assign(static_cast<std::size_t>(columns_) * rows_, 0);
    const auto open_at = [&](int column, int row) -> int {
      // Beyond the bounds there is nothing.
      if (column < 0 || column >= columns_ || row < 0 || row >= rows_) {
        return kMost;
      }
      return squares[Bucket(column, row)];
    };
    for (int i = 0; i < rows_; ++i) {
      const int row = dy > 0 ? rows_ - 1 - i : i;
      for (int j = 0; j < columns_; ++j) {
        const int column = dx > 0 ? columns_ - 1 - j : j;
        const std::size_t bucket = Bucket(column, row);
        if (starts_[bucket] != starts_[bucket + 1]) continue;
        const int neighbours =
            std::min({open_at(column + dx, row), open_at(column, row + dy),
                      open_at(column + dx, row + dy)});
        squares[bucket] =
            static_cast<std::uint8_t>(std::min(kMost, neighbours + 1));
      }
    }
  }
}

double ShapeIndex::CastInBucket(std::size_t bucket,
                                const Eigen::Vector2d& origin,
                                const Eigen::Vector2d& direction) const {
  double nearest = kInfinity;
  for (std::int32_t m = starts_[bucket]; m < starts_[bucket + 1]; ++m) {
    const Target& target = targets_[members_[m]];
    if (target.edge_count == 0) {
      const double x = target.x - origin.x();
      const double y = target.y - origin.y();
      const double along = x * direction.x() + y * direction.y();
      const double outside = x * x + y * y - target.radius_squared;
      const double half_chord_squared = along * along - outside;
      if (outside <= 0.0) return 0.0;
      if (along < 0.0 || half_chord_squared < 0.0) continue;
      nearest = std::min(nearest, along - std::sqrt(half_chord_squared));
      continue;
    }
    // The part of the ray that lies inside of every edge.
    double enter = 0.0;
    double leave = nearest;
    for (std::int32_t e = 0; e < target.edge_count; ++e) {
      const Edge& edge = edges_[target.first_edge + e];
      const double outside =
          (origin.x() - edge.x) * edge.dy - (origin.y() - edge.y) * edge.dx;
      const double rate = edge.dx * direction.y() - edge.dy * direction.x();
      if (rate > 0.0) {
        enter = std::max(enter, outside / rate);
      } else if (rate < 0.0) {
        leave = std::min(leave, outside / rate);
      } else if (outside > 0.0) {
        leave = -kInfinity;
      }
    }
    if (enter <= leave) nearest = enter;
  }
  return nearest;
}

/// A ray on its way over the buckets. Its course is in units of buckets, but
/// for `along_`, which is in metres.
class ShapeIndex::Ray {
 public:
  Ray() = default;
  Ray(const ShapeIndex& index, const Eigen::Vector2d& origin,
      const Eigen::Vector2d& direction, double range)
      : x_(origin.x() - index.bounds_.min.x(), direction.x(),
           index.bucket_size_, index.columns_),
        y_(origin.y() - index.bounds_.min.y(), direction.y(),
           index.bucket_size_, index.rows_),
        open_squares_(index
                          .open_squares_[(x_.rises ? kRightward : 0) |
                                         (y_.rises ? kUpward : 0)]
                          .data()),
        origin_(origin),
        direction_(direction) {
    along_ = std::max({0.0, x_.Enter(), y_.Enter()});
    end_ = std::min({range, x_.Leave(), y_.Leave()});
  }

  /// Goes on to the next bucket that matters.
  /// @return false when it has come to its end.
  bool Advance(const ShapeIndex& index) {
    if (!(along_ <= end_)) return false;
    const int column = x_.At(along_);
    const int row = y_.At(along_);
    const std::size_t bucket = index.Bucket(column, row);
    const int reach = open_squares_[bucket];
    const int steps = std::max(reach, 1);
    const double border =
        std::min(x_.LeaveSlab(column, steps), y_.LeaveSlab(row, steps));
    if (reach == 0) {
      // A shape that reaches into several buckets may be met beyond this one;
      // it counts as soon as the ray has come as far.
      nearest_ =
          std::min(nearest_, index.CastInBucket(bucket, origin_, direction_));
      if (nearest_ <= border) return false;
    }
    along_ = border + kOverlap;
    return true;
  }

  /// m to the nearest shape that was met.
  double nearest() const { return nearest_; }

 private:
  /// One coordinate of the course.
  struct Axis {
    Axis() = default;
    Axis(double from_in, double slope_in, double bucket_size, int count_in)
        : from(from_in / bucket_size),
          slope(slope_in / bucket_size),
          inverse(1.0 / slope),
          rises(slope >= 0.0 ? 1 : 0),
          count(count_in) {}

    double To(int border) const { return (border - from) * inverse; }
    double Enter() const {
      if (slope != 0.0) return To(rises ? 0 : count);
      return 0.0 <= from && from <= count ? 0.0 : kInfinity;
    }
    double Leave() const {
      return slope != 0.0 ? To(rises ? count : 0) : kInfinity;
    }
    int At(double along) const {
      // Rounding may have it on the far border or just outside of either.
      return std::min(count - 1, static_cast<int>(from + along * slope));
    }
    double LeaveSlab(int bucket, int steps) const {
      return slope != 0.0 ? To(rises ? bucket + steps : bucket - steps + 1)
                          : kInfinity;
    }

    double from = 0.0, slope = 0.0, inverse = 0.0;
    int rises = 0, count = 0;
  };

  Axis x_;
  Axis y_;
  const std::uint8_t* open_squares_ = nullptr;  ///< of the ray's quadrant.
  Eigen::Vector2d origin_;
  Eigen::Vector2d direction_;
  double along_ = 0.0;  ///< m
  double end_ = 0.0;    ///< m
  double nearest_ = kInfinity;
};

double ShapeIndex::CastRay(const Eigen::Vector2d& origin,
                           const Eigen::Vector2d& direction,
                           double range) const {
  std::array<double, 1> nearest;
  CastRays(origin, &direction, 1, range, nearest.data());
  return nearest.front();
}

void ShapeIndex::CastRays(const Eigen::Vector2d& origin,
                          const Eigen::Vector2d* directions, std::size_t count,
                          double range, double* distances) const {
  std::fill(distances, distances + count, kInfinity);
  if (shapes_.empty()) return;
  // A step along a ray waits for the one before; steps along different rays
  // wait for nothing, so the processor is given several to go along at once.
  constexpr std::size_t kAtOnce = 8;
  std::array<Ray, kAtOnce> rays;
  std::array<std::size_t, kAtOnce> numbers;
  std::size_t started = 0;
  std::size_t under_way = 0;
  const auto start = [&](std::size_t slot) {
    rays[slot] = Ray(*this, origin, directions[started], range);
    numbers[slot] = started++;
  };
  while (under_way < kAtOnce && started < count) start(under_way++);
  while (under_way > 0) {
    for (std::size_t slot = 0; slot < under_way;) {
      if (rays[slot].Advance(*this)) {
        ++slot;
        continue;
      }
      const double nearest = rays[slot].nearest();
      if (nearest <= range) distances[numbers[slot]] = nearest;
      if (started < count) {
        start(slot);
      } else {
        --under_way;
        rays[slot] = rays[under_way];
        numbers[slot] = numbers[under_way];
      }
    }
  }
}

std::vector<int> ShapeIndex::Near(const Eigen::Vector2d& point,
                                  double radius) const {
  std::vector<int> near;
  if (shapes_.empty()) return near;
  const int column = Column(point.x());
  const int row = Row(point.y());
  if (0 <= column && column < columns_ && 0 <= row && row < rows_) {
    int steps = std::numeric_limits<int>::max();
    for (const std::vector<std::uint8_t>& squares : open_squares_) {
      steps = std::min<int>(steps, squares[Bucket(column, row)]);
    }
    if ((steps - 1) * bucket_size_ > radius) return near;
  }
  const int first_row = std::max(0, Row(point.y() - radius));
  const int last_row = std::min(rows_ - 1, Row(point.y() + radius));
  const int first_column = std::max(0, Column(point.x() - radius));
  const int last_column = std::min(columns_ - 1, Column(point.x() + radius));
  for (int row = first_row; row <= last_row; ++row) {
    for (int column = first_column; column <= last_column; ++column) {
      const std::size_t bucket = Bucket(column, row);
      near.insert(near.end(), members_.begin() + starts_[bucket],
                  members_.begin() + starts_[bucket + 1]);
    }
  }
  std::sort(near.begin(), near.end());
  near.erase(std::unique(near.begin(), near.end()), near.end());
  return near;
}

}  // namespace vfh_astar
