#ifndef VFH_ASTAR_CONTROL_VFH_H_
#define VFH_ASTAR_CONTROL_VFH_H_

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "vfh_astar/geometry.h"
#include "vfh_astar/parameters.h"

namespace vfh_astar {

struct VfhParameters {
  double sector_angle = 0.0872664626;  ///< rad per sector; rounded so that a
                                       ///< whole number fills the circle.
  double window = 2.0;                 ///< m, farther points do not count.
  double robot_radius = 0.25;   ///< m by which obstacles are enlarged (VFH+);
                                ///< 0 is the paper's plain histogram.
  int smoothing = 2;            ///< sectors on each side in the moving average.
  double threshold_low = 0.4;   ///< a sector opens below this density,
  double threshold_high = 0.5;  ///< and closes above this one.
  double wide_valley = 0.785398;  ///< rad; in wider valleys the robot keeps
                                  ///< half of this from the border.
  double target_weight = 5.0;     ///< cost of turning away from the target,
  double heading_weight = 2.0;    ///< of turning away from straight ahead,
  double previous_weight = 2.0;   ///< of changing the choice.
  double look_ahead = 0.6;        ///< m, L in w = 2 v sin(theta) / L.
  double speed = 0.6;             ///< m/s; the paper drives at a constant one.
  double slow_angle = 0.785398;   ///< rad off the chosen direction at which v
                                  ///< has fallen to 0; pi or more: constant.
                                  ///< In any case it is 0 beyond pi / 2, for a
                                  ///< turn on the spot.
  double low_pass = 0.5;          ///< b0 of the filter on w; a1 = 1 - b0.

  void Read(ParameterReader& reader);
};

/// A run of open sectors between two directions, counter-clockwise.
struct Valley {
  double from = 0.0;   ///< rad, robot frame.
  double width = 0.0;  ///< rad, up to 2 pi.
};

struct VfhResult {
  Twist2D command;                ///< rest when no direction is open.
  bool open = false;              ///< some direction is open.
  double direction = 0.0;         ///< rad, robot frame, (-pi, pi].
  std::vector<double> histogram;  ///< density by sector from -pi on, >= 0.
  std::vector<bool> blocked;      ///< as many.
};

/// Vector field histogram: Borenstein and Koren (1991) as Ma et al. use it,
/// with the enlargement, hysteresis and cost of VFH+ (Ulrich and Borenstein
/// 1998). Keeps the previous choice, the open sectors and the filter's state
/// between calls.
class Vfh {
 public:
  explicit Vfh(const VfhParameters& parameters);

  /// @param[in] obstacles points in the robot's frame, m.
  /// @param[in] target direction to go, rad in the robot's frame.
  VfhResult Update(const std::vector<Eigen::Vector2d>& obstacles,
                   double target);

  /// Forgets what was kept between calls.
  void Reset();

 private:
  std::vector<double> Histogram(
      const std::vector<Eigen::Vector2d>& obstacles) const;
  void UpdateBlocked(const std::vector<double>& histogram);
  std::optional<double> ChooseDirection(double target) const;

  VfhParameters parameters_;
  int sectors_;
  std::vector<bool> blocked_;
  std::optional<double> previous_direction_;
  double filtered_w_ = 0.0;
};

/// The moving average of values around a circle, with triangular weights that
/// reach `reach` values to each side.
std::vector<double> SmoothCircle(const std::vector<double>& values, int reach);

/// The open valleys of a circle of sectors that starts at -pi.
std::vector<Valley> FindValleys(const std::vector<bool>& blocked);

}  // namespace vfh_astar

#endif  // VFH_ASTAR_CONTROL_VFH_H_
