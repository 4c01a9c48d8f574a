#include "world/height_pyramid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace alate {

namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr HeightPyramid::Range kNothing{kInfinity, -kInfinity};
constexpr std::size_t kBlock = std::size_t{1} << HeightPyramid::kShift;

void include(HeightPyramid::Range& range, const HeightPyramid::Range& other) {
  range.low = std::min(range.low, other.low);
  range.high = std::max(range.high, other.high);
}

std::size_t blocks_for(std::size_t cells) { return (cells + kBlock - 1) / kBlock; }

}  // namespace

HeightPyramid::Level HeightPyramid::finest(const HeightRaster& raster) {
  const auto cell_columns = static_cast<std::size_t>(raster.columns - 1);
  const auto cell_rows = static_cast<std::size_t>(raster.rows - 1);
  Level level{blocks_for(cell_columns), blocks_for(cell_rows), {}};
  level.ranges.assign(level.columns * level.rows, kNothing);
  for (std::size_t row = 0; row <= cell_rows; ++row) {
    for (std::size_t column = 0; column <= cell_columns; ++column) {
      const float post = raster.posts[row * (cell_columns + 1) + column];
      const Range range = std::isnan(post) ? Range{-kInfinity, kInfinity} : Range{post, post};
      // A post on the border of two blocks belongs to both.
      for (std::size_t j = (row == 0 ? 0 : row - 1) / kBlock; j <= std::min(row / kBlock, level.rows - 1); ++j)
        for (std::size_t i = (column == 0 ? 0 : column - 1) / kBlock; i <= std::min(column / kBlock, level.columns - 1);
             ++i)
          include(level.ranges[j * level.columns + i], range);
    }
  }
  return level;
}

HeightPyramid::Level HeightPyramid::coarser(const Level& fine) {
  Level level{blocks_for(fine.columns), blocks_for(fine.rows), {}};
  level.ranges.assign(level.columns * level.rows, kNothing);
  for (std::size_t j = 0; j < fine.rows; ++j)
    for (std::size_t i = 0; i < fine.columns; ++i)
      include(level.ranges[(j / kBlock) * level.columns + i / kBlock], fine.ranges[j * fine.columns + i]);
  return level;
}

HeightPyramid::HeightPyramid(const HeightRaster& raster) {
  levels_.push_back(finest(raster));
  while (levels_.back().ranges.size() > 1) levels_.push_back(coarser(levels_.back()));
}

}  // namespace alate
