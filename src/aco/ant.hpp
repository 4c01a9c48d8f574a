// One ant's walk, and what a colony keeps of it.
#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

#include "space/choices.hpp"

namespace alate {

/// Name of a place that can carry a trail.
using TrailKey = std::uint64_t;

/// On cache lines of its own: its neighbour may be walking on another thread.
struct alignas(kSimdBytes) Ant {
  std::vector<std::uint32_t> actions;
  std::vector<TrailKey> keys;  ///< Where every action led: the nodes u_j of the route.
  std::vector<float> costs;    ///< J of every node.
  std::vector<TrailKey> dead;  ///< Nodes that it stepped back from.
  std::size_t index = 0;       ///< In its colony.
  double sum = 0;              ///< Of costs.
  bool is_route = true;        ///< Not one that flew past the goal.
  std::size_t known = 0;       ///< Nodes that carried a trail before this walk.
  double cost = kInfinity;     ///< J_c, eq. (37); infinite unless it arrived.

  /// At the goal, or where an ant that flew past it may end.
  bool arrived() const { return cost < kInfinity; }

  /// Ends one node back, the closest to the goal.
  void end_before_last() {
    drop_last();
    cost = sum;
    is_route = false;
  }

  void move(std::uint32_t action, TrailKey node, float node_cost) {
    actions.push_back(action);
    keys.push_back(node);
    costs.push_back(node_cost);
    sum += static_cast<double>(node_cost);
  }

  /// Takes back the last move, which is not tried again.
  void step_back() {
    dead.push_back(keys.back());
    drop_last();
  }

  /// Starts with the first `moves` of another ant.
  void follow(const Ant& other, std::size_t moves) {
    const auto count = static_cast<std::ptrdiff_t>(moves);
    actions.assign(other.actions.begin(), other.actions.begin() + count);
    keys.assign(other.keys.begin(), other.keys.begin() + count);
    costs.assign(other.costs.begin(), other.costs.begin() + count);
    sum_up();
  }

  void restart() {
    actions.clear();
    keys.clear();
    costs.clear();
    dead.clear();
    sum = 0;
    is_route = true;
    known = 0;
    cost = kInfinity;
  }

 private:
  void drop_last() {
    actions.pop_back();
    keys.pop_back();
    costs.pop_back();
    sum_up();
  }
  /// Anew, so that the sum is always that of the costs in order.
  void sum_up() { sum = std::accumulate(costs.begin(), costs.end(), 0.0); }
};

/// What a deposit sees of one iteration.
struct Harvest {
  const std::vector<Ant>& ants;
  const Ant& iteration_best;  ///< May not have arrived.
  const Ant& best;            ///< Of all iterations; may not have arrived.
  std::uint64_t iteration = 0;
};

}  // namespace alate
