#ifndef VFH_ASTAR_MAPPING_HIT_FIELD_H_
#define VFH_ASTAR_MAPPING_HIT_FIELD_H_

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <memory>
#include <opencv2/core/types.hpp>
#include <vector>

#include "vfh_astar/geometry.h"

namespace vfh_astar {

/// How near to the walls seen so far a place is: a likelihood field that grows
/// hit by hit. Each hit raises the cells around it towards a Gaussian of its
/// exact distance from their centres, so that a wall lies in the field finer
/// than its cells, and one seen often stands out from what was seen once, yet
/// never wider than its hits lie.
///
/// Cells lie in square tiles that come into being where hits fall; copies share
/// their tiles until one of them writes, so that the particles of a filter
/// store what they have in common once.
class HitField {
 public:
  static constexpr int kTileSize = 32;  ///< cells per side.
  using Tile = std::array<std::uint8_t, kTileSize * kTileSize>;

  /// @param[in] resolution m per cell.
  /// @param[in] sigma m, of a hit's Gaussian.
  /// @param[in] gain within (0, 1]: the part of what is missing to its Gaussian
  ///   that a hit adds.
  HitField(double resolution, double sigma, double gain);

  double resolution() const { return resolution_; }

  /// Adds hits.
  /// @param[in] points m, in the frame of `pose`.
  void Add(const std::vector<Eigen::Vector2d>& points, const Pose2D& pose);

  /// The field at a place and how it rises there.
  struct Sample {
    double value = 0.0;                               ///< 0 to 1.
    Eigen::Vector2d slope = Eigen::Vector2d::Zero();  ///< per m.
  };

  /// Bilinear between the centres of cells; 0 where nothing was seen.
  Sample At(const Eigen::Vector2d& point) const;

  /// A copy of the values (0 to 255) of a rectangle of cells, row by row. Cell
  /// (0, 0) has its lower left corner at the origin of the field's frame.
  std::vector<std::uint8_t> Values(const cv::Rect& cells) const;

  /// True when the two share the tile that a cell lies in, or have none there.
  bool SharesTile(const HitField& other, int x, int y) const;

 private:
  const Tile* FindTile(int column, int row) const {
    const int x = column - tiles_.x;
    const int y = row - tiles_.y;
    if (x < 0 || y < 0 || x >= tiles_.width || y >= tiles_.height) {
      return nullptr;
    }
    return table_[static_cast<std::size_t>(y) * tiles_.width + x].get();
  }
  int Value(int x, int y) const;
  Tile& MutableTile(int column, int row);
  void GrowToHold(const cv::Rect& tiles);
  void AddHit(const Eigen::Vector2d& at);

  double resolution_;
  double gain_;
  double spread_;  ///< 1 / (2 sigma^2), per squared cell.
  int reach_;      ///< cells from a hit that it still touches.
  cv::Rect tiles_;
  std::vector<std::shared_ptr<Tile>> table_;
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_MAPPING_HIT_FIELD_H_
