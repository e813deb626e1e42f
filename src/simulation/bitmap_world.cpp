#include "vfh_astar/simulation/bitmap_world.h"

#include "vfh_astar/grid/map_file.h"

namespace vfh_astar {
namespace {

/// Cells that are solid and not yet part of a rectangle.
class OpenCells {
 public:
  explicit OpenCells(const OccupancyGrid& map) : open_(map) {}

  bool IsOpen(int x, int y) const {
    return open_.geometry().Contains(Cell{x, y}) && open_[Cell{x, y}] == 100;
  }

  /// The cells of the greedy rectangle whose lower left cell is (x, y), which
  /// is open; they are open no longer.
  cv::Rect Take(int x, int y) {
    cv::Rect rectangle(x, y, 1, 1);
    while (IsOpen(x + rectangle.width, y)) ++rectangle.width;
    while (IsRowOpen(rectangle, y + rectangle.height)) ++rectangle.height;
    for (int row = y; row < y + rectangle.height; ++row) {
      for (int column = x; column < x + rectangle.width; ++column) {
        open_[Cell{column, row}] = 0;
      }
    }
    return rectangle;
  }

 private:
  bool IsRowOpen(const cv::Rect& rectangle, int row) const {
    for (int i = 0; i < rectangle.width; ++i) {
      if (!IsOpen(rectangle.x + i, row)) return false;
    }
    return true;
  }

  OccupancyGrid open_;
};

Shape MakeRectangle(const GridGeometry& geometry, const cv::Rect& cells) {
  const auto corner = [&geometry](int x, int y) -> Eigen::Vector2d {
    return geometry.origin + geometry.resolution * Eigen::Vector2d(x, y);
  };
  const int right = cells.x + cells.width;
  const int top = cells.y + cells.height;
  return MakeConvexPolygon({corner(cells.x, cells.y), corner(right, cells.y),
                            corner(right, top), corner(cells.x, top)});
}

}  // namespace

std::vector<Shape> MergeSolidCells(const OccupancyGrid& map) {
  std::vector<Shape> rectangles;
  OpenCells cells(map);
  for (int y = 0; y < map.geometry().height; ++y) {
    for (int x = 0; x < map.geometry().width; ++x) {
      if (!cells.IsOpen(x, y)) continue;
      rectangles.push_back(MakeRectangle(map.geometry(), cells.Take(x, y)));
    }
  }
  return rectangles;
}

std::vector<Shape> LoadBitmapShapes(const std::string& map_yaml,
                                    int solid_below) {
  MapLoadOptions options;
  options.solid_below = solid_below;
  return MergeSolidCells(LoadMap(map_yaml, options));
}

World LoadBitmapWorld(const std::string& map_yaml, int solid_below) {
  World world;
  world.obstacles.push_back({"map", LoadBitmapShapes(map_yaml, solid_below)});
  return world;
}

}  // namespace vfh_astar
