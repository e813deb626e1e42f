#ifndef VFH_ASTAR_SIMULATION_BEAM_FAN_H_
#define VFH_ASTAR_SIMULATION_BEAM_FAN_H_

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "vfh_astar/geometry.h"
#include "vfh_astar/simulation/fan_lanes.h"
#include "vfh_astar/simulation/shape.h"

namespace vfh_astar {

/// Beams from one place at equal angles, and how far each of them gets. Instead
/// of following every beam, one shows it shape after shape: a shape ends those
/// beams that meet it, which lie side by side. The order does not matter; from
/// near to far is fastest, as MaySee then tells what is hidden.
class BeamFan {
 public:
  /// @param[in] count 1 or more.
  /// @param[in] first_angle rad, of the first beam in the frame of the laser.
  /// @param[in] increment rad from beam to beam, above 0. The fan may go around
  ///   more than once.
  BeamFan(int count, double first_angle, double increment);

  /// Looks from somewhere, with no beam met by anything.
  /// @param[in] pose of the laser in the frame that shapes are given in.
  /// @param[in] range m; what is farther may be overlooked.
  void Aim(const Pose2D& pose, double range);

  void LookAt(const Shape& shape);
  /// @param[in] radius m, above 0.
  void LookAtDisc(const Eigen::Vector2d& center, double radius);
  /// @param[in] count of the lanes that are filled with discs.
  void LookAtDiscs(const DiscLanes& discs, int count);
  /// @param[in] vertices `count` of them, convex, counter-clockwise.
  void LookAtPolygon(const Eigen::Vector2d* vertices, std::size_t count);

  /// What of the view boxes may fill.
  ViewLanes ViewOf(const BoxLanes& boxes) const {
    return ViewBoxes(frame_, boxes);
  }

  /// False when nothing in that part of the view, at that distance or farther,
  /// would change a range.
  bool MaySee(const View& view) const;

  /// m by beam: to the nearest shape shown, 0 when the origin lies in one,
  /// infinity for none. What is beyond the range counts or does not.
  const std::vector<double>& ranges() const { return ranges_; }

 private:
  /// Beams from the first to the last; none when the last comes first.
  struct Span {
    int first, last;
  };

  /// From the frame of shapes into one about the origin whose x axis is the
  /// first beam.
  Eigen::Vector2d ToFan(const Eigen::Vector2d& point) const;
  Span BeamsBetween(double low, double high) const;
  /// True when nothing at a distance less a radius would change a range.
  bool IsHidden(const Span& span, double distance_squared, double radius) const;
  void LookAtEdge(const Eigen::Vector2d& from, const Eigen::Vector2d& to);
  void DrawDisc(const Eigen::Vector2d& center, double radius, const Span& span);
  void DrawEdge(const Eigen::Vector2d& from, const Eigen::Vector2d& to,
                double nearest, Span span);
  void CoverAll();

  /// Notes how far a block of beams reaches when they end at `farthest`.
  void NoteReach(int block, double farthest);

  /// Calls draw(span) for each run of beams between two angles (rad from the
  /// first beam, `low` above -2 pi) that are off by kBearingError at most.
  template <typename Draw>
  void ForEachTurn(double low, double high, const Draw& draw) const;

  double first_angle_;
  double beams_per_rad_;
  double full_angle_;          ///< rad from the first beam to the last.
  std::vector<double> x_, y_;  ///< of the beams' unit vectors; whole blocks.
  FanFrame frame_;
  double range_ = 0.0;
  std::vector<double> ranges_;
  /// By block of beams: m beyond which none of them would meet anything.
  std::vector<double> reach_;
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_SIMULATION_BEAM_FAN_H_
