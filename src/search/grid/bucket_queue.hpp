// The open list of a search on a grid: buckets of nearly equal priority, the last in the first out.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <utility>
#include <vector>

#include "search/grid/octile.hpp"

namespace alate {

/// A bucket is narrower than the least amount by which a step can raise f = g + octile h, 2 kStraight - kDiagonal, so
/// entries of one bucket that come out in any order hardly ever have to be looked at again (Denardo and Fox 1979); that
/// they may is the caller's business. Entries lie in one array, linked by bucket; their places are used again.
template <class Entry>
class BucketQueue {
 public:
  static constexpr unsigned kWidthBits = 24;
  static_assert((OctileCost{1} << kWidthBits) <= 2 * kStraight - kDiagonal);

  /// `spread`: by how much an entry's priority may exceed the lowest that is or was on top.
  explicit BucketQueue(OctileCost spread) : heads_(std::bit_ceil((spread >> kWidthBits) + 2), kNone) {}

  /// Empties the queue; priorities start at `least`.
  void clear(OctileCost least) {
    if (count_ > 0) std::ranges::fill(heads_, kNone);
    links_.clear();
    spare_ = kNone;
    count_ = 0;
    level_ = least >> kWidthBits;
  }
  bool empty() const { return count_ == 0; }
  /// A priority below the lowest bucket counts as in it.
  void push(OctileCost priority, const Entry& entry) {
    std::uint32_t& head = heads_[std::max(priority >> kWidthBits, level_) & (heads_.size() - 1)];
    const std::uint32_t next = head;
    if (spare_ == kNone) {
      head = static_cast<std::uint32_t>(links_.size());
      links_.emplace_back(entry, next);
    } else {
      head = std::exchange(spare_, links_[spare_].next);
      links_[head].entry = entry;
      links_[head].next = next;
    }
    ++count_;
  }
  /// From the lowest bucket. The queue must not be empty.
  Entry pop() {
    while (top() == kNone) ++level_;
    std::uint32_t& head = heads_[level_ & (heads_.size() - 1)];
    const std::uint32_t place = head;
    head = std::exchange(links_[place].next, spare_);
    spare_ = place;
    --count_;
    return links_[place].entry;
  }

 private:
  static constexpr std::uint32_t kNone = UINT32_MAX;
  struct Link {
    Entry entry;
    std::uint32_t next;
  };

  std::uint32_t top() const { return heads_[level_ & (heads_.size() - 1)]; }

  std::vector<std::uint32_t> heads_;
  std::vector<Link> links_;
  std::uint32_t spare_ = kNone;
  std::size_t count_ = 0;
  std::uint64_t level_ = 0;
};

}  // namespace alate
