#ifndef VFH_ASTAR_SIMULATION_BEAM_FAN_H_
#define VFH_ASTAR_SIMULATION_BEAM_FAN_H_

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "vfh_astar/geometry.h"
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
  /// @param[in] vertices `count` of them, convex, counter-clockwise.
  void LookAtPolygon(const Eigen::Vector2d* vertices, std::size_t count);

  /// False when nothing in a box along the axes would change a range.
  bool MaySee(const Eigen::Vector2d& min, const Eigen::Vector2d& max) const;

  const Eigen::Vector2d& origin() const { return origin_; }

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
  bool IsHidden(const Span& span, double distance_squared) const;
  void LookAtEdge(const Eigen::Vector2d& from, const Eigen::Vector2d& to);
  void DrawDisc(const Eigen::Vector2d& center, double radius, Span span);
  void DrawEdge(const Eigen::Vector2d& from, const Eigen::Vector2d& to,
                double nearest, Span span);
  void CoverAll();

  /// Calls draw(x, y, ranges) for each block that has beams of the span, with
  /// the arrays of all the beams in it, and notes how far they reach then.
  template <typename Draw>
  void ForEachBlock(const Span& span, const Draw& draw);

  /// Calls draw(span) for each run of beams between two angles (rad from the
  /// first beam, `low` above -2 pi).
  template <typename Draw>
  void ForEachTurn(double low, double high, const Draw& draw) const;

  double first_angle_;
  double beams_per_rad_;
  double full_angle_;          ///< rad from the first beam to the last.
  std::vector<double> x_, y_;  ///< of the beams' unit vectors.
  Eigen::Vector2d origin_ = Eigen::Vector2d::Zero();
  Eigen::Vector2d axis_ = Eigen::Vector2d::UnitX();  ///< the first beam.
  double range_squared_ = 0.0;
  std::vector<double> ranges_;
  /// By block of beams: m^2 beyond which none of them would meet anything.
  std::vector<double> reach_squared_;
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_SIMULATION_BEAM_FAN_H_
