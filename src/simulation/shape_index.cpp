#include "vfh_astar/simulation/shape_index.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

namespace vfh_astar {
namespace {

constexpr std::size_t kMostTargets = 8;  ///< in a box that is not divided.

/// Boxes are divided into halves of the same number of shapes, so that no
/// world that fits into memory is deeper.
constexpr std::size_t kMostDeep = 64;

}  // namespace

void ShapeIndex::Box::Include(const Box& other) {
  min = min.cwiseMin(other.min);
  max = max.cwiseMax(other.max);
}

double ShapeIndex::Box::DistanceSquared(const Eigen::Vector2d& point) const {
  return (min - point)
      .cwiseMax(point - max)
      .cwiseMax(Eigen::Vector2d::Zero())
      .squaredNorm();
}

ShapeIndex::Box ShapeIndex::BoxOf(const Shape& shape) {
  if (shape.IsDisc()) {
    const Eigen::Vector2d radius(shape.radius, shape.radius);
    return {shape.center - radius, shape.center + radius};
  }
  Box box{shape.vertices.front(), shape.vertices.front()};
  for (const Eigen::Vector2d& vertex : shape.vertices) {
    box.Include({vertex, vertex});
  }
  return box;
}

ShapeIndex::ShapeIndex(std::vector<Shape> shapes) : shapes_(std::move(shapes)) {
  if (shapes_.empty()) return;
  std::vector<Box> boxes;
  for (const Shape& shape : shapes_) boxes.push_back(BoxOf(shape));
  std::vector<std::int32_t> order(shapes_.size());
  std::iota(order.begin(), order.end(), 0);
  nodes_.resize(1);
  Divide(0, &order, 0, order.size(), boxes);
  for (const std::int32_t shape : order) {
    AddTarget(shape);
    boxes_.push_back(boxes[shape]);
  }
}

void ShapeIndex::Divide(std::size_t node, std::vector<std::int32_t>* order,
                        std::size_t first, std::size_t last,
                        const std::vector<Box>& boxes) {
  Box box = boxes[(*order)[first]];
  for (std::size_t i = first; i < last; ++i) box.Include(boxes[(*order)[i]]);
  nodes_[node].box = box;
  if (last - first <= kMostTargets) {
    nodes_[node].first = static_cast<std::int32_t>(first);
    nodes_[node].target_count = static_cast<std::int32_t>(last - first);
    return;
  }
  const Eigen::Vector2d size = box.max - box.min;
  const int axis = size.x() >= size.y() ? 0 : 1;
  const auto is_before = [&](std::int32_t a, std::int32_t b) {
    const double at_a = boxes[a].min[axis] + boxes[a].max[axis];
    const double at_b = boxes[b].min[axis] + boxes[b].max[axis];
    return at_a != at_b ? at_a < at_b : a < b;
  };
  const std::size_t middle = first + (last - first) / 2;
  std::nth_element(order->begin() + first, order->begin() + middle,
                   order->begin() + last, is_before);
  const std::size_t children = nodes_.size();
  nodes_[node].first = static_cast<std::int32_t>(children);
  nodes_.resize(children + 2);
  Divide(children, order, first, middle, boxes);
  Divide(children + 1, order, middle, last, boxes);
}

void ShapeIndex::AddTarget(std::int32_t shape) {
  const Shape& added = shapes_[shape];
  targets_.push_back({added.center, added.radius,
                      static_cast<std::int32_t>(vertices_.size()),
                      static_cast<std::int32_t>(added.vertices.size()), shape});
  vertices_.insert(vertices_.end(), added.vertices.begin(),
                   added.vertices.end());
}

void ShapeIndex::CastRays(BeamFan* fan) const {
  if (nodes_.empty()) return;
  std::array<std::int32_t, kMostDeep> waiting;
  std::size_t count = 0;
  waiting[count++] = 0;
  while (count > 0) {
    const Node& node = nodes_[waiting[--count]];
    if (!fan->MaySee(node.box.min, node.box.max)) continue;
    if (node.target_count == 0) {
      const bool second_is_nearer =
          nodes_[node.first + 1].box.DistanceSquared(fan->origin()) <
          nodes_[node.first].box.DistanceSquared(fan->origin());
      waiting[count++] = node.first + (second_is_nearer ? 0 : 1);
      waiting[count++] = node.first + (second_is_nearer ? 1 : 0);
      continue;
    }
    for (std::int32_t i = 0; i < node.target_count; ++i) {
      const Target& target = targets_[node.first + i];
      if (target.vertex_count == 0) {
        fan->LookAtDisc(target.center, target.radius);
      } else {
        fan->LookAtPolygon(&vertices_[target.first_vertex],
                           target.vertex_count);
      }
    }
  }
}

std::vector<int> ShapeIndex::Near(const Eigen::Vector2d& point,
                                  double radius) const {
  std::vector<int> near;
  if (nodes_.empty()) return near;
  std::array<std::int32_t, kMostDeep> waiting;
  std::size_t count = 0;
  waiting[count++] = 0;
  while (count > 0) {
    const Node& node = nodes_[waiting[--count]];
    if (node.box.DistanceSquared(point) > radius * radius) continue;
    if (node.target_count == 0) {
      waiting[count++] = node.first;
      waiting[count++] = node.first + 1;
      continue;
    }
    for (std::int32_t i = 0; i < node.target_count; ++i) {
      const std::int32_t target = node.first + i;
      if (boxes_[target].DistanceSquared(point) > radius * radius) continue;
      near.push_back(targets_[target].shape);
    }
  }
  std::sort(near.begin(), near.end());
  return near;
}

}  // namespace vfh_astar
