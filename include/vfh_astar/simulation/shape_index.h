#ifndef VFH_ASTAR_SIMULATION_SHAPE_INDEX_H_
#define VFH_ASTAR_SIMULATION_SHAPE_INDEX_H_

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "vfh_astar/simulation/beam_fan.h"
#include "vfh_astar/simulation/fan_lanes.h"
#include "vfh_astar/simulation/shape.h"

namespace vfh_astar {

/// Shapes that stand still, sorted into boxes within boxes, so that what is out
/// of reach or hidden costs nothing: neither a laser nor a robot looks at it.
class ShapeIndex {
 public:
  ShapeIndex() = default;
  explicit ShapeIndex(std::vector<Shape> shapes);

  const std::vector<Shape>& shapes() const { return shapes_; }

  /// Shows the fan all shapes that it may see, the near ones first.
  void CastRays(BeamFan* fan) const;

  /// The indices of the shapes that may come within `radius` of a point, each
  /// once, rising.
  std::vector<int> Near(const Eigen::Vector2d& point, double radius) const;

 private:
  /// A box along the axes.
  struct Box {
    Eigen::Vector2d min;
    Eigen::Vector2d max;

    void Include(const Box& other);
    double DistanceSquared(const Eigen::Vector2d& point) const;
  };
  /// Up to kFanLanes parts beside each other, and a box around each.
  struct Node {
    BoxLanes boxes;
    /// The index of a node, or -1 less that of a leaf.
    std::array<std::int32_t, kFanLanes> children;
    std::int32_t count;
  };
  /// Up to kFanLanes shapes that lie near to each other.
  struct Leaf {
    DiscLanes discs;
    std::int32_t disc_count = 0;
    std::int32_t first_polygon = 0;
    std::int32_t polygon_count = 0;
    std::int32_t first_target = 0;  ///< of the shapes in targets_.
    std::int32_t target_count = 0;
  };
  /// A polygon's vertices, beside those of polygons near to it.
  struct Polygon {
    std::int32_t first_vertex;
    std::int32_t vertex_count;
  };
  /// A shape and a box around it; rays do not ask for them.
  struct Target {
    Box box;
    std::int32_t shape;  ///< its index.
  };

  static Box BoxOf(const Shape& shape);
  /// Around targets_[first] to targets_[last - 1].
  Box BoxAround(std::size_t first, std::size_t last) const;
  /// Sorts these targets so that those from the middle on lie beyond the rest.
  void Halve(std::size_t first, std::size_t middle, std::size_t last);
  /// Sorts targets_[first] to targets_[last - 1], which are kFanLanes or fewer,
  /// or more, into a leaf or a node with all below it.
  /// @return the index as Node has it.
  std::int32_t Divide(std::size_t first, std::size_t last);
  std::int32_t AddLeaf(std::size_t first, std::size_t last);
  void LookAtLeaf(const Leaf& leaf, BeamFan* fan) const;

  std::vector<Shape> shapes_;
  std::vector<Node> nodes_;
  std::vector<Leaf> leaves_;
  std::int32_t root_ = 0;  ///< as Node has it; nothing without shapes.
  std::vector<Target> targets_;
  std::vector<Polygon> polygons_;
  std::vector<Eigen::Vector2d> vertices_;
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_SIMULATION_SHAPE_INDEX_H_
