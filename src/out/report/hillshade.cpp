#include "out/report/hillshade.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "out/report/axis.hpp"

namespace alate {

namespace {

constexpr int kTints = 8;
constexpr int kShades = 31;
constexpr std::uint8_t kUnknown = kTints * kShades;
constexpr std::uint8_t kUnknownStripe = kUnknown + 1;

/// From valley to summit; muted, so that what is drawn over them stands out. Lightness alone tells them apart.
constexpr std::array<Rgb, kTints> kTintColors{{{168, 190, 160},
                                               {188, 204, 168},
                                               {208, 214, 176},
                                               {224, 219, 182},
                                               {229, 212, 176},
                                               {222, 198, 168},
                                               {226, 211, 196},
                                               {243, 240, 236}}};

/// Heights on a grid of pixel centres, row 0 in the north; NaN where unknown.
struct Grid {
  int columns = 0;
  int rows = 0;
  double pixel_m = 0;
  std::vector<float> heights;

  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column);
  }
  /// Nearest pixel of the grid.
  float at(int column, int row) const {
    return heights[index(std::clamp(column, 0, columns - 1), std::clamp(row, 0, rows - 1))];
  }
};

Grid sample(const Site& site, const Box2& area, int columns) {
  const Vec2 size = area.max - area.min;
  double pixel = size.x() / columns;
  if (const auto* raster = std::get_if<HeightRaster>(&site.ground)) pixel = std::max(pixel, raster->cell_m / 2);
  Grid grid;
  grid.columns = std::max(2, static_cast<int>(std::round(size.x() / pixel)));
  grid.pixel_m = size.x() / grid.columns;
  grid.rows = std::max(2, static_cast<int>(std::round(size.y() / grid.pixel_m)));
  grid.heights.reserve(static_cast<std::size_t>(grid.columns) * static_cast<std::size_t>(grid.rows));
  for (int row = 0; row < grid.rows; ++row) {
    const double y = area.max.y() - (row + 0.5) * size.y() / grid.rows;
    for (int column = 0; column < grid.columns; ++column) {
      const auto height = site.ground_height({area.min.x() + (column + 0.5) * grid.pixel_m, y});
      grid.heights.push_back(static_cast<float>(height.value_or(std::numeric_limits<double>::quiet_NaN())));
    }
  }
  return grid;
}

/// Slopes towards east and north at a pixel, zero beside unknown ground.
struct Slope {
  double east = 0;
  double north = 0;
};

Slope slope_at(const Grid& grid, int column, int row) {
  const double east = static_cast<double>(grid.at(column + 1, row) - grid.at(column - 1, row)) / (2 * grid.pixel_m);
  const double north = static_cast<double>(grid.at(column, row - 1) - grid.at(column, row + 1)) / (2 * grid.pixel_m);
  return {std::isfinite(east) ? east : 0, std::isfinite(north) ? north : 0};
}

/// How much to stretch heights so that a mean slope looks like one of 17 degrees.
double exaggeration(const Grid& grid) {
  constexpr double kPleasantSlope = 0.3;
  double sum = 0;
  int count = 0;
  for (int row = 0; row < grid.rows; row += 4) {
    for (int column = 0; column < grid.columns; column += 4) {
      const Slope slope = slope_at(grid, column, row);
      sum += std::hypot(slope.east, slope.north);
      ++count;
    }
  }
  return sum > 0 ? std::clamp(kPleasantSlope * count / sum, 1.0, 8.0) : 1;
}

/// Cosine of the angle between the ground and the sun, 0.71 on flat land.
double brightness(const Slope& slope, double stretch) {
  constexpr double kSunUp = 0.70710678;
  constexpr double kSunSide = 0.5;  // towards north and towards west
  const double east = stretch * slope.east;
  const double north = stretch * slope.north;
  const double facing = kSunUp + kSunSide * east - kSunSide * north;
  return std::max(0.0, facing / std::sqrt(1 + east * east + north * north));
}

std::vector<Rgb> make_palette() {
  std::vector<Rgb> palette;
  for (const Rgb& tint : kTintColors) {
    for (int shade = 0; shade < kShades; ++shade) {
      const double factor = 0.45 + 0.75 * shade / (kShades - 1);
      Rgb color{};
      for (std::size_t i = 0; i < color.size(); ++i)
        color[i] = static_cast<std::uint8_t>(std::min(255.0, std::round(factor * tint[i])));
      palette.push_back(color);
    }
  }
  palette.push_back({178, 180, 184});
  palette.push_back({150, 153, 158});
  return palette;
}

}  // namespace

std::vector<HeightBand> height_bands(std::span<const float> heights) {
  float low = std::numeric_limits<float>::infinity();
  float high = -low;
  for (const float height : heights) {
    if (std::isnan(height)) continue;
    low = std::min(low, height);
    high = std::max(high, height);
  }
  if (low > high) return {};
  const double step = round_step(std::max(1.0, static_cast<double>(high - low) / kTints));
  const double base = std::floor(static_cast<double>(low) / step) * step;
  std::vector<HeightBand> bands;
  for (int i = 0; i < kTints && base + i * step <= static_cast<double>(high); ++i)
    bands.push_back({base + i * step, base + (i + 1) * step, kTintColors[static_cast<std::size_t>(i)]});
  return bands;
}

Hillshade hillshade(const Site& site, const Box2& area, int columns) {
  const Grid grid = sample(site, area, columns);
  Hillshade result;
  result.bands = height_bands(grid.heights);
  result.image = {.columns = grid.columns, .rows = grid.rows, .palette = make_palette()};
  result.image.pixels.reserve(grid.heights.size());
  const double stretch = exaggeration(grid);
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      const auto height = static_cast<double>(grid.at(column, row));
      if (std::isnan(height)) {
        result.has_unknown = true;
        result.image.pixels.push_back((row + column) % 8 < 2 ? kUnknownStripe : kUnknown);
        continue;
      }
      const HeightBand& first = result.bands.front();
      const int tint =
          std::clamp(static_cast<int>((height - first.from_m) / (first.to_m - first.from_m)), 0, kTints - 1);
      const double light = std::min(1.0, brightness(slope_at(grid, column, row), stretch));
      const int shade = static_cast<int>(std::round(light * (kShades - 1)));
      result.image.pixels.push_back(static_cast<std::uint8_t>(tint * kShades + shade));
    }
  }
  return result;
}

std::string height_key(const Hillshade& ground, const char* title) {
  std::string items;
  for (const HeightBand& band : ground.bands)
    items += fmt::format("<span class=\"tint\" style=\"background:rgb({},{},{})\">{:.0f}</span>", band.color[0],
                         band.color[1], band.color[2], band.from_m);
  return fmt::format("<li class=\"tints\">{}{}</li>\n", title, items);
}

}  // namespace alate
