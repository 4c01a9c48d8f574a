// Lowest and highest post of square blocks of cells, coarser and coarser.
#pragma once

#include <vector>

#include "alate/data/height_raster.hpp"

namespace alate {

/// Level n >= 1 has blocks of kBlock^n x kBlock^n cells; level 0 are the cells themselves and is not kept.
/// Built in one pass over the posts and a third of that for the levels above.
class HeightPyramid {
 public:
  static constexpr int kShift = 2;  ///< log2 of how much coarser each level is.

  /// Heights of a block with its border posts. Unknown ground reaches from -infinity to +infinity.
  struct Range {
    float low = 0;
    float high = 0;
  };

  explicit HeightPyramid(const HeightRaster& raster);

  /// Coarsest level; 0 for a raster too small to have any.
  int top() const { return static_cast<int>(levels_.size()); }

  /// Range of the block of `level` >= 1 that holds a cell.
  const Range& block(int level, int column, int row) const {
    const Level& blocks = levels_[static_cast<std::size_t>(level - 1)];
    const int shift = kShift * level;
    return blocks
        .ranges[static_cast<std::size_t>(row >> shift) * blocks.columns + static_cast<std::size_t>(column >> shift)];
  }

 private:
  struct Level {
    std::size_t columns = 0;
    std::size_t rows = 0;
    std::vector<Range> ranges;
  };
  static Level finest(const HeightRaster& raster);
  static Level coarser(const Level& fine);

  std::vector<Level> levels_;
};

}  // namespace alate
