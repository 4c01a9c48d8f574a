#include "data/grid_law.hpp"

#include <cmath>

#include "alate/core/stream.hpp"

namespace alate {

namespace {

double peaks(double x, double y) {
  const double xx = x * x;
  const double yy = y * y;
  return 3 * (1 - x) * (1 - x) * std::exp(-xx - (y + 1) * (y + 1)) -
         10 * (x / 5 - xx * x - yy * yy * y) * std::exp(-xx - yy) - std::exp(-(x + 1) * (x + 1) - yy) / 3;
}

/// The step `index` of `count` from -3 to 3.
double step_of(int index, int count) { return count > 1 ? 6.0 * index / (count - 1) - 3 : 0; }

}  // namespace

HeightGrid draw_grid(const RandomGridSpec& spec, const std::optional<std::array<int, 2>>& start,
                     const std::optional<std::array<int, 2>>& goal) {
  HeightGrid grid{.columns = spec.size[0], .rows = spec.size[1]};
  grid.blocked.resize(static_cast<std::size_t>(grid.columns) * static_cast<std::size_t>(grid.rows));
  Stream stream(static_cast<std::uint64_t>(spec.seed), 0, 0);
  for (std::uint8_t& cell : grid.blocked) cell = stream.uniform() < spec.obstacles ? 1 : 0;
  for (const auto& end : {start, goal}) {
    if (end && grid.contains((*end)[0], (*end)[1])) grid.blocked[grid.index((*end)[0], (*end)[1])] = 0;
  }
  return grid;
}

std::vector<float> peak_heights(int columns, int rows) {
  std::vector<float> heights;
  heights.reserve(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
  for (int row = 0; row < rows; ++row) {
    const double x = step_of(rows - 1 - row, rows);
    for (int column = 0; column < columns; ++column)
      heights.push_back(static_cast<float>(std::abs(peaks(x, step_of(column, columns)))));
  }
  return heights;
}

}  // namespace alate
