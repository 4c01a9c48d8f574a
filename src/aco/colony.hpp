// The ant colony: one loop for every colony of alate.
//
// Source: Konatowski, Pawlowski 2019, section 3; the scheme is that of Dorigo, Maniezzo, Colorni 1996. What the colony
// does at each place of the loop is up to its policies:
//   Walk         how the ants of an iteration go from the start to the goal         aco/walk/
//   Heuristic    eta^beta: how good choices look                                    aco/heuristic/
//   Transition   which choice is taken                                              aco/transition/
//   Trail        tau: levels on places, and what an unknown place has               aco/pheromone/
//   Deposit      who leaves how much                                                aco/deposit/
//   LocalSearch  what is done to the best ant of an iteration                       aco/local_search/
//
// Cost: ants x steps x choices an iteration. Determinism: ant a draws from Stream(seed, iteration, a) and writes slot
// a; trails change between walks only, in order of ants. The same bits for any number of threads.
#pragma once

#include <algorithm>
#include <cassert>
#include <optional>
#include <utility>

#include "aco/ant.hpp"
#include "aco/ant_space.hpp"
#include "aco/walk/choice_walk.hpp"
#include "alate/core/run_context.hpp"
#include "alate/world/problem.hpp"

namespace alate {

template <class Heuristic, class Transition, class Trail, class Deposit, class LocalSearch>
struct ColonyPolicies {
  template <class Space>
  using Walk = ChoiceWalk<Space, ColonyPolicies>;

  Heuristic heuristic;
  Transition transition;
  Trail trail;
  Deposit deposit;
  LocalSearch local_search;
};

template <ColonySpace Space, class Policies>
class Colony {
  using Walk = typename Policies::template Walk<Space>;

 public:
  using Options = typename Walk::Options;

  Colony(const Space& space, Policies policies, Options options)
      : space_(space),
        policies_(std::move(policies)),
        iterations_(options.iterations),
        walk_(space, options),
        ants_(options.ants) {
    for (std::size_t a = 0; a < ants_.size(); ++a) ants_[a].index = a;
  }

  /// A route that is known already, for ants to follow; ignored if it may not be flown.
  void start_from(const std::vector<std::size_t>& actions, RunContext& run) {
    Ant ant;
    ant.actions.assign(actions.begin(), actions.end());
    const auto flight = space_.fly(ant.actions);
    if (!flight) return;
    ant.actions.resize(flight->moves);
    ant.cost = flight->cost;
    ant.costs = flight->costs;
    policies_.local_search(space_, ant, kInfinity, run);
    walk_.name_route(policies_, ant);
    best_ = std::move(ant);
  }

  /// The best ant of all iterations; it has not arrived if none did.
  const Ant& run(RunContext& run) {
    while (run.start_iteration(iterations_)) {
      walk_(policies_, ants_, best_, run);
      const Ant& iteration_best = improved_best(run);
      if (iteration_best.cost < best_.cost) best_ = iteration_best;
      history_.push_back(stats());
      if (!run.keep_going()) break;
      for (const Ant& ant : ants_)
        for (const TrailKey node : ant.keys) policies_.trail.join(node);  // eq. (28)
      policies_.trail.evaporate();                                        // eq. (2)
      policies_.deposit(policies_.trail, Harvest{ants_, iteration_best, best_, run.iterations()});
      run.report(best_.arrived() ? std::optional(best_.cost) : std::nullopt);
    }
    return best_;
  }

  const std::vector<IterationStats>& history() const { return history_; }
  std::uint64_t moves() const { return moves_; }

 private:
  /// The best ant of this iteration after local search, its cost exact.
  const Ant& improved_best(RunContext& run) {
    const auto cost_of_route = [](const Ant& ant) { return ant.is_route ? ant.cost : kInfinity; };
    const auto found = std::ranges::min_element(ants_, {}, cost_of_route);
    if (!(cost_of_route(*found) < kInfinity)) return nobody_;
    const auto flight = space_.fly(found->actions);
    assert(flight);
    found->cost = flight->cost;
    if (policies_.local_search(space_, *found, best_.cost, run)) {
      walk_.name_route(policies_, *found);
    }
    return *found;
  }

  IterationStats stats() {
    IterationStats result;
    std::size_t arrived = 0;
    std::size_t routes = 0;
    std::uint64_t moves = 0;
    std::uint64_t known = 0;
    double sum = 0;
    double scores = 0;
    for (const Ant& ant : ants_) {
      moves += ant.actions.size();
      known += ant.known;
      if (!ant.arrived()) continue;
      ++arrived;
      if (!ant.is_route) continue;
      ++routes;
      const double cost = Walk::told(ant);
      sum += cost;
      scores += ant.cost;
      result.best = std::min(result.best.value_or(cost), cost);
      result.worst = std::max(result.worst.value_or(cost), cost);
    }
    moves_ += moves;
    if (best_.arrived()) result.best_so_far = Walk::told(best_);
    if (routes != 0) result.mean = sum / static_cast<double>(routes);
    result.arrived = static_cast<double>(arrived) / static_cast<double>(ants_.size());
    if (moves != 0) result.known = static_cast<double>(known) / static_cast<double>(moves);
    if constexpr (requires { space_.measure(best_.actions); }) {
      if (best_.arrived()) result.grid = GridStats{.best = space_.measure(best_.actions), .mean_score = {}};
      if (result.grid && routes != 0) result.grid->mean_score = scores / static_cast<double>(routes);
    }
    return result;
  }

  Ant best_;
  const Ant nobody_;  ///< Where no ant of an iteration arrived.
  const Space& space_;
  Policies policies_;
  std::uint64_t iterations_;
  Walk walk_;
  std::vector<Ant> ants_;
  std::vector<IterationStats> history_;
  std::uint64_t moves_ = 0;
};

}  // namespace alate
