#include "aco/pheromone/grid_cells.hpp"

#include <cmath>

#include "space/simd.hpp"

namespace alate {

namespace {

inline std::int32_t index_along(float value, float from, float per_cell, float last) {
  const float cell = (value - from) * per_cell;
  const float above = cell > 0 ? cell : 0;
  return static_cast<std::int32_t>(above < last ? above : last);
}

}  // namespace

std::optional<GridCells> GridCells::over(const ReachBox& box, float cell_m) {
  GridCells grid;
  double count = 1;
  const auto axis = [&](int i) {
    const float cells = std::ceil((box.max[i] - box.min[i]) / cell_m) + 1;
    count *= static_cast<double>(cells);
    return Axis{.from = box.min[i], .per_cell = 1 / cell_m, .last = cells - 1};
  };
  grid.x_ = axis(0);
  grid.y_ = axis(1);
  grid.z_ = axis(2);
  if (!(count * sizeof(StoredTrail) <= kMostBytes)) return std::nullopt;
  grid.columns_ = static_cast<std::int32_t>(grid.x_.last) + 1;
  grid.layer_ = grid.columns_ * (static_cast<std::int32_t>(grid.y_.last) + 1);
  grid.cells_ = zeroed(static_cast<std::size_t>(count));  // all bits zero is an unknown cell
  if (!grid.cells_) return std::nullopt;
  return grid;
}

ALATE_SIMD void GridCells::name(Choices& choices) const {
  const std::size_t count = choices.key.size() & ~std::size_t{15};
  const auto* __restrict x = static_cast<const float*>(__builtin_assume_aligned(choices.x.data(), kSimdBytes));
  const auto* __restrict y = static_cast<const float*>(__builtin_assume_aligned(choices.y.data(), kSimdBytes));
  const auto* __restrict z = static_cast<const float*>(__builtin_assume_aligned(choices.z.data(), kSimdBytes));
  auto* __restrict key = static_cast<TrailKey*>(__builtin_assume_aligned(choices.key.data(), kSimdBytes));
  const Axis ax = x_;
  const Axis ay = y_;
  const Axis az = z_;
  const std::int32_t columns = columns_;
  const std::int32_t layer = layer_;
  for (std::size_t k = 0; k < count; ++k) {
    const std::int32_t index = index_along(x[k], ax.from, ax.per_cell, ax.last) +
                               columns * index_along(y[k], ay.from, ay.per_cell, ay.last) +
                               layer * index_along(z[k], az.from, az.per_cell, az.last);
    key[k] = static_cast<std::uint32_t>(index);
  }
}

TrailKey GridCells::name(float x, float y, float z) const {
  const std::int32_t index = index_along(x, x_.from, x_.per_cell, x_.last) +
                             columns_ * index_along(y, y_.from, y_.per_cell, y_.last) +
                             layer_ * index_along(z, z_.from, z_.per_cell, z_.last);
  return static_cast<std::uint32_t>(index);
}

}  // namespace alate
