#ifndef VFH_ASTAR_BENCHMARK_QUANTILE_H_
#define VFH_ASTAR_BENCHMARK_QUANTILE_H_

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <vector>

namespace vfh_astar {

/// The one of the values below which a part of them lies; 0.5: the median, of
/// an even number the upper one.
/// @param[in] values in any order, at least one.
/// @param[in] part 0 to 1.
template <typename T>
T Quantile(std::vector<T> values, double part) {
  assert(!values.empty());
  assert(0.0 <= part && part <= 1.0);
  const auto rank = static_cast<std::size_t>(
      std::min<double>(part * values.size(), values.size() - 1));
  std::nth_element(values.begin(), values.begin() + rank, values.end());
  return values[rank];
}

}  // namespace vfh_astar

#endif  // VFH_ASTAR_BENCHMARK_QUANTILE_H_
