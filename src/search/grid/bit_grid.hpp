// Blocked cells as bits, made for exact search on large maps.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <vector>

#include "alate/data/height_grid.hpp"

namespace alate {

/// Column and row of a cell, counted with the rim: those of the map are 1 to columns, 1 to rows.
struct GridPlace {
  std::uint16_t column = 0;
  std::uint16_t row = 0;

  bool operator==(const GridPlace&) const = default;
};

/// Lanes of bits, 1 is blocked, with a blocked rim around. A lane begins at a whole byte, so that the number of a cell
/// is the number of its bit.
class BitLanes {
 public:
  using Cell = std::uint32_t;
  /// Cells that from() and until() surely show.
  static constexpr unsigned kShown = 57;

  BitLanes(int length, int lanes);

  Cell stride() const { return stride_; }
  std::size_t cells() const { return (bytes_.size() - 2 * kPad) * 8; }
  Cell cell(unsigned along, unsigned lane) const { return lane * stride_ + along; }
  void free(Cell cell) { bytes_[kPad + (cell >> 3U)] &= static_cast<std::uint8_t>(~(1U << (cell & 7U))); }
  bool is_blocked(Cell cell) const { return ((unsigned{bytes_[kPad + (cell >> 3U)]} >> (cell & 7U)) & 1U) != 0; }
  /// Bit 0 is `cell`, bit i the i-th cell behind it.
  std::uint64_t from(Cell cell) const { return word(kPad + (cell >> 3U)) >> (cell & 7U); }
  /// Bit 63 is `cell`, bit 63 - i the i-th cell before it.
  std::uint64_t until(Cell cell) const { return word(kPad + (cell >> 3U) - 7) << (7U - (cell & 7U)); }

 private:
  static constexpr std::size_t kPad = 8;
  static_assert(std::endian::native == std::endian::little, "bits are numbered as words are read");

  std::uint64_t word(std::size_t byte) const {
    std::uint64_t bits = 0;
    std::memcpy(&bits, bytes_.data() + byte, sizeof bits);
    return bits;
  }

  Cell stride_;
  std::vector<std::uint8_t> bytes_;
};

/// The cells of a map by rows and again by columns, as jump point search reads both ways.
class BitGrid {
 public:
  using Cell = BitLanes::Cell;
  static constexpr unsigned kDirections = 8;

  explicit BitGrid(const HeightGrid& grid);

  int columns() const { return columns_; }
  int rows() const { return rows_; }
  /// A lane is a row.
  const BitLanes& by_row() const { return by_row_; }
  /// A lane is a column.
  const BitLanes& by_column() const { return by_column_; }
  /// Of column and row counted from 0, without the rim.
  static GridPlace place(int column, int row) {
    return {static_cast<std::uint16_t>(column + 1), static_cast<std::uint16_t>(row + 1)};
  }
  /// Numbers of cells are below it.
  std::size_t cells() const { return by_row_.cells(); }
  Cell cell(GridPlace place) const { return by_row_.cell(place.column, place.row); }
  bool is_free(GridPlace place) const { return !by_row_.is_blocked(cell(place)); }
  /// Bit d: direction d is free; counter-clockwise from east, odd ones diagonal. A diagonal step needs both cells
  /// beside it free (no corner cutting).
  unsigned moves(Cell cell) const {
    const auto three = [this](Cell west) { return static_cast<unsigned>(by_row_.from(west)) & 7U; };
    const Cell stride = by_row_.stride();
    return moves_[three(cell - 1 - stride) | (three(cell - 1) << 3U) | (three(cell - 1 + stride) << 6U)];
  }

 private:
  static const std::array<std::uint8_t, 512> moves_;  ///< By the nine bits around a cell, upper row first.

  int columns_;
  int rows_;
  BitLanes by_row_;
  BitLanes by_column_;
};

}  // namespace alate
