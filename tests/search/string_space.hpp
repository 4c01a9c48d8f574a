// A space of digit strings: every state has as many actions as there are digits, and costs come from a table.
#pragma once

#include <cmath>
#include <vector>

#include "space/space.hpp"

namespace alate::test {

/// Moves on a line: action k goes to place + k - 1 (left, stay, right) and costs what the table says for the place
/// and step that it reaches. The goal is any place in the last step. Walls may not be entered.
struct LineSpace {
  struct State {
    int place = 0;
    int step = 0;
  };
  std::vector<std::vector<double>> costs;  ///< [step - 1][place]; negative: wall, found only by is_free.
  double guide = 0;

  int places() const { return static_cast<int>(costs.front().size()); }
  State start() const { return {.place = places() / 2, .step = 0}; }
  std::size_t actions() const { return 3; }
  State next(const State& state, std::size_t k) const {
    return {.place = state.place + static_cast<int>(k) - 1, .step = state.step + 1};
  }
  double cost(const State& state) const {
    return costs[static_cast<std::size_t>(state.step - 1)][static_cast<std::size_t>(state.place)];
  }
  void expand(const State& state, Candidates& out) const {
    out.resize(actions());
    for (std::size_t k = 0; k < actions(); ++k) {
      const State to = next(state, k);
      const bool inside = to.place >= 0 && to.place < places() && state.step < static_cast<int>(costs.size());
      out.cost[k] = inside ? std::abs(cost(to)) : kInfinity;
      out.guide[k] = guide;
      out.to_goal[k] = static_cast<double>(costs.size()) - to.step;
    }
  }
  bool arrives(const Candidates& candidates, std::size_t k) const { return candidates.to_goal[k] <= 0; }
  bool is_free(const State&, const State& to) const { return cost(to) >= 0; }
  bool is_goal(const State& state) const { return state.step == static_cast<int>(costs.size()); }
  double lower_bound(const State&) const { return 0; }
  std::uint64_t bin(const State& state, double) const {
    return static_cast<std::uint64_t>(state.step) << 32U | static_cast<std::uint64_t>(state.place);
  }
  std::size_t step_limit() const { return costs.size(); }
};

static_assert(Space<LineSpace>);

}  // namespace alate::test
