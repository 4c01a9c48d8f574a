// Grids and heights that are drawn or computed, not read.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "alate/core/scenario.hpp"
#include "alate/data/height_grid.hpp"

namespace alate {

/// A flat grid of cells 1 m wide, each blocked with probability `spec.obstacles`, independently, `start` and `goal`
/// (column, row) never: the law of the 30 x 30 map behind Yin et al. 2021. The same spec gives the same bits, and start
/// and goal change no other cell.
HeightGrid draw_grid(const RandomGridSpec& spec, const std::optional<std::array<int, 2>>& start,
                     const std::optional<std::array<int, 2>>& goal);

/// Heights, row-major: H[r][c] = |p(g_rows[rows - 1 - r], g_columns[c])|, MATLAB's peaks
///   p(x, y) = 3 (1-x)^2 exp(-x^2 - (y+1)^2) - 10 (x/5 - x^3 - y^5) exp(-x^2 - y^2) - 1/3 exp(-(x+1)^2 - y^2)
/// with g_n n equal steps from -3 to 3 (0 for n = 1): the absolute value of peaks(N), rotated by 90 degrees
/// counter-clockwise, as the maps of Yin et al. 2021 have it. Grids that are not square are an extension of ours.
std::vector<float> peak_heights(int columns, int rows);

}  // namespace alate
