// Lengths of ways on a grid of square cells, exact in whole numbers.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <numbers>

namespace alate {

/// How many straight and diagonal steps a way has.
struct OctileLength {
  std::int64_t straights = 0;
  std::int64_t diagonals = 0;

  /// In cell sides.
  double value() const { return static_cast<double>(straights) + static_cast<double>(diagonals) * std::numbers::sqrt2; }
  bool operator==(const OctileLength&) const = default;
};

/// A whole number that orders lengths a + b sqrt(2) as they are, equal ones only if both counts are.
///
/// kDiagonal / kStraight is a convergent p/q of sqrt(2) (a solution of Pell's equation p^2 - 2 q^2 = +-1), so it is off
/// by less than 1/(2.8 q^2); two different lengths of at most n < q steps are more than 1/(2.9 n) apart, so rounding
/// never changes their order. Ways over grids of at most 16 million cells have fewer steps than that.
using OctileCost = std::uint64_t;
inline constexpr OctileCost kStraight = 38'613'965;
inline constexpr OctileCost kDiagonal = 54'608'393;
inline constexpr unsigned kOctileCostBits = 50;  ///< Enough for 16 million diagonals.
inline constexpr OctileCost kMostOctileCost = (OctileCost{1} << kOctileCostBits) - 1;

/// Of the shortest way were all cells free; a consistent heuristic.
constexpr OctileCost octile(int columns, int rows) {
  const auto across = static_cast<OctileCost>(columns < 0 ? -columns : columns);
  const auto along = static_cast<OctileCost>(rows < 0 ? -rows : rows);
  return kStraight * std::max(across, along) + (kDiagonal - kStraight) * std::min(across, along);
}

}  // namespace alate
