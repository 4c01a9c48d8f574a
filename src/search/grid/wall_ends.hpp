// Where walls beside a grid line end, a word of bits at a time.
#pragma once

#include <bit>

#include "search/grid/bit_grid.hpp"

namespace alate {

/// Follows a grid line between two rows, from between the cells `beyond` and `before`, both free: ahead to larger
/// columns, otherwise to smaller ones. Tells `turn(steps, is_beyond)` of every corner of a single blocked cell that was
/// just passed: after how many cells, and on which side of the line. Ends where both sides are blocked, or one behind
/// the other with only a corner between them.
template <bool kAhead, class Turn>
void wall_ends(const BitLanes& lanes, BitLanes::Cell beyond, BitLanes::Cell before, const Turn& turn) {
  constexpr unsigned kNew = BitLanes::kShown - 1;  // All that are shown but the first, which was looked at before.
  constexpr std::uint64_t kBits =
      kAhead ? ((std::uint64_t{1} << kNew) - 1) << 1U : ((std::uint64_t{1} << kNew) - 1) << (63U - kNew);
  const auto look = [&](BitLanes::Cell cell) { return kAhead ? lanes.from(cell) : lanes.until(cell); };
  const auto passed = [](std::uint64_t blocked) { return kAhead ? blocked << 1U : blocked >> 1U; };
  const auto first = [](std::uint64_t bits) {
    return static_cast<unsigned>(kAhead ? std::countr_zero(bits) : std::countl_zero(bits));
  };
  const auto bit = [](unsigned i) { return std::uint64_t{1} << (kAhead ? i : 63U - i); };
  for (unsigned steps = 0;; steps += kNew) {
    const std::uint64_t a = look(kAhead ? beyond + steps : beyond - steps);
    const std::uint64_t b = look(kAhead ? before + steps : before - steps);
    const std::uint64_t ends = ((a & b) | (a & passed(b)) | (b & passed(a))) & kBits;
    std::uint64_t corners = (passed(a) | passed(b)) & ~a & ~b & kBits;
    const unsigned last = ends == 0 ? kNew + 1 : first(ends);
    for (; corners != 0 && first(corners) < last; corners &= ~bit(first(corners))) {
      const unsigned i = first(corners);
      turn(static_cast<int>(steps + i) - 1, (a & bit(i - 1)) != 0);
    }
    if (ends != 0) return;
  }
}

}  // namespace alate
