#ifndef VFH_ASTAR_PLANNING_LANES_H_
#define VFH_ASTAR_PLANNING_LANES_H_

#include <array>
#include <cstdint>
#include <limits>
#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace vfh_astar {

/// Eight whole numbers that are worked on at once (GCC's vector extension; one
/// register of SSE2 or NEON). Lane 0 is the first in memory.
using Lanes = std::int16_t __attribute__((vector_size(16)));
inline constexpr int kLanes = 8;

/// Eight rows of eight lanes.
using LaneSquare = std::array<Lanes, kLanes>;

inline Lanes AllLanes(std::int16_t value) { return Lanes{} + value; }

inline Lanes Greater(Lanes a, Lanes b) { return a > b ? a : b; }

/// a - b where that is more than 0, else 0. No lane of `a` or `b` is less than
/// 0.
inline Lanes LessBy(Lanes a, Lanes b) {
#ifdef __SSE2__
  return (Lanes)_mm_subs_epu16((__m128i)a, (__m128i)b);
#else
  return Greater(a - b, Lanes{});
#endif
}

/// a + b, or the type's limit where that is beyond it.
inline Lanes SumUpToMost(Lanes a, Lanes b) {
#ifdef __SSE2__
  return (Lanes)_mm_adds_epi16((__m128i)a, (__m128i)b);
#else
  using Unsigned = std::uint16_t __attribute__((vector_size(16)));
  const Lanes sum = (Lanes)((Unsigned)a + (Unsigned)b);
  const Lanes limit = (a >> 15) ^ std::numeric_limits<std::int16_t>::max();
  // Too far when the sum's sign is neither's.
  return ((a ^ sum) & (b ^ sum)) < 0 ? limit : sum;
#endif
}

/// Every lane moves to the next higher one; the lowest becomes 0.
inline Lanes ShiftedUp(Lanes v) {
#ifdef __SSE2__
  // Not every compiler sees one instruction in the shuffle.
  return (Lanes)_mm_slli_si128((__m128i)v, 2);
#else
  return __builtin_shuffle(v, Lanes{}, Lanes{8, 0, 1, 2, 3, 4, 5, 6});
#endif
}

/// Every lane moves to the next lower one; the highest becomes 0.
inline Lanes ShiftedDown(Lanes v) {
#ifdef __SSE2__
  return (Lanes)_mm_srli_si128((__m128i)v, 2);
#else
  return __builtin_shuffle(v, Lanes{}, Lanes{1, 2, 3, 4, 5, 6, 7, 8});
#endif
}

inline Lanes ShiftedUpByTwo(Lanes v) {
#ifdef __SSE2__
  return (Lanes)_mm_slli_si128((__m128i)v, 4);
#else
  return __builtin_shuffle(v, Lanes{}, Lanes{8, 9, 0, 1, 2, 3, 4, 5});
#endif
}

inline Lanes ShiftedDownByTwo(Lanes v) {
#ifdef __SSE2__
  return (Lanes)_mm_srli_si128((__m128i)v, 4);
#else
  return __builtin_shuffle(v, Lanes{}, Lanes{2, 3, 4, 5, 6, 7, 8, 9});
#endif
}

inline bool AnySet(Lanes v) {
#ifdef __SSE2__
  return _mm_movemask_epi8(_mm_cmpeq_epi8((__m128i)v, _mm_setzero_si128())) !=
         0xffff;
#else
  using Words = std::uint64_t __attribute__((vector_size(16)));
  const Words words = (Words)v;
  return (words[0] | words[1]) != 0;
#endif
}

/// Four whole numbers of 32 bits.
using WideLanes = std::int32_t __attribute__((vector_size(16)));

/// A bit per lane, set where it is negative.
inline unsigned SignBits(WideLanes v) {
#ifdef __SSE2__
  return static_cast<unsigned>(_mm_movemask_ps((__m128)v));
#else
  const WideLanes bits = (v >> 31) & WideLanes{1, 2, 4, 8};
  return static_cast<unsigned>(bits[0] | bits[1] | bits[2] | bits[3]);
#endif
}

inline std::int16_t GreatestLane(Lanes v) {
  v = Greater(v, __builtin_shuffle(v, Lanes{4, 5, 6, 7, 0, 1, 2, 3}));
  v = Greater(v, __builtin_shuffle(v, Lanes{2, 3, 0, 1, 6, 7, 4, 5}));
  v = Greater(v, __builtin_shuffle(v, Lanes{1, 0, 3, 2, 5, 4, 7, 6}));
  return v[0];
}

/// Rows become columns.
inline LaneSquare Transposed(const LaneSquare& rows) {
  using Pairs = std::int32_t __attribute__((vector_size(16)));
  using Halves = std::int64_t __attribute__((vector_size(16)));
  Pairs pairs[8];
  for (int i = 0; i < 4; ++i) {
    const Lanes& a = rows[2 * i];
    const Lanes& b = rows[2 * i + 1];
    pairs[i] = (Pairs)__builtin_shuffle(a, b, Lanes{0, 8, 1, 9, 2, 10, 3, 11});
    pairs[i + 4] =
        (Pairs)__builtin_shuffle(a, b, Lanes{4, 12, 5, 13, 6, 14, 7, 15});
  }
  LaneSquare columns;
  for (int half = 0; half < 2; ++half) {
    const Pairs* const in = pairs + 4 * half;
    for (int part = 0; part < 2; ++part) {
      const Pairs order = part == 0 ? Pairs{0, 4, 1, 5} : Pairs{2, 6, 3, 7};
      const auto low = (Halves)__builtin_shuffle(in[0], in[1], order);
      const auto high = (Halves)__builtin_shuffle(in[2], in[3], order);
      const int column = 4 * half + 2 * part;
      columns[column] = (Lanes)__builtin_shuffle(low, high, Halves{0, 2});
      columns[column + 1] = (Lanes)__builtin_shuffle(low, high, Halves{1, 3});
    }
  }
  return columns;
}

}  // namespace vfh_astar

#endif  // VFH_ASTAR_PLANNING_LANES_H_
