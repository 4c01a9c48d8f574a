// What every cell of a search costs, forgotten between queries without clearing.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "search/grid/octile.hpp"

namespace alate {

/// A cost carries the number of its query in its upper bits. Numbers count down, so that whatever an earlier query left
/// behind is larger than any cost of this one: an unknown cell needs no test of its own.
class CostTable {
 public:
  using Key = std::uint64_t;

  explicit CostTable(std::size_t cells) : keys_(cells, kNothing) {}

  void begin_query() {
    if (query_ == 0) {
      std::ranges::fill(keys_, kNothing);
      query_ = kQueries;
    }
    --query_;
  }
  /// Of `cost` in this query.
  Key key(OctileCost cost) const { return (query_ << kOctileCostBits) | cost; }
  static OctileCost cost(Key key) { return key & kMostOctileCost; }
  bool known(std::uint32_t cell) const { return keys_[cell] >> kOctileCostBits == query_; }
  Key operator[](std::uint32_t cell) const { return keys_[cell]; }
  Key& operator[](std::uint32_t cell) { return keys_[cell]; }

 private:
  static constexpr Key kNothing = ~Key{0};
  static constexpr Key kQueries = kNothing >> kOctileCostBits;

  std::vector<Key> keys_;
  Key query_ = kQueries;
};

}  // namespace alate
