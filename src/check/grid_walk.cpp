#include "check/grid_walk.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "alate/check/check.hpp"
#include "check/height_range.hpp"

namespace alate {

namespace {

/// The cells along one axis that hold `coordinate` (cell sides): one, or the two beside a grid line.
struct Range1 {
  int first = 0;
  int last = 0;
};

Range1 cells_at(double coordinate, double slack) {
  const double line = std::round(coordinate);
  if (std::abs(coordinate - line) <= slack) return {static_cast<int>(line) - 1, static_cast<int>(line)};
  const int cell = static_cast<int>(std::floor(coordinate));
  return {cell, cell};
}

/// One axis of a flight.
struct Axis {
  double from;
  double to;
};

/// Adds the distances from the begin of a flight of `length` at which it crosses grid lines of one axis.
void add_crossings(const Axis& axis, double length, double cell_m, std::vector<double>& crossings) {
  const auto [a, b] = axis;
  if (a == b) return;
  const auto [low, high] = std::minmax(a, b);
  const int last = static_cast<int>(std::floor(high / cell_m));
  for (int line = static_cast<int>(std::ceil(low / cell_m)); line <= last; ++line)
    crossings.push_back(std::clamp((line * cell_m - a) / (b - a), 0.0, 1.0) * length);
}

bool is_free(const HeightGrid& grid, const GridCell& cell) {
  return grid.contains(cell.column, cell.row) && !grid.blocked_at(cell.column, cell.row);
}

bool connects(const HeightGrid& grid, const GridCell& from, const GridCell& to) {
  if (!is_free(grid, from) || !is_free(grid, to)) return false;
  const int across = std::abs(from.column - to.column);
  const int along = std::abs(from.row - to.row);
  if (across > 1 || along > 1) return false;
  if (across + along < 2) return true;
  return is_free(grid, {from.column, to.row}) && is_free(grid, {to.column, from.row});
}

std::span<const GridCell> cells_of(const Stretch& stretch) { return {stretch.cells.data(), stretch.count}; }

}  // namespace

Stretch GridPassage::stretch(const Vec2& begin, const Vec2& end) const {
  const Vec2 middle = (begin + end) / 2;
  Stretch result{.begin = grid_.origin + begin, .middle = grid_.origin + middle};
  const Vec2 farthest(grid_.columns + 2, grid_.rows + 2);
  const Vec2 place = (middle / grid_.cell_m).cwiseMax(-2).cwiseMin(farthest);
  const double slack = kRoundingNoise / grid_.cell_m;
  const Range1 columns = cells_at(place.x(), slack);
  const Range1 rows = cells_at(place.y(), slack);
  for (int column = columns.first; column <= columns.last; ++column) {
    for (int row = rows.first; row <= rows.last; ++row)
      result.cells.at(result.count++) = {.column = column, .row = grid_.rows - 1 - row};
  }
  return result;
}

std::vector<Stretch> GridPassage::advance(const Vec2& place) {
  const Vec2 to = place - grid_.origin;
  if ((to - at_).norm() <= kRoundingNoise) return {};
  const Vec2 margin = Vec2::Constant(grid_.cell_m);
  const Vec2 size = Vec2(grid_.columns, grid_.rows) * grid_.cell_m;
  const auto part = clipped({Vec3(at_.x(), at_.y(), 0), Vec3(to.x(), to.y(), 0)}, {-margin, size + margin});
  at_ = to;
  if (!part) return {};
  const Vec2 a = part->a.head<2>();
  const Vec2 b = part->b.head<2>();
  const double length = (b - a).norm();
  std::vector<double> crossings;
  add_crossings({a.x(), b.x()}, length, grid_.cell_m, crossings);
  add_crossings({a.y(), b.y()}, length, grid_.cell_m, crossings);
  std::ranges::sort(crossings);
  crossings.push_back(length);
  std::vector<Stretch> stretches;
  double begin = 0;
  for (const double end : crossings) {
    if (end - begin <= kRoundingNoise) continue;
    stretches.push_back(stretch(a + (b - a) * (begin / length), a + (b - a) * (end / length)));
    begin = end;
  }
  return stretches;
}

const GridCell* free_cell(const HeightGrid& grid, const Stretch& stretch) {
  const auto cells = cells_of(stretch);
  const auto found = std::ranges::find_if(cells, [&](const GridCell& cell) { return is_free(grid, cell); });
  return found == cells.end() ? nullptr : &*found;
}

bool is_blocked(const HeightGrid& grid, const Stretch& stretch) {
  const auto inside = [&](const GridCell& cell) { return grid.contains(cell.column, cell.row); };
  return free_cell(grid, stretch) == nullptr && std::ranges::any_of(cells_of(stretch), inside);
}

bool connects(const HeightGrid& grid, const Stretch& from, const Stretch& to) {
  return std::ranges::any_of(cells_of(from), [&](const GridCell& a) {
    return std::ranges::any_of(cells_of(to), [&](const GridCell& b) { return connects(grid, a, b); });
  });
}

}  // namespace alate
