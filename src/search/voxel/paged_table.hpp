// What the cells of a search on a large map cost: pages come into being where a search goes.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "search/voxel/voxel_bits.hpp"
#include "search/voxel/voxel_cost.hpp"

namespace alate {

/// One record for each cell that a query came near. A query forgets what was, page by page as it comes to them, and
/// allocates only where it goes farther than all before. A `Record` has a `key`, the cost, and begins with none.
template <class Record>
class PagedTable {
 public:
  using Key = VoxelCost;
  static constexpr Key kNothing = ~Key{0};

  explicit PagedTable(std::size_t cells) : pages_(cells / kPage) {}

  void begin_query() {
    used_ = 0;
    if (++query_ != 0) return;
    std::ranges::fill(pages_, Page{});
    query_ = 1;
  }
  static Key key(VoxelCost cost) { return cost; }
  static VoxelCost cost(Key key) { return key; }
  bool known(std::uint32_t cell) const { return (*this)[cell] != kNothing; }
  Key operator[](std::uint32_t cell) const {
    const Page& page = pages_[cell / kPage];
    return page.query == query_ ? records_[page.slot][cell % kPage].key : kNothing;
  }
  Key& operator[](std::uint32_t cell) { return record(cell).key; }
  /// For writing; valid until another page is come to.
  Record& record(std::uint32_t cell) {
    Page& page = pages_[cell / kPage];
    if (page.query != query_) open(page);
    return records_[page.slot][cell % kPage];
  }
  /// Of a cell that is known.
  const Record& record(std::uint32_t cell) const { return records_[pages_[cell / kPage].slot][cell % kPage]; }

 private:
  static constexpr std::uint32_t kPage = VoxelBits::kCubeCells;
  struct Page {
    std::uint32_t query = 0;
    std::uint32_t slot = 0;
  };

  void open(Page& page) {
    if (used_ == records_.size()) records_.emplace_back();
    records_[used_].fill(Record{});
    page = {query_, used_++};
  }

  std::vector<Page> pages_;
  std::vector<std::array<Record, kPage>> records_;
  std::uint32_t used_ = 0;
  std::uint32_t query_ = 0;
};

}  // namespace alate
