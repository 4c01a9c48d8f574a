#include "aco/heuristic/goal_table.hpp"

#include <algorithm>
#include <cmath>

namespace alate {

namespace {

/// eta(cell, direction) for every free move.
template <class Eta>
AlignedFloats fill(const GridSpace& space, const Eta& eta) {
  AlignedFloats table(GridSpace::kDirections * space.cells());
  for (GridSpace::Cell cell = 0; cell < space.cells(); ++cell)
    for (unsigned d = 0; d < GridSpace::kDirections; ++d)
      if (((space.open(cell) >> d) & 1U) != 0) table[GridSpace::kDirections * cell + d] = eta(cell, d);
  return table;
}

}  // namespace

AlignedFloats goal_distance_table(const GridSpace& space, int beta) {
  constexpr float kNearest = 0.5F;
  return fill(space, [&](GridSpace::Cell cell, unsigned d) {
    const float eta = 1 / std::max(space.to_goal(space.neighbour(cell, d)), kNearest);
    float power = 1;
    for (int i = 0; i < beta; ++i) power *= eta;
    return power;
  });
}

AlignedFloats goal_directed_table(const GridSpace& space, double temperature) {
  return fill(space, [&](GridSpace::Cell cell, unsigned d) {
    const double nearer = space.octile(cell, space.goal()) - space.octile(space.neighbour(cell, d), space.goal());
    return static_cast<float>(std::exp((nearer - space.step(d)) / temperature));
  });
}

}  // namespace alate
