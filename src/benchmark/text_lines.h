#ifndef VFH_ASTAR_BENCHMARK_TEXT_LINES_H_
#define VFH_ASTAR_BENCHMARK_TEXT_LINES_H_

#include <string>
#include <vector>

namespace vfh_astar {

/// A text file, held whole.
struct TextLines {
  std::vector<std::string> lines;  ///< without line ends, '\r' included.
  /// False when the file stops in the middle of its last line, or where gzip
  /// data break off.
  bool is_complete = true;
};

/// Reads a file that may be compressed with gzip.
/// @throws std::runtime_error naming the file, when it cannot be read or its
///   compressed data are damaged.
TextLines ReadTextLines(const std::string& file);

}  // namespace vfh_astar

#endif  // VFH_ASTAR_BENCHMARK_TEXT_LINES_H_
