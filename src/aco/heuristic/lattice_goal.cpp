#include "aco/heuristic/lattice_goal.hpp"

#include <algorithm>
#include <cmath>

#include "aco/heuristic/lattice_rows.hpp"

namespace alate {

using Node = TerrainLattice::Node;

AlignedFloats lattice_distance_table(const TerrainLattice& lattice, int beta) {
  const LatticeFrame& frame = lattice.frame();
  const double nearest = frame.steps_m().x() / 2;
  const auto nearness = [&](Node /*node*/, const Vec3& to, unsigned /*move*/) {
    return 1 / std::max((frame.goal() - to).norm(), nearest);
  };
  return lattice_rows(lattice, nearness, PowerOfShare{beta});
}

AlignedFloats lattice_directed_table(const TerrainLattice& lattice, double temperature) {
  const LatticeFrame& frame = lattice.frame();
  const LatticeScore& score = lattice.score();
  const double step = score.of_straight(frame.goal() - Vec3(frame.steps_m().x(), 0, 0));
  const double scale = 1 / (temperature * step);
  const auto minus_cost = [&](Node node, const Vec3& to, unsigned move) {
    return -score.of_move(node, move) - score.of_straight(to);
  };
  return lattice_rows(lattice, minus_cost, [=](double value, double best) { return std::exp((value - best) * scale); });
}

}  // namespace alate
