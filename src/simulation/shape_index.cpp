#include "vfh_astar/simulation/shape_index.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace vfh_astar {
namespace {

/// m. Small enough that a bucket in a field of posts holds a handful, large
/// enough that a ray through open space passes few.
constexpr double kBucketSize = 0.5;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// m along a ray at which it meets a disc from outside, or 0 from inside.
inline double CastOnDisc(const Shape& disc, const Eigen::Vector2d& origin,
                         const Eigen::Vector2d& direction) {
  const Eigen::Vector2d to_center = disc.center - origin;
  const double along = to_center.dot(direction);
  const double distance_squared = to_center.squaredNorm();
  const double radius_squared = disc.radius * disc.radius;
  if (distance_squared <= radius_squared) return 0.0;
  const double across_squared = distance_squared - along * along;
  if (along < 0.0 || across_squared > radius_squared) return kInfinity;
  return along - std::sqrt(radius_squared - across_squared);
}

}  // namespace

ShapeIndex::ShapeIndex(std::vector<Shape> shapes) : shapes_(std::move(shapes)) {
  if (shapes_.empty()) return;
  bounds_ = BoundsOf(shapes_.front());
  for (const Shape& shape : shapes_) {
    const Bounds bounds = BoundsOf(shape);
    bounds_.min = bounds_.min.cwiseMin(bounds.min);
    bounds_.max = bounds_.max.cwiseMax(bounds.max);
  }
  const Eigen::Vector2d size = bounds_.max - bounds_.min;
  columns_ = static_cast<int>(std::floor(size.x() / kBucketSize)) + 1;
  rows_ = static_cast<int>(std::floor(size.y() / kBucketSize)) + 1;
  SortIntoBuckets();
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

int ShapeIndex::Column(double x) const {
  return static_cast<int>(std::floor((x - bounds_.min.x()) / kBucketSize));
}

int ShapeIndex::Row(double y) const {
  return static_cast<int>(std::floor((y - bounds_.min.y()) / kBucketSize));
}

void ShapeIndex::SortIntoBuckets() {
  const auto for_each_bucket = [this](const Shape& shape, const auto& visit) {
    const Bounds bounds = BoundsOf(shape);
    for (int row = Row(bounds.min.y()); row <= Row(bounds.max.y()); ++row) {
      for (int column = Column(bounds.min.x());
           column <= Column(bounds.max.x()); ++column) {
        visit(static_cast<std::size_t>(row) * columns_ + column);
      }
    }
  };
  starts_.assign(static_cast<std::size_t>(columns_) * rows_ + 1, 0);
  for (const Shape& shape : shapes_) {
    for_each_bucket(shape, [this](std::size_t b) { ++starts_[b + 1]; });
  }
  for (std::size_t b = 1; b < starts_.size(); ++b) starts_[b] += starts_[b - 1];
  members_.resize(starts_.back());
  std::vector<std::int32_t> next(starts_.begin(), starts_.end() - 1);
  for (std::size_t i = 0; i < shapes_.size(); ++i) {
    for_each_bucket(shapes_[i], [&](std::size_t b) {
      members_[next[b]++] = static_cast<std::int32_t>(i);
    });
  }
}

double ShapeIndex::CastInBucket(std::size_t bucket,
                                const Eigen::Vector2d& origin,
                                const Eigen::Vector2d& direction) const {
  double nearest = kInfinity;
  for (std::int32_t m = starts_[bucket]; m < starts_[bucket + 1]; ++m) {
    const Shape& shape = shapes_[members_[m]];
    const double distance = shape.IsDisc()
                                ? CastOnDisc(shape, origin, direction)
                                : RayDistance(shape, origin, direction);
    nearest = std::min(nearest, distance);
  }
  return nearest;
}

double ShapeIndex::CastRay(const Eigen::Vector2d& origin,
                           const Eigen::Vector2d& direction,
                           double range) const {
  if (shapes_.empty()) return kInfinity;
  // Where the ray is within the buckets' bounds.
  double enter = 0.0;
  double leave = range;
  for (int axis = 0; axis < 2; ++axis) {
    const double slope = direction[axis];
    if (slope == 0.0) {
      if (origin[axis] < bounds_.min[axis] ||
          origin[axis] > bounds_.max[axis]) {
        return kInfinity;
      }
      continue;
    }
    const double a = (bounds_.min[axis] - origin[axis]) / slope;
    const double b = (bounds_.max[axis] - origin[axis]) / slope;
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  if (enter > leave) return kInfinity;

  const Eigen::Vector2d start = origin + enter * direction;
  int column = std::clamp(Column(start.x()), 0, columns_ - 1);
  int row = std::clamp(Row(start.y()), 0, rows_ - 1);
  const int column_step = direction.x() > 0.0 ? 1 : -1;
  const int row_step = direction.y() > 0.0 ? 1 : -1;
  const auto to_border = [](double minimum, int cell, int step, double from,
                            double slope) {
    if (slope == 0.0) return kInfinity;
    const double border = minimum + (cell + (step > 0 ? 1 : 0)) * kBucketSize;
    return (border - from) / slope;
  };
  double next_column = to_border(bounds_.min.x(), column, column_step,
                                 origin.x(), direction.x());
  double next_row =
      to_border(bounds_.min.y(), row, row_step, origin.y(), direction.y());
  const double column_stride = kBucketSize / std::abs(direction.x());
  const double row_stride = kBucketSize / std::abs(direction.y());

  // A shape that reaches into several buckets may be met beyond this one; what
  // was found counts as soon as the ray has come as far.
  double nearest = kInfinity;
  while (true) {
    const std::size_t bucket =
        static_cast<std::size_t>(row) * columns_ + column;
    nearest = std::min(nearest, CastInBucket(bucket, origin, direction));
    const double border = std::min(next_column, next_row);
    if (nearest <= border) return nearest <= range ? nearest : kInfinity;
    if (border > leave) return kInfinity;
    if (next_column < next_row) {
      column += column_step;
      next_column += column_stride;
      if (column < 0 || column >= columns_) break;
    } else {
      row += row_step;
      next_row += row_stride;
      if (row < 0 || row >= rows_) break;
    }
  }
  return nearest <= range ? nearest : kInfinity;
}

std::vector<int> ShapeIndex::Near(const Eigen::Vector2d& point,
                                  double radius) const {
  std::vector<int> near;
  const int first_row = std::max(0, Row(point.y() - radius));
  const int last_row = std::min(rows_ - 1, Row(point.y() + radius));
  const int first_column = std::max(0, Column(point.x() - radius));
  const int last_column = std::min(columns_ - 1, Column(point.x() + radius));
  for (int row = first_row; row <= last_row; ++row) {
    for (int column = first_column; column <= last_column; ++column) {
      const std::size_t bucket =
          static_cast<std::size_t>(row) * columns_ + column;
      near.insert(near.end(), members_.begin() + starts_[bucket],
                  members_.begin() + starts_[bucket + 1]);
    }
  }
  std::sort(near.begin(), near.end());
  near.erase(std::unique(near.begin(), near.end()), near.end());
  return near;
}

}  // namespace vfh_astar
