#include "vfh_astar/planning/block_lengths.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "vfh_astar/planning/lanes.h"

// Other compilers have other ways to compile a function for one processor.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define VFH_ASTAR_HAS_AVX2_VERSION
#include <immintrin.h>
#endif

// In one function, what its parts hand on stays in registers.
#define VFH_ASTAR_INLINE __attribute__((always_inline)) inline

namespace vfh_astar {

// The kernel is compiled twice, over what the first file has for the processor.
namespace baseline {
#include "lane_pairs.inc"

#include "block_relaxation.inc"

#include "block_edges.inc"
}  // namespace baseline

#ifdef VFH_ASTAR_HAS_AVX2_VERSION
#pragma GCC push_options
#pragma GCC target("avx2")
namespace avx2 {
#include "lane_pairs_avx2.inc"

#include "block_relaxation.inc"

#include "block_edges.inc"
}  // namespace avx2
#pragma GCC pop_options
#endif

const BlockKernel& BaselineBlockKernel() { return baseline::kKernel; }

const BlockKernel* Avx2BlockKernel() {
#ifdef VFH_ASTAR_HAS_AVX2_VERSION
  if (__builtin_cpu_supports("avx2")) return &avx2::kKernel;
#endif
  return nullptr;
}

const BlockKernel& FastestBlockKernel() {
  const BlockKernel* const avx2 = Avx2BlockKernel();
  return avx2 != nullptr ? *avx2 : BaselineBlockKernel();
}

}  // namespace vfh_astar
