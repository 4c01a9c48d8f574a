#include "aco/transition/move_table.hpp"

#include <array>

namespace alate {

namespace {

constexpr std::size_t kRow = MoveCells::kRow;
using Row = std::array<float, kRow>;

constexpr float kAboveAll = 2;  ///< No draw comes near it.

/// Running sums of weights as shares of all; from the last weight above 0 on they are above any draw.
void sum_up(const float* weights, float* until) {
  Row sums{};
  float sum = 0;
  std::size_t last = 0;
  for (std::size_t d = 0; d < kRow; ++d) {
    sum += weights[d];
    sums[d] = sum;
    last = weights[d] > 0 ? d : last;
  }
  const float share = sum > 0 ? 1 / sum : 0;
  for (std::size_t d = 0; d < kRow; ++d) until[d] = d < last ? sums[d] * share : kAboveAll;
}

}  // namespace

MoveTable::MoveTable(const GridSpace& space, AlignedFloats heuristic, int alpha, double q0)
    : space_(space),
      offsets_(space.offsets()),
      heuristic_(std::move(heuristic)),
      weights_(heuristic_.size()),
      until_(heuristic_.size()),
      alpha_(alpha),
      q0_(static_cast<float>(q0)),
      per_rest_(q0 < 1 ? static_cast<float>(1 / (1 - q0)) : 0) {}

void MoveTable::prepare(const Trail<MoveCells>& trail) {
  if (!prepared_)
    for (GridSpace::Cell cell = 0; cell < space_.cells(); ++cell) rebuild(cell, trail);
  else
    for (const GridSpace::Cell cell : trail.store().known_cells()) rebuild(cell, trail);
  prepared_ = true;
}

void MoveTable::rebuild(GridSpace::Cell cell, const Trail<MoveCells>& trail) {
  const TrailLevels levels = trail.levels();
  const StoredTrail* stored = trail.store().row(cell);
  const float* heuristic = &heuristic_[kRow * cell];
  float* weights = &weights_[kRow * cell];
  Row tau;
  for (std::size_t d = 0; d < kRow; ++d) tau[d] = levels.read(stored[d]);
  for (std::size_t d = 0; d < kRow; ++d) weights[d] = heuristic[d];
  for (int i = 0; i < alpha_; ++i)
    for (std::size_t d = 0; d < kRow; ++d) weights[d] *= tau[d];
  sum_up(weights, &until_[kRow * cell]);
}

unsigned MoveTable::greedy(const GridStand& at) const {
  unsigned best = GridSpace::kNoDirection;
  float most = 0;
  for (unsigned d = 0; d < kRow; ++d) {
    const float weight = weights_[kRow * at.cell + d];
    if (weight <= most || at.visited[space_.neighbour(at.cell, d)] != 0) continue;
    most = weight;
    best = d;
  }
  return best;
}

unsigned MoveTable::among_unvisited(const GridStand& at, Stream& stream) const {
  Row left;
  float sum = 0;
  unsigned last = GridSpace::kNoDirection;
  for (unsigned d = 0; d < kRow; ++d) {
    const float weight = weights_[kRow * at.cell + d];
    const bool taken = at.visited[space_.neighbour(at.cell, d)] != 0 || weight <= 0;
    sum += taken ? 0 : weight;
    left[d] = sum;
    last = taken ? last : d;
  }
  if (last == GridSpace::kNoDirection) return last;
  const float uniform = drawn(stream) * sum;
  unsigned direction = 0;
  for (const float until : left) direction += until <= uniform ? 1 : 0;
  return std::min(direction, last);
}

}  // namespace alate
