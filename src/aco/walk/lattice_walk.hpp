// Ants on a terrain lattice, a batch in step: every move leads to the next plane, so all are in the same plane, and
// while one waits for a node to come from memory, the others choose.
//
// Source: Mai et al. 2023, section 5, steps 3 and 4 (reconstructed). An ant without candidates is dropped and counted;
// so is one that may not join the goal. Ants that break a length limit or, where S asks of nodes only, fly through the
// ground, leave pheromone in deposits of all ants but are never the best. Optional: ants begin with a random part of
// the best route so far (iterated ants: Wiesemann, Stuetzle 2006).
#pragma once

#include <algorithm>
#include <array>
#include <numeric>
#include <span>
#include <vector>

#include "aco/ant.hpp"
#include "aco/pheromone/lattice_cells.hpp"
#include "aco/pheromone/trail.hpp"
#include "aco/walk/lattice_stands.hpp"
#include "alate/core/run_context.hpp"
#include "alate/core/stream.hpp"
#include "space/terrain_lattice.hpp"

namespace alate {

/// What became of all ants of a run.
struct LatticeTally {
  std::uint64_t dead_ends = 0;
  LatticeFaults faults;  ///< On the paths of those that arrived.
};

struct LatticeWalkOptions {
  std::size_t ants = 30;
  std::uint64_t iterations = 500;  ///< Where neither a budget nor a time limit is given.
  double follow = 0;               ///< Share of ants that begin with a part of the best route.
  LatticeTally* tally = nullptr;   ///< Filled if given.
};

template <class Policies>
class LatticeWalk {
 public:
  using Options = LatticeWalkOptions;

  LatticeWalk(const TerrainLattice& lattice, const Options& options)
      : lattice_(lattice), options_(options), batches_((options.ants + kBatch - 1) / kBatch) {
    for (Batch& batch : batches_) batch.path.resize(kBatch * lattice.walk_length() + 1);
  }

