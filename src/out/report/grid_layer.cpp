#include "out/report/grid_layer.hpp"

#include <algorithm>

namespace alate {

namespace {

constexpr int kMostPixels = 1500;  ///< Along a side.
constexpr Rgb kBlocked{62, 66, 74};
constexpr Rgb kFlat{214, 214, 190};

/// A square of cells that share a pixel.
struct Block {
  int column = 0;
  int row = 0;
  int side = 1;
};

bool is_blocked(const HeightGrid& grid, const Block& block) {
  for (int row = block.row; row < std::min(block.row + block.side, grid.rows); ++row) {
    for (int column = block.column; column < std::min(block.column + block.side, grid.columns); ++column) {
      if (grid.blocked_at(column, row)) return true;
    }
  }
  return false;
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

}  // namespace

Hillshade grid_picture(const HeightGrid& grid) {
  Hillshade result;
  result.bands = height_bands(free_heights(grid));
  auto& [columns, rows, pixels, palette] = result.image;
  for (const HeightBand& band : result.bands) palette.push_back(band.color);
  if (palette.empty()) palette.push_back(kFlat);
  const auto blocked = static_cast<std::uint8_t>(palette.size());
  palette.push_back(kBlocked);
  const int side = (std::max(grid.columns, grid.rows) + kMostPixels - 1) / kMostPixels;
  columns = (grid.columns + side - 1) / side;
  rows = (grid.rows + side - 1) / side;
  for (int row = 0; row < grid.rows; row += side) {
    for (int column = 0; column < grid.columns; column += side) {
      const bool closed = is_blocked(grid, {.column = column, .row = row, .side = side});
      const std::uint8_t free = result.bands.empty() ? 0 : tint_of(grid.height_at(column, row), result.bands);
      pixels.push_back(closed ? blocked : free);
    }
  }
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
