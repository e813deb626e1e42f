#ifndef VFH_ASTAR_MAPPING_SCAN_INSERTER_H_
#define VFH_ASTAR_MAPPING_SCAN_INSERTER_H_

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <opencv2/core/types.hpp>
#include <vector>

#include "vfh_astar/geometry.h"
#include "vfh_astar/laser_scan.h"
#include "vfh_astar/mapping/cell_marks.h"
#include "vfh_astar/mapping/log_odds_grid.h"
#include "vfh_astar/parameters.h"

namespace vfh_astar {

/// The limits are low enough for a fifth scan to clear what moved away, and for
/// a second one to show what has come.
struct ScanInserterParameters {
  double max_urange = 20.0;  ///< m; beams count no farther than this, and clear
                             ///< so far where they see nothing.
  double max_range = 100.0;  ///< m; a longer hit is no measurement.
  double hit_probability = 0.8;   ///< of a cell in which one beam ends.
  double miss_probability = 0.4;  ///< of a cell that one beam passes through.
  double min_probability = 0.12;  ///< where free cells are held.
  double max_probability = 0.88;  ///< where occupied cells are held.

  void Read(ParameterReader& reader);
};

/// True when the gap between the hits `from` and `to` of two neighbouring beams
/// goes straight on from the gap before it or into the one after it: then they
/// lie on one surface. An edge in front of a wall makes no such line.
/// @param[in] before, after the next hits to both sides; null where the beam
///   next to them hit nothing.
bool IsOneSurface(const Eigen::Vector2d* before, const Eigen::Vector2d& from,
                  const Eigen::Vector2d& to, const Eigen::Vector2d* after);

/// Enters laser scans at known poses into a log-odds grid.
///
/// A scan changes a cell once, however many beams meet in it: as a hit when a
/// beam ends in it, else as a miss when one passes through it. Every hit within
/// max_urange is entered; hits up to max_range and beams that saw nothing
/// (+inf) clear the way to max_urange; all else (NaN, -inf, too near, beyond
/// max_range) does nothing.
///
/// The cells between two neighbouring hits on one surface (see IsOneSurface)
/// are not missed: seen at a flat angle from afar, the hits on a wall lie cells
/// apart, and the beams that graze it would wear it away in between.
class ScanInserter {
 public:
  explicit ScanInserter(const ScanInserterParameters& parameters);

  /// @param[in] scan without defect (see DescribeDefect).
  /// @param[in] laser_pose the laser in the grid's frame, finite.
  /// @param[in,out] grid grows to hold the scan; a scan that reaches beyond the
  ///   largest grid there can be is left out.
  /// @return the window, in the grid as it is afterwards, outside of which no
  ///   cell changed; empty when none did.
  cv::Rect Insert(const LaserScan& scan, const Pose2D& laser_pose,
                  LogOddsGrid& grid);

 private:
  struct Beam {
    Eigen::Vector2d end;  ///< m at first, then cells from the first tile.
    double length;        ///< m; 0 when the beam says nothing.
    bool is_hit;
  };

  void FindDirections(const LaserScan& scan);
  /// @return false when no beam says anything.
  bool TraceBeams(const LaserScan& scan, const Pose2D& laser_pose);
  /// m of a beam, from the laser on, in which every cell that it passes through
  /// is passed through by one of two other beams too.
  double SharedLength(std::size_t beam, double increment,
                      double resolution) const;
  void MarkBeams(const Eigen::Vector2d& laser, double increment,
                 const LogOddsGrid& grid);
  /// Marks what lies between neighbouring hits on one surface.
  void SpareSurfaces(double resolution);
  cv::Rect ApplyTile(int column, int row, LogOddsGrid& grid) const;
  bool UpdateRow(
      std::uint64_t misses, std::uint64_t hits, LogOdds* cells,
      std::array<std::uint8_t, LogOddsGrid::kTileSize>& changed_columns) const;

  ScanInserterParameters parameters_;
  LogOdds hit_steps_;
  LogOdds miss_steps_;
  LogOdds lowest_;
  LogOdds highest_;
  /// A block of cells as low as misses can get them.
  std::array<LogOdds, CellMarks::kBlockWidth * CellMarks::kBlockHeight>
      cleared_;

  // The directions of a scan's beams in the laser's frame, and what they were
  // made from: it seldom changes.
  std::vector<Eigen::Vector2d> directions_;
  double angle_min_ = 0.0;
  double angle_increment_ = 0.0;

  // One scan's working memory, kept to be allocated once.
  std::vector<Beam> beams_;
  cv::Rect tiles_;  ///< the tiles that the scan touches.
  CellMarks passed_;
  CellMarks ended_;
  CellMarks spared_;
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_MAPPING_SCAN_INSERTER_H_
