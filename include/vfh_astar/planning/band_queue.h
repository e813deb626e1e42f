#ifndef VFH_ASTAR_PLANNING_BAND_QUEUE_H_
#define VFH_ASTAR_PLANNING_BAND_QUEUE_H_

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <vector>

#include "vfh_astar/planning/bucket_queue.h"

namespace vfh_astar {

/// A queue by whole-number keys, band by band, and by another number, the
/// order, within a band: for a search that may take a node before the best way
/// to it has come, and then has to take it again. By estimate alone, as A*
/// goes, ways of about the same estimate come to a place long after one
/// another. In the order from the start they come together.
template <typename Entry>
class BandQueue {
 public:
  /// @param[in] band_bits bands are 2^band_bits keys wide.
  /// @param[in] order_bits orders that differ by less than 2^order_bits are as
  ///   good as equal.
  /// @param[in] span the most that a key may exceed the least one.
  /// @param[in] order_span orders that exceed the least one by more are not
  ///   told apart.
  BandQueue(int band_bits, int order_bits, std::uint32_t span,
            std::uint32_t order_span)
      : band_bits_(band_bits),
        later_(band_bits, span),
        now_(order_bits, order_span) {}

  /// Empties the queue; the next keys are `least` or more.
  void Restart(std::uint32_t least) {
    band_ = least >> band_bits_;
    later_.Restart(least);
    now_.Restart(0);
  }

  bool empty() const { return now_.empty() && later_.empty(); }

  void Push(std::uint32_t key, std::uint32_t order, const Entry& entry) {
    assert(key >> band_bits_ >= band_);
    if (key >> band_bits_ > band_) {
      later_.Push(key, {entry, order});
    } else {
      PushNow(order, entry);
    }
  }

  /// A lower bound of every key in the queue, which is not empty.
  std::uint32_t LeastKey() {
    if (now_.empty()) BeginBand();
    return band_ << band_bits_;
  }

  /// Keys of the least band are below it.
  std::uint32_t EndOfBand() const { return (band_ + 1) << band_bits_; }

  /// Takes an entry of the least band. LeastKey has been called since the last
  /// change.
  Entry Pop() {
    now_.LeastKey();
    return now_.Pop();
  }

 private:
  struct Waiting {
    Entry entry;
    std::uint32_t order;
  };

  void PushNow(std::uint32_t order, const Entry& entry) {
    now_.Push(std::clamp(order, now_.SmallestKey(), now_.GreatestKey()), entry);
  }

  void BeginBand() {
    band_ = later_.LeastKey() >> band_bits_;
    later_.PopBucket(begun_);
    const auto least = std::min_element(
        begun_.begin(), begun_.end(),
        [](const Waiting& a, const Waiting& b) { return a.order < b.order; });
    now_.Restart(least->order);
    for (const Waiting& waiting : begun_) {
      PushNow(waiting.order, waiting.entry);
    }
  }

  int band_bits_;
  std::uint32_t band_ = 0;      ///< the present one.
  BucketQueue<Waiting> later_;  ///< by key, a band per bucket.
  BucketQueue<Entry> now_;      ///< the present band, by order.
  std::vector<Waiting> begun_;
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_PLANNING_BAND_QUEUE_H_
