// One number for every bin of place and heading, in pages that exist only where a search has been.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace alate {

/// A search that stays in a corner of a large map pays for the corner. Pages are kept between searches.
class BinPages {
 public:
  static constexpr int kHeadings = 16;
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};

  /// Every bin holds kNone again.
  void clear(int columns, int rows) {
    pages_across_ = columns / kSide + 1;
    const int pages_up = rows / kSide + 1;
    page_of_.assign(static_cast<std::size_t>(pages_across_) * static_cast<std::size_t>(pages_up), kNone);
    used_ = 0;
  }

  std::uint32_t& at(int column, int row, int heading) {
    const int page = row / kSide * pages_across_ + column / kSide;
    std::uint32_t& number = page_of_[static_cast<std::size_t>(page)];
    if (number == kNone) number = next_page();
    return pages_[number][bin_in_page(column, row, heading)];
  }

  /// The same, kNone where no search has been.
  std::uint32_t find(int column, int row, int heading) const {
    const int page = row / kSide * pages_across_ + column / kSide;
    const std::uint32_t number = page_of_[static_cast<std::size_t>(page)];
    return number == kNone ? kNone : pages_[number][bin_in_page(column, row, heading)];
  }

 private:
  static constexpr int kSide = 8;
  using Page = std::array<std::uint32_t, static_cast<std::size_t>(kSide* kSide* kHeadings)>;

  static std::size_t bin_in_page(int column, int row, int heading) {
    const int bin = (row % kSide * kSide + column % kSide) * kHeadings + heading;
    return static_cast<std::size_t>(bin);
  }

  std::uint32_t next_page() {
    if (used_ == pages_.size()) pages_.emplace_back();
    pages_[used_].fill(kNone);
    return static_cast<std::uint32_t>(used_++);
  }

  int pages_across_ = 0;
  std::vector<std::uint32_t> page_of_;
  std::vector<Page> pages_;
  std::size_t used_ = 0;
};

}  // namespace alate
