#ifndef VFH_ASTAR_BENCHMARK_RELATIONS_FILE_H_
#define VFH_ASTAR_BENCHMARK_RELATIONS_FILE_H_

#include <stdexcept>
#include <string>
#include <vector>

#include "benchmark/trajectory_error.h"

namespace vfh_astar {

/// A relations file that cannot be used; the message names the file, the line,
/// the value found and what was expected.
class RelationsError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Reads the relations of the SLAM benchmark of Kuemmerle et al.: a line
/// `t1 t2 x y z roll pitch yaw` for the pose at t2 (s) in the frame of that at
/// t1, in m and rad. Blank lines and those that begin with # are passed over.
/// @param[in] stamps s, of the poses, in the time of the file. A relation takes
///   the pose nearest in time; one with none within 0.1 s is left out, as logs
///   are often thinned.
/// @throws RelationsError also when no relation is left.
std::vector<PoseRelation> ReadRelations(const std::string& file,
                                        const std::vector<double>& stamps);

}  // namespace vfh_astar

#endif  // VFH_ASTAR_BENCHMARK_RELATIONS_FILE_H_
