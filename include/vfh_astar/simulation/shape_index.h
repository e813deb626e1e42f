#ifndef VFH_ASTAR_SIMULATION_SHAPE_INDEX_H_
#define VFH_ASTAR_SIMULATION_SHAPE_INDEX_H_

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "vfh_astar/simulation/shape.h"

namespace vfh_astar {

/// Shapes that stand still, sorted into square buckets, so that what is out of
/// reach costs nothing: neither a ray nor a robot looks at it. Each bucket
/// knows how far ahead all buckets are empty, and a ray leaps over those.
class ShapeIndex {
 public:
  ShapeIndex() = default;
  explicit ShapeIndex(std::vector<Shape> shapes);

  const std::vector<Shape>& shapes() const { return shapes_; }

  /// m from `origin` along the unit vector `direction` to the first shape;
  /// infinity when there is none within `range`.
  double CastRay(const Eigen::Vector2d& origin,
                 const Eigen::Vector2d& direction, double range) const;

  /// The same for many rays from one place, faster than one by one.
  /// @param[in] directions `count` unit vectors.
  /// @param[out] distances `count` results.
  void CastRays(const Eigen::Vector2d& origin,
                const Eigen::Vector2d* directions, std::size_t count,
                double range, double* distances) const;

  /// The indices of the shapes that may come within `radius` of a point, each
  /// once, rising.
  std::vector<int> Near(const Eigen::Vector2d& point, double radius) const;

 private:
  struct Bounds {
    Eigen::Vector2d min;
    Eigen::Vector2d max;
  };
  /// A shape as rays see it, all in one place of memory.
  struct Target {
    double x, y, radius_squared;          ///< of a disc,
    std::int32_t first_edge, edge_count;  ///< or of a polygon, else 0.
  };
  /// An edge of a polygon, which lies to its left.
  struct Edge {
    double x, y;    ///< m, where it begins.
    double dx, dy;  ///< m, from there to its end.
  };
  class Ray;

  static Bounds BoundsOf(const Shape& shape);
  void ChooseBuckets();
  void SortIntoBuckets();
  void MeasureEmptiness();
  void AddTarget(const Shape& shape);
  std::size_t Bucket(int column, int row) const {
    return static_cast<std::size_t>(row) * columns_ + column;
  }
  int Column(double x) const;
  int Row(double y) const;
  bool Reaches(const Shape& shape, int column, int row) const;
  double CastInBucket(std::size_t bucket, const Eigen::Vector2d& origin,
                      const Eigen::Vector2d& direction) const;

  std::vector<Shape> shapes_;
  std::vector<Target> targets_;  ///< by shape.
  std::vector<Edge> edges_;
  Bounds bounds_{Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero()};
  double bucket_size_ = 1.0;  ///< m
  int columns_ = 0;
  int rows_ = 0;
  /// Bucket b holds members_[starts_[b]] to members_[starts_[b + 1] - 1].
  std::vector<std::int32_t> starts_;
  std::vector<std::int32_t> members_;
  /// By quadrant and bucket: how many buckets a side a square has that grows
  /// from the bucket into the quadrant and meets no shape.
  std::array<std::vector<std::uint8_t>, 4> open_squares_;
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_SIMULATION_SHAPE_INDEX_H_
