#ifndef VFH_ASTAR_NODES_SIMULATOR_PARAMETERS_H_
#define VFH_ASTAR_NODES_SIMULATOR_PARAMETERS_H_

#include <cmath>
#include <limits>
#include <string>

#include "vfh_astar/geometry.h"
#include "vfh_astar/parameters.h"
#include "vfh_astar/simulation/world.h"

namespace vfh_astar {

struct SimulatorParameters {
  std::string world;  ///< file; see LoadWorld.
  int solid_below = WorldLoadOptions().solid_below;

  static constexpr double kFromWorld = std::numeric_limits<double>::quiet_NaN();
  double x = kFromWorld;    ///< m, start of the first robot in the world.
  double y = kFromWorld;    ///< m
  double yaw = kFromWorld;  ///< rad

  int seed = 1;
  std::string noise = "clean";  ///< see NoisePreset.
  std::string laser = "paper";  ///< see LaserPreset.

  double real_time_factor = 1.0;  ///< simulated per wall time; 0: unpaced.
  bool lockstep = false;          ///< hold the clock until the last scan is
                                  ///< answered,
  double lockstep_timeout = 0.5;  ///< s of the wall clock at the most.

  /// @throws ParameterError
  void Read(ParameterReader& reader) {
    reader.Text("world", world);
    if (world.empty()) {
      throw ParameterError(
          "parameter world is missing; expected the path of a world file");
    }
    reader.Integer("solid_below", solid_below, 0, 256);
    reader.Number("x", x, -1e5, 1e5);
    reader.Number("y", y, -1e5, 1e5);
    reader.Number("yaw", yaw, -10.0, 10.0);
    reader.Integer("seed", seed, 0, std::numeric_limits<int>::max());
    reader.Text("noise", noise);
    reader.Text("laser", laser);
    reader.Number("real_time_factor", real_time_factor, 0.0, 1e4);
    reader.Flag("lockstep", lockstep);
    reader.Number("lockstep_timeout", lockstep_timeout, 0.0, 60.0);
  }

  /// The first robot's start, where the world has it at `world_start`.
  Pose2D Start(const Pose2D& world_start) const {
    return {std::isnan(x) ? world_start.x : x,
            std::isnan(y) ? world_start.y : y,
            std::isnan(yaw) ? world_start.theta : yaw};
  }
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_NODES_SIMULATOR_PARAMETERS_H_
