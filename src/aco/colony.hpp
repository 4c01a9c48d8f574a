// The ant colony: one loop for every colony of alate.
//
// Source: Konatowski, Pawlowski 2019, section 3; the scheme is that of Dorigo, Maniezzo, Colorni 1996. What the colony
// does at each place of the loop is up to five policies:
//   Heuristic    eta^beta: how good choices look                                    aco/heuristic/
//   Transition   which choice is taken                                              aco/transition/
//   Trail        tau: levels on places, and what an unknown place has               aco/pheromone/
//   Deposit      who leaves how much                                                aco/deposit/
//   LocalSearch  what is done to the best ant of an iteration                       aco/local_search/
//
// Departures from the paper:
// - K in eq. (1) is printed as part of the known nodes N; that would leave no choice at first. Read as: the choices
//   that are not on the ant's own route (and may be flown). Only a choice about to be taken is tested, and drawn again
//   if it is not in K: the chances are the same.
// - An ant that does not arrive within the step limit leaves nothing, but its nodes join N.
// - Optional: some ants begin with a random part of the best route so far and walk on from there (iterated ants:
//   Wiesemann, Stuetzle 2006). On long routes few walks would otherwise come near the best.
// - Optional: an ant that flies past the goal ends at the closest node. It leaves pheromone as if it had arrived, but
// is
//   no route: it can be neither the best of its iteration nor the best so far.
// - Optional: an ant without choices (terrain ahead, say) takes its last move back instead of ending.
// Cost: ants x steps x choices an iteration. Determinism: ant a draws from Stream(seed, iteration, a) and writes slot
// a; trails change between walks only, in order of ants. The same bits for any number of threads.
#pragma once

#include <algorithm>
#include <cassert>
#include <utility>

#include "aco/ant.hpp"
#include "aco/ant_space.hpp"
#include "aco/weights.hpp"
#include "alate/core/run_context.hpp"
#include "alate/core/stream.hpp"
#include "alate/world/problem.hpp"

namespace alate {

struct ColonyOptions {
  std::size_t ants = 50;
  std::uint64_t iterations = 180;  ///< Where neither a budget nor a time limit is given.
  int alpha = 1;                   ///< Power of the trail; 0: no trail.
  double follow = 0;               ///< Share of ants that begin with a part of the best route.
  double give_up = 0;              ///< An ant that will be dearer than the best by this share ends; 0: never.
  float end_within_m = 0;          ///< An ant that was so close to the goal and moves away ends at the node before.
  std::size_t step_backs = 0;      ///< An ant without choices steps back, at most this often.
};

template <class Heuristic, class Transition, class Trail, class Deposit, class LocalSearch>
struct ColonyPolicies {
  Heuristic heuristic;
  Transition transition;
  Trail trail;
  Deposit deposit;
  LocalSearch local_search;
};

template <AntSpace Space, class Policies>
class Colony {
 public:
  Colony(const Space& space, Policies policies, ColonyOptions options)
      : space_(space),
        policies_(std::move(policies)),
        options_(options),
        ants_(options.ants),
        scratch_(std::min(options.ants, kGroups)) {
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
    policies_.trail.name_route(space_, ant);
    best_ = std::move(ant);
  }

  /// The best ant of all iterations; it has not arrived if none did.
  const Ant& run(RunContext& run) {
    while (run.start_iteration(options_.iterations)) {
      walk_all(run);
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
  /// The ants of a group walk one after the other, with one scratch: it stays in the cache, and nothing is allocated.
  void walk_all(RunContext& run) {
    const auto first_of = [this](std::size_t group) { return group * ants_.size() / scratch_.size(); };
    run.executor().for_ranges(scratch_.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t group = begin; group < end; ++group)
        for (std::size_t a = first_of(group); a < first_of(group + 1); ++a) {
          walk(ants_[a], scratch_[group], Stream(run.seed(), run.iterations(), a), run);
          count_known(ants_[a]);
        }
    });
  }

  void count_known(Ant& ant) const {
    const auto known = [this](TrailKey node) { return policies_.trail.known(node); };
    ant.known = static_cast<std::size_t>(std::ranges::count_if(ant.keys, known));
  }

