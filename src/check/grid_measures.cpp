#include "check/grid_measures.hpp"

#include <cmath>
#include <numeric>
#include <optional>

#include "check/cell_passage.hpp"
#include "check/leg_shape.hpp"

namespace alate {

namespace {

constexpr double kSameDirection = 1e-6;  ///< rad

std::vector<double> heights_of(const HeightGrid& grid, const Route& route) {
  const FlatCells map{grid};
  std::vector<double> heights;
  std::optional<CellAt<2>> last;
  const auto pass = [&](const Stretch<2>& stretch) {
    const CellAt<2>* free = free_cell(map, stretch);
    const CellAt<2>& cell = free == nullptr ? stretch.held.front() : *free;
    if (!map.contains(cell) || last == cell) return;
    last = cell;
    heights.push_back(grid.height_at(cell[0], map.row(cell)));
  };
  CellPassage walk(map, route.states.front().position.head<2>());
  for (std::size_t i = 1; i < route.states.size(); ++i) {
    for (const Segment& piece : straight_pieces(route, i)) {
      for (const Stretch<2>& stretch : walk.advance(piece.b.head<2>())) pass(stretch);
    }
  }
  return heights;
}

double deviation(const std::vector<double>& values) {
  if (values.size() < 2) return 0;
  const auto count = static_cast<double>(values.size());
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / count;
  const auto square = [&](double sum, double value) { return sum + (value - mean) * (value - mean); };
  return std::sqrt(std::accumulate(values.begin(), values.end(), 0.0, square) / (count - 1));
}

std::size_t turns_of(const Route& route) {
  std::size_t turns = 0;
  std::optional<Vec3> before;
  for (std::size_t i = 1; i < route.states.size(); ++i) {
    if (length_of_leg(route, i) <= 0) continue;
    if (before && turn_between(*before, first_direction(route, i)) > kSameDirection) ++turns;
    before = last_direction(route, i);
  }
  return turns;
}

}  // namespace

GridMeasures grid_measures(const HeightGrid& grid, const Route& route) {
  double length = 0;
  for (std::size_t i = 1; i < route.states.size(); ++i) length += length_of_leg(route, i);
  return {.length_cells = length / grid.cell_m,
          .height_deviation_m = deviation(heights_of(grid, route)),
          .turns = turns_of(route)};
}

}  // namespace alate
