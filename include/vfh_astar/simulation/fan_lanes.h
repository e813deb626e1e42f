#ifndef VFH_ASTAR_SIMULATION_FAN_LANES_H_
#define VFH_ASTAR_SIMULATION_FAN_LANES_H_

#include <Eigen/Core>
#include <array>

namespace vfh_astar {

/// What a BeamFan asks about several boxes, discs or beams at once: the same
/// arithmetic for each without a branch, so that the compiler makes vectors of
/// it, as wide as the processor has them.
constexpr int kFanLanes = 8;
using FanLanes = std::array<double, kFanLanes>;

/// m, boxes along the axes beside each other.
struct BoxLanes {
  FanLanes min_x, min_y, max_x, max_y;
};

/// m, discs beside each other.
struct DiscLanes {
  FanLanes x, y, radius;
};

/// Where a fan looks from, and along what its first beam points.
struct FanFrame {
  Eigen::Vector2d origin = Eigen::Vector2d::Zero();
  Eigen::Vector2d axis = Eigen::Vector2d::UnitX();
};

/// The part of a fan's view that something may fill.
struct View {
  /// rad from the first beam counter-clockwise, `low` above -pi / 2 and not
  /// above `high`. Off by kBearingError at most.
  double low, high;
  /// m^2, from the origin to the nearest point of something that is then
  /// `radius` (m) larger all around.
  double distance_squared;
  double radius;
};

/// rad
constexpr double kBearingError = 2e-5;

/// The views of things beside each other.
struct ViewLanes {
  FanLanes low, high, distance_squared;

  View At(int lane, double radius) const {
    return {low[lane], high[lane], distance_squared[lane], radius};
  }
};

/// The angle of a vector from the x axis in [0, 2 pi] to kBearingError, by a
/// polynomial that deviates least from the arc tangent (fitted to 1.1e-5 rad).
double Bearing(const Eigen::Vector2d& v);

/// rad from one bearing counter-clockwise to another that is at most half a
/// turn away; 0 where only the error of Bearing has them the other way round.
double Width(double low, double high);

/// All around for a box that holds the origin.
ViewLanes ViewBoxes(const FanFrame& frame, const BoxLanes& boxes);

/// @param[out] centers in the frame of the fan; the radii as they were.
/// @return all around for a disc that holds the origin or nearly does.
ViewLanes ViewDiscs(const FanFrame& frame, const DiscLanes& discs,
                    DiscLanes* centers);

/// For each lane, in how many the distance is greater, or the same in a lane
/// before it: the lanes' places in an order from far to near.
std::array<int, kFanLanes> PlacesFromFar(const FanLanes& distances);

/// Ends kFanLanes beams at a disc where they meet it before their ranges.
/// @param[in] center, radius m, in the frame that the beams are given in.
/// @param[in] x, y of the beams' unit vectors.
/// @param[in,out] ranges m
/// @return the greatest range after that.
double MeetDisc(const Eigen::Vector2d& center, double radius, const double* x,
                const double* y, double* ranges);

}  // namespace vfh_astar

#endif  // VFH_ASTAR_SIMULATION_FAN_LANES_H_
