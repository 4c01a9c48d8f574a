#include "out/report/grid_layer.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace alate {

namespace {

constexpr int kMostPixels = 1500;  ///< Along a side.
constexpr Rgb kBlocked{62, 66, 74};
constexpr Rgb kFlat{214, 214, 190};
constexpr Rgb kOpen{240, 240, 236};

/// A square of cells that share a pixel.
struct Block {
  int column = 0;
  int row = 0;
  int side = 1;
};

template <class Act>
void for_each_cell(const HeightGrid& grid, const Block& block, const Act& act) {
  for (int row = block.row; row < std::min(block.row + block.side, grid.rows); ++row)
    for (int column = block.column; column < std::min(block.column + block.side, grid.columns); ++column)
      act(column, row);
}

bool is_blocked(const HeightGrid& grid, const Block& block) {
  bool blocked = false;
  for_each_cell(grid, block, [&](int column, int row) { blocked = blocked || grid.blocked_at(column, row); });
  return blocked;
}

/// NaN if none has a height.
double highest(const HeightGrid& grid, const Block& block) {
  double high = std::numeric_limits<double>::quiet_NaN();
  for_each_cell(grid, block, [&](int column, int row) { high = std::fmax(high, grid.height_at(column, row)); });
  return high;
}

/// Tints are for free cells: mountains that bar the way would leave few for them.
std::vector<float> free_heights(const HeightGrid& grid) {
  std::vector<float> heights;
  for (std::size_t i = 0; i < grid.height_m.size(); ++i)
    if (grid.blocked[i] == 0) heights.push_back(grid.height_m[i]);
  return heights;
}

std::uint8_t tint_of(double height, const std::vector<HeightBand>& bands) {
  const auto above = std::ranges::find_if(bands, [&](const HeightBand& band) { return height < band.to_m; });
  return static_cast<std::uint8_t>(std::min(above, bands.end() - 1) - bands.begin());
}

/// One pixel a cell, or for as many as are needed on large maps.
template <class Color>
void fill(IndexedImage& image, const HeightGrid& grid, const Color& color) {
  const int side = (std::max(grid.columns, grid.rows) + kMostPixels - 1) / kMostPixels;
  image.columns = (grid.columns + side - 1) / side;
  image.rows = (grid.rows + side - 1) / side;
  for (int row = 0; row < grid.rows; row += side)
    for (int column = 0; column < grid.columns; column += side)
      image.pixels.push_back(color(Block{.column = column, .row = row, .side = side}));
}

}  // namespace

Hillshade grid_picture(const HeightGrid& grid) {
  Hillshade result;
  result.bands = height_bands(free_heights(grid));
  std::vector<Rgb>& palette = result.image.palette;
  for (const HeightBand& band : result.bands) palette.push_back(band.color);
  if (palette.empty()) palette.push_back(kFlat);
  const auto blocked = static_cast<std::uint8_t>(palette.size());
  palette.push_back(kBlocked);
  fill(result.image, grid, [&](const Block& block) {
    if (is_blocked(grid, block)) return blocked;
    return result.bands.empty() ? std::uint8_t{0} : tint_of(grid.height_at(block.column, block.row), result.bands);
  });
  return result;
}

HeightGrid seen_from_above(const VoxelGrid& voxels) {
  HeightGrid tops{.columns = voxels.size()[0], .rows = voxels.size()[1], .cell_m = voxels.cell_m};
  tops.blocked.resize(static_cast<std::size_t>(tops.columns) * static_cast<std::size_t>(tops.rows));
  tops.height_m.assign(tops.blocked.size(), std::numeric_limits<float>::quiet_NaN());
  voxels.for_each_blocked([&](const VoxelCell& cell) {
    float& top = tops.height_m[tops.index(cell[0], tops.rows - 1 - cell[1])];
    top = std::fmax(top, static_cast<float>((cell[2] + 1) * voxels.cell_m));
  });
  return tops;
}

Hillshade voxel_picture(const HeightGrid& tops) {
  Hillshade result;
  result.bands = height_bands(tops.height_m);
  for (const HeightBand& band : result.bands) result.image.palette.push_back(band.color);
  const auto open = static_cast<std::uint8_t>(result.image.palette.size());
  result.image.palette.push_back(kOpen);
  fill(result.image, tops, [&](const Block& block) {
    const double top = highest(tops, block);
    return std::isnan(top) ? open : tint_of(top, result.bands);
  });
  return result;
}

void draw_grid(Svg& svg, const MapFrame& map, const HeightGrid& grid, const Hillshade& picture) {
  constexpr double kLeastCell = 12;
  const Box2 area = grid.area();
  const Vec2 upper_left = map(Vec2(area.min.x(), area.max.y()));
  const Vec2 size = (area.max - area.min) * map.units_per_metre();
  svg.image(upper_left, size, to_png(picture.image), "relief cells");
  const double cell = grid.cell_m * map.units_per_metre();
  if (cell >= kLeastCell) {
    for (int column = 1; column < grid.columns; ++column)
      svg.line(upper_left + Vec2{column * cell, 0}, upper_left + Vec2{column * cell, size.y()}, "cell");
    for (int row = 1; row < grid.rows; ++row)
      svg.line(upper_left + Vec2{0, row * cell}, upper_left + Vec2{size.x(), row * cell}, "cell");
  }
  svg.rect(upper_left, size, "edge");
}

}  // namespace alate
