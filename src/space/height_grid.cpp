#include "space/height_grid.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>

namespace alate {

namespace {

constexpr std::array<std::array<int, 2>, GridSpace::kDirections> kShifts{
    {{1, 0}, {1, -1}, {0, -1}, {-1, -1}, {-1, 0}, {-1, 1}, {0, 1}, {1, 1}}};

/// Of values, (n - 1) normalisation.
double standard_deviation(const std::vector<double>& values) {
  if (values.size() < 2) return 0;
  const auto count = static_cast<double>(values.size());
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / count;
  double sum = 0;
  for (const double value : values) sum += (value - mean) * (value - mean);
  return std::sqrt(sum / (count - 1));
}

}  // namespace

std::array<int, 2> GridSpace::shift(unsigned direction) { return kShifts[direction]; }

GridSpace::GridSpace(const HeightGrid& grid, const Ends& ends, double diagonal, const GridScore& score)
    : grid_(grid), score_(score), diagonal_(diagonal), stride_(static_cast<std::uint32_t>(grid.columns) + 2) {
  const auto number = [this](int column, int row) {
    return static_cast<Cell>(row + 1) * stride_ + static_cast<Cell>(column + 1);
  };
  start_ = number(ends.start_column, ends.start_row);
  goal_ = number(ends.goal_column, ends.goal_row);
  std::ranges::transform(kShifts, offsets_.begin(), [this](const std::array<int, 2>& shift) {
    return shift[0] + shift[1] * static_cast<std::int32_t>(stride_);
  });
  const std::size_t count = std::size_t{stride_} * (static_cast<std::size_t>(grid.rows) + 2);
  open_.resize(count);
  for (AlignedFloats* array : {&to_goal_, &from_start_, &height_}) array->resize(count);
  note_heights();
  note_moves();
}

void GridSpace::note_heights() {
  const auto apart = [this](Cell a, Cell b) {
    return static_cast<float>(std::hypot(column(a) - column(b), row(a) - row(b)));
  };
  for (Cell cell = 0; cell < cells(); ++cell) {
    to_goal_[cell] = apart(cell, goal_);
    from_start_[cell] = apart(start_, cell);
    if (grid_.contains(column(cell), row(cell)))
      height_[cell] = static_cast<float>(grid_.height_at(column(cell), row(cell)));
  }
}

void GridSpace::note_moves() {
  const auto is_free = [this](Cell cell) {
    return grid_.contains(column(cell), row(cell)) && !grid_.blocked_at(column(cell), row(cell));
  };
  for (Cell cell = 0; cell < cells(); ++cell) {
    if (!is_free(cell)) continue;
    unsigned sides = 0;
    for (unsigned d = 0; d < kDirections; ++d)
      if (is_free(neighbour(cell, d))) sides |= 1U << d;
    const unsigned straight = sides & 0x55U;
    const unsigned beside = (straight << 1U) & ((straight >> 1U) | ((straight & 1U) << 7U));
    open_[cell] = static_cast<std::uint8_t>(straight | (sides & beside & 0xAAU));
  }
}

double GridSpace::octile(Cell a, Cell b) const {
  const int across = std::abs(column(a) - column(b));
  const int along = std::abs(row(a) - row(b));
  const auto both = static_cast<std::size_t>(std::min(across, along));
  return length(static_cast<std::size_t>(std::max(across, along)), both);
}

GridMeasures GridSpace::measure(std::span<const std::uint32_t> directions) const {
  const auto diagonals = std::ranges::count_if(directions, [](std::uint32_t d) { return d % 2 == 1; });
  std::size_t turns = 0;
  for (std::size_t i = 1; i < directions.size(); ++i) turns += directions[i] != directions[i - 1] ? 1U : 0U;
  return {.length_cells = length(directions.size(), static_cast<std::size_t>(diagonals)),
          .height_deviation_m = deviation(directions),
          .turns = turns};
}

double GridSpace::score(std::span<const std::uint32_t> directions) const {
  const GridMeasures m = measure(directions);
  return score_.length * m.length_cells + score_.height_dev * m.height_deviation_m +
         score_.turns * static_cast<double>(m.turns);
}

/// As meant, or as coded [C]: the first n cells of the height matrix in column order, n cells on the route.
double GridSpace::deviation(std::span<const std::uint32_t> directions) const {
  std::vector<double> heights;
  if (score_.heights_of == GridScore::HeightsOf::matrix) {
    const int count = grid_.columns * grid_.rows;
    for (int i = 0; i < count && heights.size() <= directions.size(); ++i) {
      const double height = grid_.height_at(i / grid_.rows, i % grid_.rows);
      if (!std::isnan(height)) heights.push_back(height);
    }
    return standard_deviation(heights);
  }
  Cell cell = start_;
  heights.push_back(double{height(cell)});
  for (const std::uint32_t d : directions) heights.push_back(double{height(cell = neighbour(cell, d))});
  return standard_deviation(heights);
}

std::optional<FlownActions> GridSpace::fly(std::span<const std::uint32_t> directions) const {
  FlownActions flight;
  flight.moves = directions.size();
  Cell cell = start_;
  for (const std::uint32_t d : directions) {
    if (((std::uint32_t{open_[cell]} >> d) & 1U) == 0) return std::nullopt;
    cell = neighbour(cell, d);
    flight.costs.push_back(static_cast<float>(step(d)));
  }
  if (cell != goal_) return std::nullopt;
  flight.cost = score(directions);
  return flight;
}

std::vector<std::uint8_t> GridSpace::flood(Cell from) const {
  std::vector<std::uint8_t> reached(cells());
  std::vector<Cell> front{from};
  reached[from] = 1;
  while (!front.empty()) {
    const Cell cell = front.back();
    front.pop_back();
    for (unsigned free = open_[cell]; free != 0; free &= free - 1) {
      const Cell next = neighbour(cell, static_cast<unsigned>(std::countr_zero(free)));
      if (reached[next] == 0) front.push_back(next);
      reached[next] = 1;
    }
  }
  return reached;
}

}  // namespace alate
