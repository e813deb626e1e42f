#ifndef VFH_ASTAR_TRAJECTORY_TRAJECTORY_H_
#define VFH_ASTAR_TRAJECTORY_TRAJECTORY_H_

#include <cstddef>
#include <vector>

#include "vfh_astar/geometry.h"
#include "vfh_astar/trajectory/quintic.h"

namespace vfh_astar {

/// One piece of a trajectory.
struct TrajectoryPiece {
  enum class Kind {
    kForward,  ///< drives along (x, y) with its nose ahead.
    kReverse,  ///< drives along (x, y) with its tail ahead: the heading is that
               ///< of the velocity plus pi (k = 1 in the paper's equation).
    kTurn      ///< turns on the spot: (x, y) stand still, heading moves.
  };

  Kind kind = Kind::kForward;
  double duration = 0.0;              ///< s, more than 0.
  Quintic x = Quintic::Zero();        ///< m
  Quintic y = Quintic::Zero();        ///< m
  Quintic heading = Quintic::Zero();  ///< rad, for kTurn alone.
};

/// Where the robot should be, and how it should move, at one time.
struct Reference {
  Pose2D pose;
  Twist2D twist;  ///< the feed-forward v_d (negative in reverse) and
                  ///< w_d.
  double acceleration = 0.0;  ///< m/s^2 along the robot's x axis: dv_d/dt.
};

/// A motion in time from a start to rest at an end. Immutable.
class Trajectory {
 public:
  Trajectory() = default;

  /// @param[in] pieces in order; each starts where the one before it ends.
  explicit Trajectory(std::vector<TrajectoryPiece> pieces);

  bool empty() const { return pieces_.empty(); }
  const std::vector<TrajectoryPiece>& pieces() const { return pieces_; }

  /// s
  double duration() const { return duration_; }

  /// m driven from the start until `t`, forward and backward alike.
  double Length(double t) const;

  /// The last time (s) at which no more than `length` (m) have been driven;
  /// within a micrometre of it, and never later.
  double TimeAtLength(double length) const;

  /// The reference at a time.
  ///   v_d = hypot(x', y'), w_d = (y'' x' - x'' y') / (x'^2 + y'^2),
  ///   theta = atan2(y', x') + k pi
  /// (Ma et al., feed-forward of the tracking law). Where the velocity vanishes
  /// the heading is its limit along the piece and w_d is 0.
  /// @param[in] t s since the trajectory's start; before 0 the start, after
  ///   duration() the end, both at rest.
  /// @pre not empty.
  Reference Sample(double t) const;

 private:
  std::size_t PieceAt(double t) const;

  std::vector<TrajectoryPiece> pieces_;
  std::vector<double> start_times_;    ///< s, of each piece.
  std::vector<double> start_lengths_;  ///< m, of each piece, and the whole.
  double duration_ = 0.0;
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_TRAJECTORY_TRAJECTORY_H_
