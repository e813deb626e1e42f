#ifndef VFH_ASTAR_GRID_MAP_FILE_H_
#define VFH_ASTAR_GRID_MAP_FILE_H_

#include <optional>
#include <stdexcept>
#include <string>

#include "vfh_astar/grid/grid.h"

namespace vfh_astar {

/// A map file that cannot be read or written; the message names the file, the
/// field or byte, the value found and what was expected.
class MapFileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct MapLoadOptions {
  /// When set, every pixel darker than this grey value (0 to 255, after
  /// `negate`) is occupied and every other one is free, whatever the
  /// thresholds in the yaml say. For maps with anti-aliased walls.
  std::optional<int> solid_below;
};

/// Reads a map as map_server writes and reads it: a yaml (image, resolution,
/// origin, negate, occupied_thresh, free_thresh, optional mode: trinary, scale
/// or raw) and its image beside it.
/// @return cell (0, 0) is the image's lower left pixel. Values as map_server
///   publishes them.
/// @throws MapFileError for a missing, truncated or malformed yaml or image,
///   and for an origin with a yaw other than 0.
OccupancyGrid LoadMap(const std::string& yaml_file,
                      const MapLoadOptions& options = {});

/// Writes `stem`.yaml and `stem`.pgm as map_server's map_saver does (free 254,
/// unknown 205, occupied 0). Both appear whole or not at all: they are written
/// beside their names and renamed. What is written loads again bit for bit.
/// @throws MapFileError naming the file that could not be written.
void SaveMap(const OccupancyGrid& map, const std::string& stem);

}  // namespace vfh_astar

#endif  // VFH_ASTAR_GRID_MAP_FILE_H_
