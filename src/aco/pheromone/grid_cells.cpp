#include "aco/pheromone/grid_cells.hpp"

#include <bit>
#include <cmath>

#include "space/simd.hpp"

namespace alate {

std::optional<GridCells> GridCells::over(const ReachBox& box, float cell_m) {
  GridCells grid;
  double count = 1;
  const auto axis = [&](int i) {
    const float cells = std::ceil((box.max[i] - box.min[i]) / cell_m) + 1;
    count *= static_cast<double>(cells);
    return Layout::Axis{.from = box.min[i], .per_cell = 1 / cell_m, .last = cells - 1};
  };
  Layout& layout = grid.layout_;
  layout.x = axis(0);
  layout.y = axis(1);
  layout.z = axis(2);
  if (!(count * sizeof(StoredTrail) <= kMostBytes)) return std::nullopt;
  layout.columns = static_cast<std::int32_t>(layout.x.last) + 1;
  layout.layer = layout.columns * (static_cast<std::int32_t>(layout.y.last) + 1);
  grid.cells_ = zeroed(static_cast<std::size_t>(count));  // all bits zero is an unknown cell
  if (!grid.cells_) return std::nullopt;
  return grid;
}

ALATE_SIMD void GridCells::find_all(Choices& choices) const {
  // The indices wait where the levels will be: read from memory one by one, they come sooner than out of registers.
  const auto name_cell = [layout = layout_](float& trail, float x, float y, float z) {
    trail = std::bit_cast<float>(layout.index(x, y, z));
  };
  for_each_lane(name_cell, choices.trail, choices.x, choices.y, choices.z);
  const StoredTrail* const cells = cells_.get();
  for (float& trail : choices.trail) trail = cells[std::bit_cast<std::uint32_t>(trail)];
}

}  // namespace alate
