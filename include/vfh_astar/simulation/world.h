#ifndef VFH_ASTAR_SIMULATION_WORLD_H_
#define VFH_ASTAR_SIMULATION_WORLD_H_

#include <Eigen/Core>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "vfh_astar/geometry.h"
#include "vfh_astar/simulation/laser_model.h"
#include "vfh_astar/simulation/shape.h"

namespace vfh_astar {

/// Something solid that does not move, in the world's frame.
struct StaticObstacle {
  std::string name;
  std::vector<Shape> shapes;
};

/// A mover's place at a time.
struct Keyframe {
  double time = 0.0;                                   ///< s
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  ///< m
};

/// Something solid that goes its way and yields to nobody.
struct Mover {
  std::string name;
  Shape shape;                      ///< about its own origin; it does not turn.
  std::vector<Keyframe> keyframes;  ///< at least one, times rising.
  double period = 0.0;  ///< s after which it begins anew (it jumps back when
                        ///< its last place is not its first); 0: it stays at
                        ///< the last keyframe.

  /// m, in the world's frame.
  Eigen::Vector2d PositionAt(double time) const;
};

/// Something solid that appears while the robot drives.
struct PopUp {
  std::string name;
  std::vector<Shape> shapes;                ///< in the world's frame.
  std::optional<double> time;               ///< s at which it appears,
  std::optional<double> approach_distance;  ///< or m between the first robot
                                            ///< and `approach_point`.
  Eigen::Vector2d approach_point = Eigen::Vector2d::Zero();
};

/// Somebody who steps into a robot's way, again and again, as WalkerMotion
/// tells.
struct Walker {
  std::string name;
  Eigen::Vector2d home = Eigen::Vector2d::Zero();  ///< m, where it begins.
  double radius = 0.25;                            ///< m
  double speed = 1.5;                              ///< m/s
  double notice = 4.0;  ///< m from a robot's centre at which it sets off.
  double ahead = 1.5;   ///< m in front of the robot's centre, where it wants
                        ///< to be by the time it gets there.
  double keep = 0.6;    ///< m that it keeps from a robot while it walks.
  double stand = 1.5;   ///< s that it stands there.
  int times = 3;        ///< that it does so.
};

/// A part of the floor on which tyres have another grip.
struct GroundPatch {
  std::vector<Shape> shapes;
  double friction = 0.0;  ///< of the tyres.
  /// N s/m per wheel, see JackalModel.
  double tyre_slip_stiffness = 0.0;
};

/// The name of a robot where the file does not name one. What a robot touches
/// is told by name, so nothing else may have it then.
inline constexpr char kOnlyRobot[] = "robot_1";

struct RobotStart {
  std::string name;
  Pose2D pose;
  std::optional<Pose2D> goal = std::nullopt;       ///< suggested.
  std::optional<LaserModel> laser = std::nullopt;  ///< else the simulation's.
};

/// A planar world as its file describes it.
struct World {
  std::string name;
  std::vector<StaticObstacle> obstacles;
  std::vector<Mover> movers;
  std::vector<PopUp> pop_ups;
  std::vector<Walker> walkers;
  std::vector<GroundPatch> ground;  ///< the first one under a wheel holds.
  std::vector<RobotStart> robots;   ///< at least one.
  std::optional<Pose2D> goal;       ///< suggested for the first robot.
};

/// A world file that cannot be read; the message names the file, the line or
/// field, what was found and what was expected.
class WorldFileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct WorldLoadOptions {
  /// In a map_server map every pixel darker than this grey value (0 to 255) is
  /// solid. The default takes map_saver's unknown (205) as open and the grey
  /// edges of drawn walls as solid.
  int solid_below = 205;
};

/// Reads a world by what the file is: a world of this package (YAML with a
/// `version`), a Gazebo `.world` (its static boxes and cylinders), a DynaBARN
/// world (JSON with `obstacles` and `keyframes_t_x_y`), or a map_server map
/// (YAML with an `image`), whose solid pixels become walls. A file that names
/// no robot gets one, `robot_1`, at (0, 0, 0): where it really starts is then
/// the caller's to say, as that place need not be free.
/// @throws WorldFileError, or MapFileError for the image of a map.
World LoadWorld(const std::string& file, const WorldLoadOptions& options = {});

}  // namespace vfh_astar

#endif  // VFH_ASTAR_SIMULATION_WORLD_H_
