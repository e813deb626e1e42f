#ifndef VFH_ASTAR_PLANNING_COST_LANES_H_
#define VFH_ASTAR_PLANNING_COST_LANES_H_

#include <cstdint>
#include <cstring>

#include "vfh_astar/planning/cost_block.h"

// For functions that are compiled for AVX2 only: without it GCC takes these
// vectors apart, lane by lane.
#pragma GCC push_options
#pragma GCC target("avx2")

namespace vfh_astar {

/// Eight costs that are worked on at once (GCC's vector extension). Lane 0 is
/// the first in memory.
using CostLanes = StepCost __attribute__((vector_size(32)));

/// Eight rows or columns.
struct CostSquare {
  CostLanes lines[CostBlock::kSide];
};

inline CostLanes AllLanes(StepCost cost) { return CostLanes{} + cost; }

inline CostLanes Load(const CostBlock::Line& line) {
  CostLanes lanes;
  std::memcpy(&lanes, line, sizeof(lanes));
  return lanes;
}

inline void Store(CostLanes lanes, CostBlock::Line& line) {
  std::memcpy(line, &lanes, sizeof(lanes));
}

inline CostLanes LoadLevels(const CostMap::Level* levels) {
  using Bytes = CostMap::Level __attribute__((vector_size(8)));
  Bytes bytes;
  std::memcpy(&bytes, levels, sizeof(bytes));
  return __builtin_convertvector(bytes, CostLanes);
}

inline CostLanes Lesser(CostLanes a, CostLanes b) { return a < b ? a : b; }

/// Every lane moves to the next higher one, the highest to the lowest.
inline CostLanes RotatedUp(CostLanes v) {
  return __builtin_shuffle(v, CostLanes{7, 0, 1, 2, 3, 4, 5, 6});
}

/// Every lane moves to the next lower one, the lowest to the highest.
inline CostLanes RotatedDown(CostLanes v) {
  return __builtin_shuffle(v, CostLanes{1, 2, 3, 4, 5, 6, 7, 0});
}

inline bool AnySet(CostLanes v) {
  using Words = long long __attribute__((vector_size(32)));
  return __builtin_ia32_ptestz256((Words)v, (Words)v) == 0;
}

inline StepCost LeastLane(CostLanes v) {
  v = Lesser(v, __builtin_shuffle(v, CostLanes{4, 5, 6, 7, 0, 1, 2, 3}));
  v = Lesser(v, __builtin_shuffle(v, CostLanes{2, 3, 0, 1, 6, 7, 4, 5}));
  v = Lesser(v, __builtin_shuffle(v, CostLanes{1, 0, 3, 2, 5, 4, 7, 6}));
  return v[0];
}

/// Rows become columns.
inline CostSquare Transposed(const CostSquare& rows) {
  CostSquare pairs;
  for (int i = 0; i < 4; ++i) {
    const CostLanes& a = rows.lines[2 * i];
    const CostLanes& b = rows.lines[2 * i + 1];
    pairs.lines[2 * i] =
        __builtin_shuffle(a, b, CostLanes{0, 8, 1, 9, 4, 12, 5, 13});
    pairs.lines[2 * i + 1] =
        __builtin_shuffle(a, b, CostLanes{2, 10, 3, 11, 6, 14, 7, 15});
  }
  CostSquare quarters;
  for (int half = 0; half < 2; ++half) {
    for (int i = 0; i < 2; ++i) {
      const CostLanes& a = pairs.lines[4 * half + i];
      const CostLanes& b = pairs.lines[4 * half + i + 2];
      quarters.lines[4 * half + 2 * i] =
          __builtin_shuffle(a, b, CostLanes{0, 1, 8, 9, 4, 5, 12, 13});
      quarters.lines[4 * half + 2 * i + 1] =
          __builtin_shuffle(a, b, CostLanes{2, 3, 10, 11, 6, 7, 14, 15});
    }
  }
  CostSquare columns;
  for (int i = 0; i < 4; ++i) {
    const CostLanes& a = quarters.lines[i];
    const CostLanes& b = quarters.lines[i + 4];
    columns.lines[i] =
        __builtin_shuffle(a, b, CostLanes{0, 1, 2, 3, 8, 9, 10, 11});
    columns.lines[i + 4] =
        __builtin_shuffle(a, b, CostLanes{4, 5, 6, 7, 12, 13, 14, 15});
  }
  return columns;
}

}  // namespace vfh_astar

#pragma GCC pop_options

#endif  // VFH_ASTAR_PLANNING_COST_LANES_H_
