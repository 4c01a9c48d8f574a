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
  level.ranges.reserve(level.columns * level.rows);
  // A post on the border of two blocks belongs to both.
  for (std::size_t j = 0; j < level.rows; ++j) {
    const std::size_t row_end = std::min((j + 1) * kBlock, cell_rows);
    for (std::size_t i = 0; i < level.columns; ++i) {
      const std::size_t column_end = std::min((i + 1) * kBlock, cell_columns);
      Range range = kNothing;
      bool unknown = false;
      for (std::size_t row = j * kBlock; row <= row_end; ++row)
        for (std::size_t column = i * kBlock; column <= column_end; ++column) {
          const float post = raster.posts[row * (cell_columns + 1) + column];
          unknown |= std::isnan(post);
          range.low = std::min(range.low, post);
          range.high = std::max(range.high, post);
        }
      level.ranges.push_back(unknown ? Range{-kInfinity, kInfinity} : range);
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
