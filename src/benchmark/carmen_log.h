#ifndef VFH_ASTAR_BENCHMARK_CARMEN_LOG_H_
#define VFH_ASTAR_BENCHMARK_CARMEN_LOG_H_

#include <stdexcept>
#include <string>
#include <vector>

#include "vfh_astar/geometry.h"
#include "vfh_astar/laser_scan.h"

namespace vfh_astar {

/// A log that cannot be used; the message names the file, the line, the value
/// found and what was expected.
class CarmenLogError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// One FLASER line.
struct CarmenScan {
  /// scan.stamp is the line's ipc_time. What the laser did not see is NaN.
  LaserScan scan;
  /// The base by wheel odometry alone when the scan was taken.
  Pose2D odometry;
  /// The laser by the log's first pose triple: a reference where the log is
  /// corrected, odometry where it is not.
  Pose2D reference;
};

struct CarmenLog {
  std::vector<CarmenScan> scans;
  /// True when the FLASER lines, and the ODOM line after each, hold poses that
  /// somebody has corrected; then odometry is the chain of what the ODOM lines
  /// between two scans add.
  bool is_corrected = false;
  double laser_offset = 0.0;  ///< m, the laser in front of the base.
  double duration = 0.0;      ///< s, from first to last scan; see the reader.
};

/// Reads a CARMEN log, gzip or plain. Lines other than FLASER, ODOM and PARAM
/// are passed over, and so is a last line that breaks off.
///
/// A log counts as corrected when for most scans the ODOM line behind repeats
/// the scan's odometry pose while the ODOM lines before lead elsewhere, and no
/// odometer can have gone there: the repeating line's stamp does not follow the
/// one before it. In a plain log the odometry of a scan is its own second pose
/// triple.
///
/// Beams span 180 degrees from -90: an even number of n in steps of 180/n
/// degrees, an odd one in steps of 180/(n-1), as CARMEN has it. The longest
/// range of the log is what the laser says when it sees nothing.
///
/// Stamps may be broken: the duration is the sum of what passes between scans,
/// without steps backwards or of more than ten minutes.
///
/// @throws CarmenLogError for an unreadable file, a malformed line, or a log
///   with fewer than two scans.
CarmenLog ReadCarmenLog(const std::string& file);

}  // namespace vfh_astar

#endif  // VFH_ASTAR_BENCHMARK_CARMEN_LOG_H_
