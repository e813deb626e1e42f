#ifndef VFH_ASTAR_SIMULATION_BITMAP_WORLD_H_
#define VFH_ASTAR_SIMULATION_BITMAP_WORLD_H_

#include <string>
#include <vector>

#include "vfh_astar/grid/grid.h"
#include "vfh_astar/simulation/shape.h"
#include "vfh_astar/simulation/world.h"

namespace vfh_astar {

/// Covers the cells of 100 percent with rectangles that do not overlap. Each is
/// grown greedily, along x and then along y, so they are few but not the
/// fewest. Neighbours share their corners' coordinates bit for bit: no ray
/// passes between them.
std::vector<Shape> MergeSolidCells(const OccupancyGrid& map);

/// The solid pixels of a map_server map.
/// @param[in] solid_below grey value, see WorldLoadOptions.
/// @throws MapFileError
std::vector<Shape> LoadBitmapShapes(const std::string& map_yaml,
                                    int solid_below);

/// A map_server map as a world: its walls are one obstacle named `map`. Robots
/// and goal are not in such a file.
/// @throws MapFileError
World LoadBitmapWorld(const std::string& map_yaml, int solid_below);

}  // namespace vfh_astar

#endif  // VFH_ASTAR_SIMULATION_BITMAP_WORLD_H_
