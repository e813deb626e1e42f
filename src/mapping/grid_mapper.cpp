#include "vfh_astar/mapping/grid_mapper.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace vfh_astar {
namespace {

GridGeometry Extent(const GridMapperParameters& parameters) {
  GridGeometry geometry;
  geometry.resolution = parameters.delta;
  geometry.origin = Eigen::Vector2d(parameters.xmin, parameters.ymin);
  const auto cells = [&parameters](double length) {
    return std::clamp(static_cast<int>(std::ceil(length / parameters.delta)), 1,
                      LogOddsGrid::kMaxSide);
  };
  geometry.width = cells(parameters.xmax - parameters.xmin);
  geometry.height = cells(parameters.ymax - parameters.ymin);
  return geometry;
}

/// Calls visit(values, count) row by row for each run of columns that lies
/// within one tile; `values` is null where nothing is explored.
template <typename Visitor>
void VisitRuns(const LogOddsGrid& grid, const cv::Rect& window,
               Visitor&& visit) {
  constexpr int kTile = LogOddsGrid::kTileSize;
  for (int y = window.y; y < window.br().y; ++y) {
    for (int x = window.x; x < window.br().x;) {
      const int end = std::min((x / kTile + 1) * kTile, window.br().x);
      const LogOddsGrid::Tile* tile = grid.FindTile(x / kTile, y / kTile);
      visit(tile ? tile->data() + LogOddsGrid::Offset({x, y}) : nullptr,
            end - x);
      x = end;
    }
  }
}

}  // namespace

void GridMapperParameters::Read(ParameterReader& reader) {
  reader.Number("delta", delta, 0.005, 1.0);
  reader.Number("xmin", xmin, -10000.0, 10000.0);
  reader.Number("ymin", ymin, -10000.0, 10000.0);
  // An extent the wrong way round is refused with the name of its upper end.
  reader.Number("xmax", xmax, xmin + delta, 10000.0);
  reader.Number("ymax", ymax, ymin + delta, 10000.0);
  reader.Number("linear_update", linear_update, 0.0, 100.0);
  reader.Number("angular_update", angular_update, 0.0, 10.0);
  reader.Number("temporal_update", temporal_update, 0.0, 3600.0);
  insertion.Read(reader);
}

GridMapper::GridMapper(const GridMapperParameters& parameters)
    : parameters_(parameters),
      grid_(Extent(parameters)),
      inserter_(parameters.insertion) {}

void GridMapper::SetMap(const OccupancyGrid& map) {
  grid_ = LogOddsGrid(map.geometry());
  for (int y = 0; y < map.geometry().height; ++y) {
    for (int x = 0; x < map.geometry().width; ++x) {
      const std::int8_t value = map[{x, y}];
      if (value != kUnknown) grid_.Set({x, y}, FromOccupancy(value));
    }
  }
  last_stamp_.reset();
}

bool GridMapper::IsDue(double stamp, const Pose2D& laser_pose) const {
  // Time that runs backwards is a new beginning: a simulation was reset or a
  // recording started over.
  if (!last_stamp_ || stamp < *last_stamp_) return true;
  if (stamp - *last_stamp_ >= parameters_.temporal_update) return true;
  const double driven = (laser_pose.position() - last_pose_.position()).norm();
  const double turned =
      std::abs(NormalizeAngle(laser_pose.theta - last_pose_.theta));
  return driven >= parameters_.linear_update ||
         turned >= parameters_.angular_update;
}

MapChange GridMapper::AddScan(const LaserScan& scan, const Pose2D& laser_pose) {
  assert(!DescribeDefect(scan));
  MapChange change;
  if (!IsDue(scan.stamp, laser_pose)) return change;
  last_stamp_ = scan.stamp;
  last_pose_ = laser_pose;
  const GridGeometry before = grid_.geometry();
  change.inserted = true;
  change.window = inserter_.Insert(WithoutLostBeams(scan), laser_pose, grid_);
  change.resized = grid_.geometry() != before;
  return change;
}

OccupancyGrid GridMapper::Map() const {
  OccupancyGrid map(geometry(), kUnknown);
  map.cells() = Values(geometry().Bounds());
  return map;
}

std::vector<std::int8_t> GridMapper::Values(const cv::Rect& window) const {
  assert((window & geometry().Bounds()) == window);
  static const std::array<std::int8_t, 256> kOccupancy = [] {
    std::array<std::int8_t, 256> table;
    for (int value = 0; value < 256; ++value) {
      table[value] = ToOccupancy(static_cast<LogOdds>(value));
    }
    return table;
  }();
  std::vector<std::int8_t> values;
  values.reserve(window.area());
  VisitRuns(grid_, window, [&](const LogOdds* run, int count) {
    if (!run) {
      values.insert(values.end(), count, kUnknown);
      return;
    }
    for (int i = 0; i < count; ++i) values.push_back(kOccupancy[run[i]]);
  });
  return values;
}

double GridMapper::Entropy() const {
  std::array<std::int64_t, 256> counts{};
  VisitRuns(grid_, geometry().Bounds(), [&](const LogOdds* run, int count) {
    for (int i = 0; run && i < count; ++i) ++counts[run[i]];
  });
  std::int64_t explored = 0;
  double sum = 0.0;
  for (int value = 1; value < 256; ++value) {
    const double p = ToProbability(static_cast<LogOdds>(value));
    explored += counts[value];
    sum -= counts[value] * (p * std::log(p) + (1.0 - p) * std::log(1.0 - p));
  }
  return explored == 0 ? 0.0 : sum / explored;
}

}  // namespace vfh_astar
