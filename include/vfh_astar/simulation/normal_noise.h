#ifndef VFH_ASTAR_SIMULATION_NORMAL_NOISE_H_
#define VFH_ASTAR_SIMULATION_NORMAL_NOISE_H_

#include <random>

namespace vfh_astar {

/// A number from the normal distribution of mean 0 and deviation 1, three times
/// as fast as from std::normal_distribution. The ziggurat of Marsaglia and
/// Tsang (2000), "The Ziggurat Method for Generating Random Variables", in
/// steps of 2^-24 of a layer.
double DrawNormal(std::mt19937* random);

}  // namespace vfh_astar

#endif  // VFH_ASTAR_SIMULATION_NORMAL_NOISE_H_