  void operator()(Policies& policies, std::vector<Ant>& ants, const Ant& best, RunContext& run) {
    policies.choice.prepare(policies.trail, run.iterations() - std::min<std::uint64_t>(run.iterations(), 1),
                            limit(run));
    const Shift shift{policies, ants, best, run};
    run.executor().for_ranges(batches_.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t batch = begin; batch < end; ++batch) walk(shift, batch);
    });
    if (options_.tally == nullptr) return;
    for (const Batch& batch : batches_) {
      options_.tally->dead_ends += batch.tally.dead_ends;
      options_.tally->faults += batch.tally.faults;
    }
  }

  /// Names the moves of a route that was changed after the walk.
  void name_route(const Policies& policies, Ant& ant) const {
    ant.keys.clear();
    const auto edges = lattice_.edges(ant.actions);
    for (const Edge edge : *edges) ant.keys.push_back(policies.trail.store().key(edge));
    ant.sum = lattice_.judge(*edges).length_m / kKm;
    count_known(policies, ant);
  }

  /// The history tells the score.
  static double told(const Ant& ant) { return ant.cost; }

 private:
  using Node = TerrainLattice::Node;
  using Edge = TerrainLattice::Edge;
  static constexpr std::size_t kCrews = 2;
  static constexpr std::size_t kBatch = kCrews * LatticeStands::kMost;
  static constexpr double kKm = 1000;  ///< Deposits over length are in km.

  /// One iteration.
  struct Shift {
    const Policies& policies;
    std::vector<Ant>& ants;
    const Ant& best;
    RunContext& run;
  };
  struct Slot {
    std::size_t follows = 0;  ///< So many moves of the best route.
    std::size_t ant = 0;
    std::size_t moves = 0;
    Stream stream{0, 0, 0};
  };
  /// While one waits for nodes to come from memory, the other chooses.
  struct Crew {
    LatticeStands stands;
    std::array<std::size_t, LatticeStands::kMost> slot{};
  };
  struct Batch {
    std::array<Slot, kBatch> slots;
    std::vector<Edge> path;  ///< By slot and plane.
    LatticeTally tally;
  };

  std::uint64_t limit(const RunContext& run) const {
    return run.iteration_limit() != 0 ? run.iteration_limit() : options_.iterations;
  }

  void walk(const Shift& shift, std::size_t index) {
    Batch& batch = batches_[index];
    batch.tally = {};
    const std::size_t first = index * kBatch;
    const std::size_t count = std::min(kBatch, shift.ants.size() - first);
    if (!shift.run.keep_going()) {
      for (std::size_t i = 0; i < count; ++i) shift.ants[first + i].restart();
      return;
    }
    for (std::size_t i = 0; i < count; ++i) set_out(shift, first + i, batch.slots[i]);
    step_all(shift, batch, count);
    for (std::size_t i = 0; i < count; ++i) finish(shift, batch, i);
  }

  void set_out(const Shift& shift, std::size_t ant, Slot& slot) const {
    slot = {.follows = 0, .ant = ant, .moves = 0, .stream = Stream(shift.run.seed(), shift.run.iterations(), ant)};
    shift.ants[ant].restart();
    if (options_.follow == 0 || !shift.best.arrived() || shift.best.actions.empty()) return;
    if (slot.stream.uniform() < options_.follow) slot.follows = slot.stream.below(shift.best.actions.size());
  }

  void step_all(const Shift& shift, Batch& batch, std::size_t count) const {
    std::array<Crew, kCrews> crews;
    for (std::size_t c = 0; c < kCrews; ++c) {
      const std::size_t first = c * LatticeStands::kMost;
      crews[c].stands.count = std::min(count - std::min(count, first), LatticeStands::kMost);
      crews[c].stands.node.fill(lattice_.frame().start());
      crews[c].stands.came.fill(TerrainLattice::kFirst);
      std::iota(crews[c].slot.begin(), crews[c].slot.end(), first);
    }
    for (std::size_t plane = 0; plane < lattice_.walk_length(); ++plane)
      for (Crew& crew : crews) step(shift, batch, crew, plane);
  }

  /// The last ant comes first. Who is dropped changes places with the last one that still walks.
  void step(const Shift& shift, Batch& batch, Crew& crew, std::size_t plane) const {
    LatticeStands& stands = crew.stands;
    for (std::size_t i = 0; i < stands.count; ++i)
      if (Slot& slot = batch.slots[crew.slot[i]]; plane >= slot.follows) stands.bits[i] = slot.stream.bits();
    LatticeStands::Moves moves{};
    shift.policies.choice.choose(stands, moves);
    for (std::size_t i = stands.count; i-- > 0;) {
      Slot& slot = batch.slots[crew.slot[i]];
      const unsigned move = plane < slot.follows ? shift.best.actions[plane] : moves[i];
      if (move == LatticeStands::kNoMove) {
        stands.remove(i);
        crew.slot[i] = crew.slot[stands.count];
        continue;
      }
      batch.path[crew.slot[i] * lattice_.walk_length() + plane] = TerrainLattice::kRow * stands.node[i] + move;
      slot.moves = plane + 1;
      stands.node[i] = lattice_.frame().after(stands.node[i], move);
      stands.came[i] = move;
      shift.policies.choice.fetch(stands.node[i]);
    }
  }

  /// Writes the walk down and judges it.
  void finish(const Shift& shift, Batch& batch, std::size_t index) const {
    const Slot& slot = batch.slots[index];
    Ant& ant = shift.ants[slot.ant];
    const std::span<const Edge> edges(&batch.path[index * lattice_.walk_length()], slot.moves);
    ant.actions.resize(edges.size());
    ant.keys.resize(edges.size());
    for (std::size_t i = 0; i < edges.size(); ++i) {
      ant.actions[i] = edges[i] % TerrainLattice::kRow;
      ant.keys[i] = shift.policies.trail.store().key(edges[i]);
    }
    count_known(shift.policies, ant);
    const LatticeFlight flight = lattice_.judge(edges);
    ant.cost = flight.score;
    ant.sum = flight.length_m / kKm;
    ant.is_route = flight.is_route;
    if (ant.arrived())
      batch.tally.faults += flight.faults;
    else
      ++batch.tally.dead_ends;
  }

  static void count_known(const Policies& policies, Ant& ant) {
    const auto known = [&](TrailKey key) { return policies.trail.store().is_known(key); };
    ant.known = static_cast<std::size_t>(std::ranges::count_if(ant.keys, known));
  }

  const TerrainLattice& lattice_;
  Options options_;
  std::vector<Batch> batches_;
};

/// `Choice` draws the moves: heuristic and transition in one, with tables by node.
template <class Choice, class DepositPolicy, class LocalSearch>
struct LatticePolicies {
  template <class Space>
  using Walk = LatticeWalk<LatticePolicies>;

  Choice choice;
  Trail<LatticeCells> trail;
  DepositPolicy deposit;
  LocalSearch local_search;
};

}  // namespace alate
