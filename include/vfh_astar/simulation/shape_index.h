#ifndef VFH_ASTAR_SIMULATION_SHAPE_INDEX_H_
#define VFH_ASTAR_SIMULATION_SHAPE_INDEX_H_

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "vfh_astar/simulation/beam_fan.h"
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
  /// A box around other nodes or around shapes.
  struct Node {
    Box box;
    /// Of its targets, or of its two children.
    std::int32_t first = 0;
    std::int32_t target_count = 0;  ///< 0: has children.
  };
  /// A shape as rays see it, beside those that are near to it.
  struct Target {
    Eigen::Vector2d center;
    double radius;              ///< of a disc,
    std::int32_t first_vertex;  ///< or of a polygon,
    std::int32_t vertex_count;  ///< else 0.
    std::int32_t shape;         ///< its index.
  };

  static Box BoxOf(const Shape& shape);
  /// Sorts order[first] to order[last - 1] into the node and its children.
  void Divide(std::size_t node, std::vector<std::int32_t>* order,
              std::size_t first, std::size_t last,
              const std::vector<Box>& boxes);
  void AddTarget(std::int32_t shape);

  std::vector<Shape> shapes_;
  std::vector<Node> nodes_;  ///< the root first; none without shapes.
  std::vector<Target> targets_;
  std::vector<Box> boxes_;  ///< around each target; rays do not ask for them.
  std::vector<Eigen::Vector2d> vertices_;
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_SIMULATION_SHAPE_INDEX_H_
