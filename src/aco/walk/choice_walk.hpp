// Ants that walk one after the other over any space that lists its choices in arrays.
//
// Source: Konatowski, Pawlowski 2019, section 3.
//
// Departures from the paper:
// - K in eq. (1) is printed as part of the known nodes N; that would leave no choice at first. Read as: the choices
//   that are not on the ant's own route (and may be flown). Only a choice about to be taken is tested, and drawn again
//   if it is not in K: the chances are the same.
// - An ant that does not arrive within the step limit leaves nothing, but its nodes join N.
// - Optional: some ants begin with a random part of the best route so far and walk on from there (iterated ants:
//   Wiesemann, Stuetzle 2006). On long routes few walks would otherwise come near the best.
// - Optional: an ant that flies past the goal ends at the closest node. It leaves pheromone as if it had arrived, but
//   is no route: it can be neither the best of its iteration nor the best so far.
// - Optional: an ant without choices (terrain ahead, say) takes its last move back instead of ending.
#pragma once

#include <algorithm>
#include <utility>

#include "aco/ant.hpp"
#include "aco/ant_space.hpp"
#include "aco/weights.hpp"
#include "alate/core/run_context.hpp"
#include "alate/core/stream.hpp"

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

/// `Policies` are those of the colony: heuristic, transition, trail.
template <AntSpace Space, class Policies>
class ChoiceWalk {
 public:
  using Options = ColonyOptions;

  ChoiceWalk(const Space& space, const Options& options)
      : space_(space), options_(options), scratch_(std::min(options.ants, kGroups)) {}

  /// The ants of a group walk one after the other, with one scratch: it stays in the cache, and nothing is allocated.
  void operator()(const Policies& policies, std::vector<Ant>& ants, const Ant& best, RunContext& run) {
    const auto first_of = [&](std::size_t group) { return group * ants.size() / scratch_.size(); };
    run.executor().for_ranges(scratch_.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t group = begin; group < end; ++group)
        for (std::size_t a = first_of(group); a < first_of(group + 1); ++a) {
          One one{policies,
                  ants[a],
                  best,
                  scratch_[group].choices,
                  scratch_[group].states,
                  Stream(run.seed(), run.iterations(), a)};
          walk(one, run);
          count_known(policies, ants[a]);
        }
    });
  }

  /// Names the nodes of a route that was changed after the walk.
  void name_route(const Policies& policies, Ant& ant) const {
    policies.trail.name_route(space_, ant);
    count_known(policies, ant);
  }

  /// What the history tells of a route.
  static double told(const Ant& ant) { return ant.cost; }

 private:
  using State = typename Space::State;
  using States = std::vector<State>;

  /// One ant and what it walks with.
  struct One {
    const Policies& policies;
    Ant& ant;
    const Ant& best;
    Choices& choices;
    States& states;
    Stream stream;
  };
  struct Scratch {
    Choices choices;
    States states;  ///< Of the ant, from the start on: what it steps back to.
  };

  static void count_known(const Policies& policies, Ant& ant) {
    const auto known = [&](TrailKey node) { return policies.trail.known(node); };
    ant.known = static_cast<std::size_t>(std::ranges::count_if(ant.keys, known));
  }

  /// One ant, until it arrives, is stuck, or meets the step limit.
  void walk(One& one, RunContext& run) const {
    auto& [policies, ant, best, choices, states, stream] = one;
    ant.restart();
    if (best.arrived() && stream.uniform() < options_.follow) ant.follow(best, stream.below(best.actions.size()));
    State state = space_.start();
    states.assign(1, state);
    for (const std::uint32_t k : ant.actions) states.push_back(state = space_.next(state, k));
    float to_goal = std::numeric_limits<float>::infinity();
    for (std::size_t looks = 0; ant.actions.size() < space_.step_limit(); ++looks) {
      if (looks % kPollEvery == 0 && !run.keep_going()) return;
      weigh_choices(state, one);
      if (const auto taken = choose(state, one)) {
        states.push_back(state = *taken);
        if (space_.is_goal(state)) ant.cost = ant.sum;  // eq. (37)
        if (ant.arrived() || is_hopeless(ant, best, choices.guide[ant.actions.back()])) return;
        const float before = std::exchange(to_goal, choices.to_goal[ant.actions.back()]);
        if (before < options_.end_within_m && to_goal > before) return ant.end_before_last();
        continue;
      }
      if (ant.actions.empty() || ant.dead.size() >= options_.step_backs) return;
      ant.step_back();
      to_goal = std::numeric_limits<float>::infinity();
      states.pop_back();
      state = states.back();
    }
  }

  /// Would the ant, as far as the guide knows, be much dearer than the best so far?
  bool is_hopeless(const Ant& ant, const Ant& best, float ahead) const {
    if (!best.arrived() || options_.give_up == 0) return false;
    return ant.sum + static_cast<double>(ahead) > best.cost * (1 + options_.give_up);
  }

  /// Numerators of eq. (1): tau_k^alpha (1 / J_k)^beta.
  void weigh_choices(const State& state, One& one) const {
    space_.look(state, one.choices);
    one.policies.heuristic(one.choices, one.ant.index);
    one.policies.trail.weigh(options_.alpha, one.choices);
  }

  /// Draws from K and moves the ant; nothing where K is empty.
  std::optional<State> choose(const State& state, One& one) const {
    auto& [policies, ant, best, choices, states, stream] = one;
    for (;;) {
      const std::size_t k = policies.transition(choices, stream);
      if (k >= space_.actions()) return std::nullopt;
      choices.weight[k] = 0;
      const TrailKey node = policies.trail.name(choices.x[k], choices.y[k], choices.z[k]);
      if (contains(ant.keys, node) || contains(ant.dead, node)) continue;
      State ahead = space_.next(state, k);
      if (!space_.is_free(state, ahead)) continue;
      ant.move(static_cast<std::uint32_t>(k), node, choices.cost[k]);
      return ahead;
    }
  }

  static bool contains(const std::vector<TrailKey>& keys, TrailKey key) {
    return std::ranges::find(keys, key) != keys.end();
  }

  static constexpr std::size_t kPollEvery = 8;
  static constexpr std::size_t kGroups = 64;  ///< Enough to keep any number of threads evenly busy.

  const Space& space_;
  Options options_;
  std::vector<Scratch> scratch_;  ///< One a group of ants.
};

}  // namespace alate
