#ifndef VFH_ASTAR_PLANNING_BUCKET_QUEUE_H_
#define VFH_ASTAR_PLANNING_BUCKET_QUEUE_H_

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace vfh_astar {

/// A queue by whole-number keys that never fall below the least one in it, and
/// never rise by more than a bound above it, as those of A* with a consistent
/// heuristic (Dial, "Algorithm 360: Shortest-Path Forest", 1969). Entries whose
/// keys differ by less than `width` share a bucket and leave it last in, first
/// out, which makes a search run ahead where all is equal.
template <typename Entry>
class BucketQueue {
 public:
  /// @param[in] width_bits buckets are 2^width_bits keys wide.
  /// @param[in] span the most that a key may exceed the least one.
  BucketQueue(int width_bits, std::uint32_t span) : width_bits_(width_bits) {
    std::size_t count = 1;
    while (count < (span >> width_bits) + 2) count *= 2;
    buckets_.resize(count);
    mask_ = static_cast<std::uint32_t>(count - 1);
  }

  /// Empties the queue; the next keys are `least` or more.
  void Restart(std::uint32_t least) {
    if (size_ != 0) {
      for (std::vector<Entry>& bucket : buckets_) bucket.clear();
    }
    size_ = 0;
    current_ = least >> width_bits_;
  }

  bool empty() const { return size_ == 0; }

  /// No smaller key may be pushed now,
  std::uint32_t SmallestKey() const { return current_ << width_bits_; }
  /// and no greater one.
  std::uint32_t GreatestKey() const {
    return (current_ + static_cast<std::uint32_t>(buckets_.size()) - 1)
           << width_bits_;
  }

  void Push(std::uint32_t key, const Entry& entry) {
    const std::uint32_t bucket = key >> width_bits_;
    assert(bucket >= current_ && bucket - current_ < buckets_.size());
    buckets_[bucket & mask_].push_back(entry);
    ++size_;
  }

  /// A lower bound of every key in the queue, which is not empty.
  std::uint32_t LeastKey() {
    while (Front().empty()) ++current_;
    return current_ << width_bits_;
  }

  /// Takes an entry whose key is within a bucket's width of LeastKey, which has
  /// been called since the last change.
  Entry Pop() {
    const Entry entry = Front().back();
    Front().pop_back();
    --size_;
    return entry;
  }

  /// Takes all entries of the bucket of LeastKey, which has been called since
  /// the last change. Its keys may be pushed again.
  /// @param[out] entries
  void PopBucket(std::vector<Entry>& entries) {
    entries.clear();
    std::swap(entries, Front());
    size_ -= entries.size();
  }

 private:
  std::vector<Entry>& Front() { return buckets_[current_ & mask_]; }

  int width_bits_;
  std::uint32_t mask_;  ///< of a bucket's number, for its place.
  std::uint32_t current_ = 0;
  std::size_t size_ = 0;
  std::vector<std::vector<Entry>> buckets_;
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_PLANNING_BUCKET_QUEUE_H_
