#ifndef VFH_ASTAR_CONTROL_EVASION_H_
#define VFH_ASTAR_CONTROL_EVASION_H_

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "vfh_astar/footprint.h"
#include "vfh_astar/geometry.h"
#include "vfh_astar/parameters.h"
#include "vfh_astar/robot_limits.h"
#include "vfh_astar/tracking/moving_obstacle.h"

namespace vfh_astar {

struct EvasionParameters {
  double horizon = 3.0;       ///< s that are looked ahead.
  double margin = 0.15;       ///< m to keep from what moves, and
  double growth = 0.1;        ///< m/s by which that grows with the time ahead.
  double lead = 0.7;          ///< s of its way that count as its body, so that
                              ///< the robot passes behind rather than before.
  double comfort = 1.0;       ///< m from which on more room is no better.
  double room_weight = 3.0;   ///< cost of a metre less than that, in m of way.
  double contact_cost = 3.0;  ///< m of way that a contact at the horizon costs,
  double haste_cost = 8.0;    ///< and how much more one that is near.
  double change_weight = 0.3;   ///< m for a choice a radian off the last one.
  double reverse_weight = 0.5;  ///< m for a metre in reverse.

  void Read(ParameterReader& reader);
};

/// What the robot has to find its way through, in its own frame now.
struct EvasionScene {
  Twist2D twist;           ///< as commanded last.
  Eigen::Vector2d target;  ///< m, where it wants to go.
  std::vector<MovingObstacle> movers;
  /// m from a point to the nearest thing that stands; null: nothing does.
  std::function<double(const Eigen::Vector2d&)> room;
  /// True for a command that will be let through; null: all are.
  std::function<bool(const Twist2D&)> is_allowed;
};

struct EvasionResult {
  Twist2D command;
  double contact_time = 0.0;  ///< s until what moves is nearer than the margin;
                              ///< +inf when that is beyond the horizon.
  double direction = 0.0;     ///< rad, robot frame, chosen.
};

/// Finds a way between things that move, as velocity obstacles do (Fiorini and
/// Shiller 1998), but over motions that the robot can make: from its present
/// speed it turns to a heading and drives on at some speed, forwards or
/// backwards, or waits. Each motion is played through against the obstacles'
/// straight ways; the one with the least cost is begun,
/// of those whose first command will be let through if there is one.
class Evasion {
 public:
  Evasion(const EvasionParameters& parameters, const Footprint& footprint,
          const RobotLimits& limits);

  EvasionResult Update(const EvasionScene& scene);

  /// Forgets the last choice.
  void Reset() { last_heading_.reset(); }

 private:
  struct Motion {
    double speed;    ///< m/s, negative in reverse.
    double heading;  ///< rad, robot frame now.
  };
  struct Outlook {
    double contact_time;
    double gap;        ///< m, least, less what it must be at its time.
    double way;        ///< m nearer to the target.
    double free_time;  ///< s until something that stands is in the way.
  };

  /// Something that moves, and what of it is the same for all motions.
  struct Body {
    Eigen::Vector2d ahead;  ///< m, its way that counts as its body.
    double radius;          ///< m
    double speed;           ///< m/s
    double margin;          ///< m to keep from it.
  };
  struct Place {
    Eigen::Vector2d position;  ///< m
    /// m^2 from which on the robot is further away than comfort asks.
    double beyond;
  };
  /// Where everything that moves will be at the times of the steps.
  struct Forecast {
    std::vector<Body> bodies;
    std::vector<double> times;  ///< s, from 0 up to the horizon.
    std::vector<Place> places;  ///< of all bodies, time by time.

    const Place* At(std::size_t step) const {
      return places.data() + step * bodies.size();
    }
  };

  Forecast Foresee(const EvasionScene& scene) const;
  std::vector<Motion> Motions(const EvasionScene& scene) const;
  Twist2D Steer(const Motion& motion, double heading) const;
  /// Nothing for a motion that will cost more than `most`.
  std::optional<Outlook> Play(const Motion& motion, const EvasionScene& scene,
                              const Forecast& forecast, double most) const;
  /// Takes in how near the robot comes to what moves.
  void LookAround(const Eigen::Vector2d& place, const Forecast& forecast,
                  std::size_t step, Outlook* outlook) const;
  /// m between robot and obstacle, less what its way is uncertain by.
  double Gap(const Body& body, const Eigen::Vector2d& position,
             const Eigen::Vector2d& place, double time) const;
  /// The twist as what moves nearby will allow it.
  Twist2D Slowed(const Twist2D& twist, const Pose2D& pose,
                 const Forecast& forecast, std::size_t step) const;
  double Cost(const Motion& motion, const Outlook& outlook) const;
  /// The order in which a good motion is likely to be found soon.
  std::vector<std::size_t> MostPromisingFirst(
      const std::vector<Motion>& motions, const EvasionScene& scene,
      double horizon) const;

  EvasionParameters parameters_;
  Footprint footprint_;
  RobotLimits limits_;
  RobotLimits reliable_;  ///< what is counted on of them.
  double radius_;         ///< m, of the circle around the footprint.
  std::optional<double> last_heading_;
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_CONTROL_EVASION_H_
