#ifndef VFH_ASTAR_SIMULATION_SOLID_FIELDS_H_
#define VFH_ASTAR_SIMULATION_SOLID_FIELDS_H_

#include <string>
#include <vector>

#include "vfh_astar/simulation/shape.h"
#include "vfh_astar/simulation/world.h"
#include "vfh_astar/yaml_field.h"

namespace vfh_astar {

/// A kind of solid in a world file: `box` in a group `shape`, `boxes` as a list
/// of obstacles.
struct SolidKind {
  std::string name;
  std::string plural;
  std::vector<std::string> keys;  ///< of one such solid.
  /// The shapes of one such solid.
  /// @throws YamlFieldError, or MapFileError for a bitmap.
  std::vector<Shape> (*read)(const YamlField&, const WorldLoadOptions&);
};

/// Boxes, cylinders, polygons, walls and bitmaps.
const std::vector<SolidKind>& SolidKinds();

/// A group with one entry, such as `box: {pose: ..., size: ...}`.
/// @throws as SolidKind::read.
std::vector<Shape> ReadSolid(const YamlField& group,
                             const WorldLoadOptions& options);

}  // namespace vfh_astar

#endif  // VFH_ASTAR_SIMULATION_SOLID_FIELDS_H_
