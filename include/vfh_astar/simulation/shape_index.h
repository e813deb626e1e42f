#ifndef VFH_ASTAR_SIMULATION_SHAPE_INDEX_H_
#define VFH_ASTAR_SIMULATION_SHAPE_INDEX_H_

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "vfh_astar/simulation/shape.h"

namespace vfh_astar {

/// Shapes that stand still, sorted into square buckets, so that what is out of
/// reach costs nothing: neither a ray nor a robot looks at it.
class ShapeIndex {
 public:
  ShapeIndex() = default;
  explicit ShapeIndex(std::vector<Shape> shapes);

  const std::vector<Shape>& shapes() const { return shapes_; }

  /// m from `origin` along the unit vector `direction` to the first shape;
  /// infinity when there is none within `range`.
  double CastRay(const Eigen::Vector2d& origin,
                 const Eigen::Vector2d& direction, double range) const;

  /// The indices of the shapes that may come within `radius` of a point, each
  /// once, rising.
  std::vector<int> Near(const Eigen::Vector2d& point, double radius) const;

 private:
  struct Bounds {
    Eigen::Vector2d min;
    Eigen::Vector2d max;
  };

  static Bounds BoundsOf(const Shape& shape);
  void SortIntoBuckets();
  int Column(double x) const;
  int Row(double y) const;
  double CastInBucket(std::size_t bucket, const Eigen::Vector2d& origin,
                      const Eigen::Vector2d& direction) const;

  std::vector<Shape> shapes_;
  Bounds bounds_{Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero()};
  int columns_ = 0;
  int rows_ = 0;
  /// Bucket b holds members_[starts_[b]] to members_[starts_[b + 1] - 1].
  std::vector<std::int32_t> starts_;
  std::vector<std::int32_t> members_;
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_SIMULATION_SHAPE_INDEX_H_
