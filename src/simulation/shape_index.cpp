#include "vfh_astar/simulation/shape_index.h"

#include <algorithm>
#include <array>
#include <utility>

namespace vfh_astar {
namespace {

/// Waiting at once: parts are divided into halves of about the same number of
/// shapes, so that no world that fits into memory is deeper than 12 nodes.
constexpr std::size_t kMostWaiting = 12 * kFanLanes;

/// Where to divide a part: in the middle, but so that leaves are full.
std::size_t MiddleOf(std::size_t first, std::size_t last) {
  const std::size_t leaves = (last - first + kFanLanes - 1) / kFanLanes;
  return first + leaves / 2 * kFanLanes;
}

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
  for (std::size_t i = 0; i < shapes_.size(); ++i) {
    targets_.push_back({BoxOf(shapes_[i]), static_cast<std::int32_t>(i)});
  }
  root_ = Divide(0, targets_.size());
}

ShapeIndex::Box ShapeIndex::BoxAround(std::size_t first,
                                      std::size_t last) const {
  Box box = targets_[first].box;
  for (std::size_t i = first; i < last; ++i) box.Include(targets_[i].box);
  return box;
}

void ShapeIndex::Halve(std::size_t first, std::size_t middle,
                       std::size_t last) {
  const Box box = BoxAround(first, last);
  const Eigen::Vector2d size = box.max - box.min;
  const int axis = size.x() >= size.y() ? 0 : 1;
  const auto is_before = [axis](const Target& a, const Target& b) {
    const double at_a = a.box.min[axis] + a.box.max[axis];
    const double at_b = b.box.min[axis] + b.box.max[axis];
    return at_a != at_b ? at_a < at_b : a.shape < b.shape;
  };
  std::nth_element(targets_.begin() + first, targets_.begin() + middle,
                   targets_.begin() + last, is_before);
}

std::int32_t ShapeIndex::Divide(std::size_t first, std::size_t last) {
  if (last - first <= kFanLanes) return AddLeaf(first, last);
  // The largest part is halved until there are enough.
  std::vector<std::size_t> ends = {first, last};
  while (ends.size() <= kFanLanes) {
    std::size_t largest = 1;
    for (std::size_t i = 1; i < ends.size(); ++i) {
      if (ends[i] - ends[i - 1] > ends[largest] - ends[largest - 1]) {
        largest = i;
      }
    }
    const std::size_t begin = ends[largest - 1], end = ends[largest];
    if (end - begin <= kFanLanes) break;
    const std::size_t middle = MiddleOf(begin, end);
    Halve(begin, middle, end);
    ends.insert(ends.begin() + largest, middle);
  }
  const std::size_t node = nodes_.size();
  nodes_.emplace_back();
  nodes_[node].count = static_cast<std::int32_t>(ends.size()) - 1;
  for (int i = 0; i < kFanLanes; ++i) {
    // What fills lanes is of no account; that of a part is as good as any.
    const std::size_t part = std::min<std::size_t>(i, ends.size() - 2);
    const Box box = BoxAround(ends[part], ends[part + 1]);
    nodes_[node].boxes.min_x[i] = box.min.x();
    nodes_[node].boxes.min_y[i] = box.min.y();
    nodes_[node].boxes.max_x[i] = box.max.x();
    nodes_[node].boxes.max_y[i] = box.max.y();
  }
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    const std::int32_t child = Divide(ends[i], ends[i + 1]);
    nodes_[node].children[i] = child;
  }
  return static_cast<std::int32_t>(node);
}

std::int32_t ShapeIndex::AddLeaf(std::size_t first, std::size_t last) {
  Leaf leaf;
  leaf.first_target = static_cast<std::int32_t>(first);
  leaf.target_count = static_cast<std::int32_t>(last - first);
  leaf.first_polygon = static_cast<std::int32_t>(polygons_.size());
  leaf.discs.x.fill(0.0);
  leaf.discs.y.fill(0.0);
  leaf.discs.radius.fill(0.0);
  for (std::size_t i = first; i < last; ++i) {
    const Shape& shape = shapes_[targets_[i].shape];
    if (shape.IsDisc()) {
      leaf.discs.x[leaf.disc_count] = shape.center.x();
      leaf.discs.y[leaf.disc_count] = shape.center.y();
      leaf.discs.radius[leaf.disc_count++] = shape.radius;
      continue;
    }
    polygons_.push_back({static_cast<std::int32_t>(vertices_.size()),
                         static_cast<std::int32_t>(shape.vertices.size())});
    vertices_.insert(vertices_.end(), shape.vertices.begin(),
                     shape.vertices.end());
    ++leaf.polygon_count;
  }
  leaves_.push_back(leaf);
  return -static_cast<std::int32_t>(leaves_.size());
}

void ShapeIndex::LookAtLeaf(const Leaf& leaf, BeamFan* fan) const {
  if (leaf.disc_count > 0) fan->LookAtDiscs(leaf.discs, leaf.disc_count);
  for (std::int32_t i = 0; i < leaf.polygon_count; ++i) {
    const Polygon& polygon = polygons_[leaf.first_polygon + i];
    fan->LookAtPolygon(&vertices_[polygon.first_vertex], polygon.vertex_count);
  }
}

void ShapeIndex::CastRays(BeamFan* fan) const {
  if (shapes_.empty()) return;
  struct Part {
    std::int32_t index;
    View view;
  };
  std::array<Part, kMostWaiting> waiting;
  std::size_t count = 0;
  waiting[count++] = {root_, {0.0, 2.0 * kPi, 0.0, 0.0}};
  while (count > 0) {
    const Part part = waiting[--count];
    if (!fan->MaySee(part.view)) continue;
    if (part.index < 0) {
      LookAtLeaf(leaves_[-1 - part.index], fan);
      continue;
    }
    const Node& node = nodes_[part.index];
    const ViewLanes views = fan->ViewOf(node.boxes);
    const std::array<int, kFanLanes> places =
        PlacesFromFar(views.distance_squared);
    std::array<int, kFanLanes> from_far;
    for (int i = 0; i < kFanLanes; ++i) from_far[places[i]] = i;
    for (const int i : from_far) {
      if (i >= node.count) continue;
      const View view = views.At(i, 0.0);
      if (!fan->MaySee(view)) continue;
      waiting[count++] = {node.children[i], view};
    }
  }
}

std::vector<int> ShapeIndex::Near(const Eigen::Vector2d& point,
                                  double radius) const {
  std::vector<int> near;
  if (shapes_.empty()) return near;
  std::array<std::int32_t, kMostWaiting> waiting;
  std::size_t count = 0;
  waiting[count++] = root_;
  while (count > 0) {
    const std::int32_t part = waiting[--count];
    if (part >= 0) {
      const Node& node = nodes_[part];
      for (std::int32_t i = 0; i < node.count; ++i) {
        const Box box{{node.boxes.min_x[i], node.boxes.min_y[i]},
                      {node.boxes.max_x[i], node.boxes.max_y[i]}};
        if (box.DistanceSquared(point) > radius * radius) continue;
        waiting[count++] = node.children[i];
      }
      continue;
    }
    const Leaf& leaf = leaves_[-1 - part];
    for (std::int32_t i = 0; i < leaf.target_count; ++i) {
      const Target& target = targets_[leaf.first_target + i];
      if (target.box.DistanceSquared(point) > radius * radius) continue;
      near.push_back(target.shape);
    }
  }
  std::sort(near.begin(), near.end());
  return near;
}

}  // namespace vfh_astar
