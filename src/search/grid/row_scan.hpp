// Free and blocked stretches of a row of cells, a word of bits at a time.
#pragma once

#include <bit>

#include "search/grid/bit_grid.hpp"

namespace alate {

/// Free cells between two blocked ones, as grid lines: cell c lies between the lines c and c + 1.
struct FreeRun {
  int left = 0;
  int right = 0;
};

/// Of the cells of one row. Columns are counted with the rim, which is blocked, so that scans for blocked cells end.
class RowScan {
 public:
  RowScan(const BitGrid& grid, int row)
      : lanes_(grid.by_row()), first_(static_cast<BitLanes::Cell>(row) * lanes_.stride()) {}

  bool is_blocked(int column) const { return lanes_.is_blocked(cell(column)); }
  /// Are all cells from line `left` to line `right` free?
  bool is_free(int left, int right) const {
    for (; right - left > kShown; left += kShown)
      if (lanes_.from(cell(left)) << (64 - kShown) != 0) return false;
    return right <= left || lanes_.from(cell(left)) << (64 - (right - left)) == 0;
  }
  /// The first free column from `column` on, or one not below `end`.
  int next_free(int column, int end) const {
    for (; column < end; column += kShown) {
      const std::uint64_t free = ~lanes_.from(cell(column)) & kMask;
      if (free != 0) return column + std::countr_zero(free);
    }
    return column;
  }
  /// Around a free column.
  FreeRun run_around(int column) const { return {last_blocked(column) + 1, next_blocked(column)}; }
  /// From a free column on whose left is blocked.
  FreeRun run_from(int column) const { return {column, next_blocked(column)}; }
  /// Up to a line on whose left is free and on whose right is blocked.
  FreeRun run_until(int line) const { return {last_blocked(line - 1) + 1, line}; }

 private:
  static constexpr int kShown = BitLanes::kShown;
  static constexpr std::uint64_t kMask = (std::uint64_t{1} << BitLanes::kShown) - 1;

  BitLanes::Cell cell(int column) const { return first_ + static_cast<BitLanes::Cell>(column); }
  int next_blocked(int column) const {
    for (;; column += kShown) {
      const std::uint64_t blocked = lanes_.from(cell(column)) & kMask;
      if (blocked != 0) return column + std::countr_zero(blocked);
    }
  }
  int last_blocked(int column) const {
    for (;; column -= kShown) {
      const std::uint64_t blocked = lanes_.until(cell(column)) & (kMask << (64 - BitLanes::kShown));
      if (blocked != 0) return column - std::countl_zero(blocked);
    }
  }

  const BitLanes& lanes_;
  BitLanes::Cell first_;
};

}  // namespace alate