  /// One ant, until it arrives, is stuck, or meets the step limit.
  void walk(Ant& ant, Choices& choices, Stream stream, RunContext& run) const {
    ant.restart();
    if (best_.arrived() && stream.uniform() < options_.follow) ant.follow(best_, stream.below(best_.actions.size()));
    typename Space::State state = state_after(ant.actions);
    float to_goal = std::numeric_limits<float>::infinity();
    for (std::size_t looks = 0; ant.actions.size() < space_.step_limit(); ++looks) {
      if (looks % kPollEvery == 0 && !run.keep_going()) return;
      weigh_choices(state, ant.index, choices);
      if (const auto taken = choose(state, ant, choices, stream)) {
        state = *taken;
        if (space_.is_goal(state)) ant.cost = ant.sum;  // eq. (37)
        if (ant.arrived() || is_hopeless(ant, choices.guide[ant.actions.back()])) return;
        const float before = std::exchange(to_goal, choices.to_goal[ant.actions.back()]);
        if (before < options_.end_within_m && to_goal > before) return ant.end_before_last();
        continue;
      }
      if (ant.actions.empty() || ant.dead.size() >= options_.step_backs) return;
      ant.step_back();
      to_goal = std::numeric_limits<float>::infinity();
      state = state_after(ant.actions);
    }
  }

  /// Would the ant, as far as the guide knows, be much dearer than the best so far?
  bool is_hopeless(const Ant& ant, float ahead) const {
    if (!best_.arrived() || options_.give_up == 0) return false;
    return ant.sum + static_cast<double>(ahead) > best_.cost * (1 + options_.give_up);
  }

  typename Space::State state_after(const std::vector<std::uint32_t>& actions) const {
    typename Space::State state = space_.start();
    for (const std::uint32_t k : actions) state = space_.next(state, k);
    return state;
  }

  /// Numerators of eq. (1): tau_k^alpha (1 / J_k)^beta.
  void weigh_choices(const typename Space::State& state, std::size_t ant, Choices& choices) const {
    space_.look(state, choices);
    policies_.heuristic(choices, ant);
    policies_.trail.weigh(options_.alpha, choices);
  }

  /// Draws from K and moves the ant; nothing where K is empty.
  std::optional<typename Space::State> choose(const typename Space::State& state, Ant& ant, Choices& choices,
                                              Stream& stream) const {
    for (;;) {
      const std::size_t k = policies_.transition(choices, stream);
      if (k >= space_.actions()) return std::nullopt;
      typename Space::State ahead = space_.next(state, k);
      const TrailKey node = policies_.trail.name(choices.x[k], choices.y[k], choices.z[k]);
      if (!contains(ant.keys, node) && !contains(ant.dead, node) && space_.is_free(state, ahead)) {
        ant.move(static_cast<std::uint32_t>(k), node, choices.cost[k]);
        return ahead;
      }
      choices.weight[k] = 0;
    }
  }

  static bool contains(const std::vector<TrailKey>& keys, TrailKey key) {
    return std::ranges::find(keys, key) != keys.end();
  }

  /// The best ant of this iteration after local search, its cost exact.
  const Ant& improved_best(RunContext& run) {
    const auto cost_of_route = [](const Ant& ant) { return ant.is_route ? ant.cost : kInfinity; };
    const auto found = std::ranges::min_element(ants_, {}, cost_of_route);
    if (!(cost_of_route(*found) < kInfinity)) return nobody_;
    const auto flight = space_.fly(found->actions);
    assert(flight);
    found->cost = flight->cost;
    if (policies_.local_search(space_, *found, best_.cost, run)) {
      policies_.trail.name_route(space_, *found);
      count_known(*found);
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
    for (const Ant& ant : ants_) {
      moves += ant.actions.size();
      known += ant.known;
      if (!ant.arrived()) continue;
      ++arrived;
      if (!ant.is_route) continue;
      ++routes;
      sum += ant.cost;
      result.best = std::min(result.best.value_or(ant.cost), ant.cost);
      result.worst = std::max(result.worst.value_or(ant.cost), ant.cost);
    }
    moves_ += moves;
    if (best_.arrived()) result.best_so_far = best_.cost;
    if (routes != 0) result.mean = sum / static_cast<double>(routes);
    result.arrived = static_cast<double>(arrived) / static_cast<double>(ants_.size());
    if (moves != 0) result.known = static_cast<double>(known) / static_cast<double>(moves);
    return result;
  }

  static constexpr std::size_t kPollEvery = 8;
  static constexpr std::size_t kGroups = 64;  ///< Enough to keep any number of threads evenly busy.

  Ant best_;
  const Ant nobody_;  ///< Where no ant of an iteration arrived.
  const Space& space_;
  Policies policies_;
  ColonyOptions options_;
  std::vector<Ant> ants_;
  std::vector<Choices> scratch_;  ///< One a group of ants.
  std::vector<IterationStats> history_;
  std::uint64_t moves_ = 0;
};

}  // namespace alate
