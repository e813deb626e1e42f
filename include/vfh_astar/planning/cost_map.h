#ifndef VFH_ASTAR_PLANNING_COST_MAP_H_
#define VFH_ASTAR_PLANNING_COST_MAP_H_

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <opencv2/core/types.hpp>
#include <vector>

#include "vfh_astar/grid/clearance.h"
#include "vfh_astar/grid/grid.h"

namespace vfh_astar {

/// The eight ways from a cell to its neighbours, counter-clockwise from x;
/// odd ones are diagonal.
inline constexpr int kDirections = 8;
inline constexpr std::array<Cell, kDirections> kSteps = {
    {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};

/// The cost between two cells when all are free (octile distance).
/// @param[in] straight, diagonal costs of steps.
inline std::uint32_t OctileDistance(const Cell& from, const Cell& to,
                                    std::uint32_t straight,
                                    std::uint32_t diagonal) {
  const std::uint32_t dx = std::abs(to.x - from.x);
  const std::uint32_t dy = std::abs(to.y - from.y);
  return straight * std::max(dx, dy) + (diagonal - straight) * std::min(dx, dy);
}

/// From one direction to the others, the nearest ones first.
inline constexpr std::array<int, kDirections> kTurns = {
    {0, 1, 7, 2, 6, 3, 5, 4}};

enum class UnknownSpace { kForbidden, kFree, kPriced };

/// What a metre of path costs, by clearance.
///
/// Cells with less clearance than `lethal_clearance` are forbidden. From there
/// to `inflation_clearance` the factor falls as
///   1 + (weight - 1) ((inflation_clearance - d) / (inflation_clearance -
///   lethal_clearance))^2,
/// and beyond it is 1, so the heuristic of straight and diagonal steps through
/// free cells never overestimates. Between two walls the factor is least in the
/// middle.
struct CostModel {
  double lethal_clearance = 0.26;    ///< m between cell centres.
  double inflation_clearance = 0.8;  ///< m between cell centres.
  double weight = 3.0;               ///< 1 is uniform cost; 10 at most.
  UnknownSpace unknown = UnknownSpace::kFree;
  double unknown_price = 1.0;  ///< added to the factor when priced; 5 at most.
};

/// The cost factor of every cell in whole sixteenths, with a border of lethal
/// cells around the map, so that a search needs no test for the map's edge. The
/// border is one cell wide at the lower edges and at the upper ones as wide as
/// makes the whole divide into blocks.
class CostMap {
 public:
  using Level = std::uint8_t;
  static constexpr int kBlockSide = 8;  ///< cells.
  static constexpr Level kLethal = 0;
  static constexpr Level kUnit = 16;  ///< the factor 1.
  static constexpr Level kMaxLevel = 255;

  explicit CostMap(const CostModel& model);

  /// Takes the costs of a whole new map.
  void SetMap(const ClearanceMap& clearance);

  /// Takes the costs of a window that has changed.
  void Update(const ClearanceMap& clearance, const cv::Rect& window);

  const CostModel& model() const { return model_; }
  const GridGeometry& geometry() const { return geometry_; }

  /// The level of a cell that is known, by its clearance in m.
  Level LevelOf(double clearance) const;

  Level operator[](const Cell& cell) const { return levels_[Index(cell)]; }

  /// Gives one cell another level, until the next update of it.
  void Set(const Cell& cell, Level level) { levels_[Index(cell)] = level; }

  bool IsLethal(const Cell& cell) const { return (*this)[cell] == kLethal; }

  /// True when the step from a cell within the map leads to a free cell and
  /// cuts no corner.
  bool IsOpen(const Cell& cell, int direction) const;

  /// Levels row by row with the border; see Index.
  const std::vector<Level>& levels() const { return levels_; }
  /// Cells in a row of levels, and rows; multiples of kBlockSide.
  int rows() const { return Padded(geometry_.height); }
  int stride() const { return Padded(geometry_.width); }

  /// @param[in] cell within the map or on its border (-1 to width or height).
  std::size_t Index(const Cell& cell) const {
    return static_cast<std::size_t>(cell.y + 1) * stride() + cell.x + 1;
  }

 private:
  static constexpr int Padded(int side) {
    return (side + 2 + kBlockSide - 1) / kBlockSide * kBlockSide;
  }

  CostModel model_;
  GridGeometry geometry_;
  std::vector<Level> levels_;
};

/// Costs of steps in whole numbers, so that equal paths cost the same whatever
/// the order they are added up in. A straight step between two free cells costs
/// kFreeStep; 99 / 70 is the root of 2 to 5e-5.
using StepCost = std::uint32_t;
inline constexpr StepCost kStraight = 70;
inline constexpr StepCost kDiagonal = 99;
inline constexpr StepCost kFreeStep = 2 * CostMap::kUnit * kStraight;
inline constexpr StepCost kFreeDiagonal = 2 * CostMap::kUnit * kDiagonal;

/// A step costs its length times the mean of its cells' factors.
inline StepCost CostOfStep(CostMap::Level from, CostMap::Level to,
                           int direction) {
  return (StepCost{from} + to) * (direction % 2 == 0 ? kStraight : kDiagonal);
}

/// The cost between two cells when all are free: the heuristic of the searches.
inline StepCost FreeCost(const Cell& from, const Cell& to) {
  return OctileDistance(from, to, kFreeStep, kFreeDiagonal);
}

}  // namespace vfh_astar

#endif  // VFH_ASTAR_PLANNING_COST_MAP_H_
