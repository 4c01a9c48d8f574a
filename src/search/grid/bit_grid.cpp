#include "search/grid/bit_grid.hpp"

namespace alate {

namespace {

/// Moves from the middle of nine cells.
constexpr std::uint8_t moves_among(unsigned blocked) {
  constexpr std::array<unsigned, BitGrid::kDirections> kBits{5, 2, 1, 0, 3, 6, 7, 8};
  constexpr unsigned kMiddle = 4;
  if (((blocked >> kMiddle) & 1U) != 0) return 0;
  const auto is_free = [&](unsigned d) { return ((blocked >> kBits.at(d % BitGrid::kDirections)) & 1U) == 0; };
  unsigned moves = 0;
  for (unsigned d = 0; d < BitGrid::kDirections; ++d) {
    const bool open = d % 2 == 0 || (is_free(d + 1) && is_free(d + BitGrid::kDirections - 1));
    if (open && is_free(d)) moves |= 1U << d;
  }
  return static_cast<std::uint8_t>(moves);
}

}  // namespace

constexpr std::array<std::uint8_t, 512> BitGrid::moves_ = [] {
  std::array<std::uint8_t, 512> table{};
  for (unsigned blocked = 0; blocked < table.size(); ++blocked) table.at(blocked) = moves_among(blocked);
  return table;
}();

BitLanes::BitLanes(int length, int lanes)
    : stride_((static_cast<Cell>(length) + 2 + 7) / 8 * 8),
      bytes_(std::size_t{stride_} / 8 * (static_cast<std::size_t>(lanes) + 2) + 2 * kPad, 0xFF) {}

BitGrid::BitGrid(const HeightGrid& grid)
    : columns_(grid.columns), rows_(grid.rows), by_row_(grid.columns, grid.rows), by_column_(grid.rows, grid.columns) {
  for (int row = 0; row < rows_; ++row) {
    for (int column = 0; column < columns_; ++column) {
      if (grid.blocked_at(column, row)) continue;
      const GridPlace at = place(column, row);
      by_row_.free(by_row_.cell(at.column, at.row));
      by_column_.free(by_column_.cell(at.row, at.column));
    }
  }
}

}  // namespace alate
