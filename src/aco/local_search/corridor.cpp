#include "aco/local_search/corridor.hpp"

namespace alate {

namespace {

constexpr bool holds(unsigned set, unsigned move) { return ((set >> move) & 1U) != 0; }

}  // namespace

bool Corridor::operator()(const TerrainLattice& lattice, std::vector<std::uint32_t>& actions, RunContext& run) {
  bool changed = false;
  while (!actions.empty() && run.keep_going()) {
    lay(lattice, actions);
    for (std::size_t gate = 1; gate < gates_.size(); ++gate) pass(lattice, gate);
    if (!trace(lattice, actions)) break;
    changed = true;
  }
  return changed;
}

void Corridor::lay(const TerrainLattice& lattice, std::span<const std::uint32_t> actions) {
  const LatticeFrame& frame = lattice.frame();
  gates_.assign(actions.size() + 1, {});
  gates_[0].node[0] = frame.start();
  gates_[0].exists[0] = true;
  gates_[0].came[0].fill(LatticeFrame::kFirst);
  for (auto& costs : gates_[0].cost) costs.fill(kInfinity);
  gates_[0].cost[0][0] = 0;
  Node node = frame.start();
  for (std::size_t i = 0; i < actions.size(); ++i) {
    node = frame.after(node, actions[i]);
    const LatticeFrame::Place at = frame.place(node);
    Gate& gate = gates_[i + 1];
    for (auto& costs : gate.cost) costs.fill(kInfinity);
    for (std::size_t k = 0; k < kWide; ++k) {
      const LatticeFrame::Place to{at.plane, at.side + static_cast<int>(k / 3) - 1,
                                   at.height + static_cast<int>(k % 3) - 1};
      gate.exists[k] = to.side >= 0 && to.side < frame.columns() && to.height >= 0 && to.height < frame.levels();
      if (gate.exists[k]) gate.node[k] = frame.node(to);
    }
  }
}

/// From all pairs that end in the gate before.
void Corridor::pass(const TerrainLattice& lattice, std::size_t gate) {
  const LatticeFrame& frame = lattice.frame();
  const Gate& before = gates_[gate - 1];
  for (std::size_t from = 0; from < kWide; ++from) {
    if (!before.exists[from]) continue;
    const LatticeFrame::Place at = frame.place(before.node[from]);
    for (std::size_t to = 0; to < kWide; ++to) {
      if (!gates_[gate].exists[to]) continue;
      const LatticeFrame::Place next = frame.place(gates_[gate].node[to]);
      const auto move = frame.move(next.side - at.side, next.height - at.height);
      if (move && holds(lattice.moves().open(before.node[from]), *move)) arrive(lattice, gate, {from, to, *move});
    }
  }
}

/// `through`: node of the gate before, node of this one, the move between them.
void Corridor::arrive(const TerrainLattice& lattice, std::size_t gate, std::array<std::size_t, 3> through) {
  const auto [from, to, by] = through;
  const auto move = static_cast<unsigned>(by);
  const Gate& before = gates_[gate - 1];
  double best = kInfinity;
  std::size_t back = 0;
  for (std::size_t first = 0; first < kWide; ++first) {
    const double until = before.cost[from][first];
    const unsigned came = before.came[from][first];
    if (!(until < kInfinity) || !holds(lattice.moves().follows(came), move)) continue;
    const double cost = until + lattice.score().of_step(before.node[from], came, move);
    if (cost < best) back = first;
    best = cost < best ? cost : best;
  }
  gates_[gate].cost[to][from] = best;
  gates_[gate].came[to][from] = static_cast<std::uint8_t>(move);
  gates_[gate].back[to][from] = static_cast<std::uint8_t>(back);
}

/// Writes the cheapest string down if it is cheaper than the route.
bool Corridor::trace(const TerrainLattice& lattice, std::vector<std::uint32_t>& actions) const {
  constexpr double kHair = 1e-9;
  const Gate& last = gates_.back();
  double best = kInfinity;
  std::array<std::size_t, 2> at{};
  for (std::size_t to = 0; to < kWide; ++to) {
    for (std::size_t from = 0; from < kWide; ++from) {
      if (!(last.cost[to][from] < kInfinity) || !holds(lattice.moves().joins(last.node[to]), last.came[to][from]))
        continue;
      const double cost = last.cost[to][from] + lattice.score().of_join(last.node[to], last.came[to][from]);
      if (cost < best) at = {to, from};
      best = cost < best ? cost : best;
    }
  }
  const auto old = lattice.edges(actions);
  if (!(best < (1 - kHair) * lattice.judge(*old).score)) return false;
  for (std::size_t gate = gates_.size() - 1; gate > 0; --gate) {
    actions[gate - 1] = gates_[gate].came[at[0]][at[1]];
    at = {at[1], gates_[gate].back[at[0]][at[1]]};
  }
  return true;
}

}  // namespace alate
