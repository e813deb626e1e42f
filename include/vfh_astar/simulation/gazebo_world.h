#ifndef VFH_ASTAR_SIMULATION_GAZEBO_WORLD_H_
#define VFH_ASTAR_SIMULATION_GAZEBO_WORLD_H_

#include <string>

#include "vfh_astar/simulation/world.h"

namespace vfh_astar {

/// Reads the static boxes and cylinders of a Gazebo world (SDF), as a planar
/// robot meets them: a model is an obstacle, each of its collisions a shape.
///
/// - Poses of model, nested model, link and collision compose. Where the
///   file's `<state>` gives a model another pose, that one holds, as in Gazebo.
/// - Planes are ground. What lies wholly below the ground, or begins 0.5 m
/// above
///   it or higher, is out of a robot's way and left out.
/// - Visuals, lights, physics and the like mean nothing here.
/// - What would be in a robot's way but is not a static, upright box or
///   cylinder is an error, not left out: other geometry, models that are not
///   static or have a plugin, tilted poses, scaled models, actors, populations,
///   and includes other than the ground plane and the sun.
///
/// Robots and goal are not in such a file.
/// @throws WorldFileError
World LoadGazeboWorld(const std::string& file);

}  // namespace vfh_astar

#endif  // VFH_ASTAR_SIMULATION_GAZEBO_WORLD_H_
