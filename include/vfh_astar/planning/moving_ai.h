#ifndef VFH_ASTAR_PLANNING_MOVING_AI_H_
#define VFH_ASTAR_PLANNING_MOVING_AI_H_

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "vfh_astar/grid/grid.h"

namespace vfh_astar {

/// A map or scenario file of the MovingAI benchmark that cannot be read; the
/// message names the file, the line and what was expected.
class MovingAiError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// One query of a scenario file (Sturtevant, "Benchmarks for Grid-Based
/// Pathfinding", 2012).
struct MovingAiQuery {
  Cell start;           ///< column, row from the top.
  Cell goal;            ///< column, row from the top.
  double length = 0.0;  ///< cells, optimal: eight directions, no corner cut.
};

/// Reads a .map file.
/// @return 1 in blocked cells (all but '.' and 'G'), 0 in free ones, 1 m per
/// cell; the
///   file's first row is row 0, so that queries need no turning.
/// @throws MovingAiError
Grid<std::uint8_t> ReadMovingAiMap(const std::string& file);

/// Reads a .scen file.
/// @throws MovingAiError also for a query outside of the map's geometry.
std::vector<MovingAiQuery> ReadMovingAiScenario(const std::string& file,
                                                const GridGeometry& geometry);

}  // namespace vfh_astar

#endif  // VFH_ASTAR_PLANNING_MOVING_AI_H_
