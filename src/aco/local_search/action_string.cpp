#include "aco/local_search/action_string.hpp"

#include <algorithm>

namespace alate {

namespace {

/// Gains below this share of the cost are left alone: single precision does not know them.
constexpr double kWorthwhile = 1e-6;

struct Found {
  float cost = std::numeric_limits<float>::infinity();
  std::uint32_t value = 0;
};

Found best_of(const AlignedFloats& totals) {
  const auto least = std::ranges::min_element(totals);
  return {.cost = *least, .value = static_cast<std::uint32_t>(least - totals.begin())};
}

/// One route under improvement: its actions, and the states and costs before each of them.
class Improver {
 public:
  Improver(const AttitudeAnts& space, Ant& ant, RunContext& run)
      : space_(space), ant_(ant), run_(run), found_(space.actions()) {
    retrace();
  }

  /// Every position once; was anything gained?
  bool sweep_singles() {
    bool gained = false;
    for (std::size_t i = 0; i < ant_.actions.size() && run_.keep_going(); ++i) gained |= change_one(i);
    return gained;
  }

  bool sweep_pairs(std::size_t distance) {
    bool gained = false;
    for (std::size_t i = 0; i < ant_.actions.size(); ++i)
      for (std::size_t j = i + 1; j <= i + distance && j < ant_.actions.size() && run_.keep_going(); ++j)
        gained |= change_two(i, j);
    return gained;
  }

 private:
  double limit() const { return ant_.cost * (1 - kWorthwhile); }

  void retrace() {
    states_.assign(1, space_.start());
    costs_.assign(1, 0);
    ant_.costs.clear();
    for (const std::uint32_t k : ant_.actions) {
      states_.push_back(space_.next(states_.back(), k));
      const double cost = space_.move_cost(states_[states_.size() - 2], states_.back());
      costs_.push_back(costs_.back() + cost);
      ant_.costs.push_back(static_cast<float>(cost));
    }
  }

  std::span<const std::uint32_t> after(std::size_t position) const {
    return std::span(ant_.actions).subspan(position + 1);
  }

  /// A choice at `position`, after `cost`, with the rest of the string behind it.
  AttitudeAnts::Branch branch(const AttitudeState& state, double cost, std::size_t position) const {
    return {state, cost, limit(), after(position), tail_, std::span(ant_.costs).subspan(position + 1)};
  }

  bool change_one(std::size_t i) {
    space_.unroll(after(i), tail_);
    space_.price_tails(branch(states_[i], costs_[i], i), prices_);
    const Found found = best_of(prices_.sums.total);
    if (!(static_cast<double>(found.cost) < limit())) return false;
    trial_ = ant_.actions;
    trial_[i] = found.value;
    return accept();
  }

  bool change_two(std::size_t i, std::size_t j) {
    space_.unroll(after(j), tail_);
    run_.executor().for_ranges(found_.size(), [&](std::size_t begin, std::size_t end) {
      TailPrices prices;
      for (std::size_t a = begin; a < end; ++a) found_[a] = best_second(i, j, a, prices);
    });
    const auto found = std::ranges::min_element(found_, {}, &Found::cost);
    if (!(static_cast<double>(found->cost) < limit())) return false;
    trial_ = ant_.actions;
    trial_[i] = static_cast<std::uint32_t>(found - found_.begin());
    trial_[j] = found->value;
    return accept();
  }

  /// The best value at j with value `a` at i.
  Found best_second(std::size_t i, std::size_t j, std::size_t a, TailPrices& prices) const {
    AttitudeState state = states_[i];
    double cost = costs_[i];
    for (std::size_t m = i; m < j; ++m) {
      const AttitudeState ahead = space_.next(state, m == i ? a : ant_.actions[m]);
      cost += space_.move_cost(state, ahead);
      state = ahead;
      if (space_.is_goal(state) || !(cost + space_.lower_bound(state) < limit())) return {};
    }
    space_.price_tails(branch(state, cost, j), prices);
    return best_of(prices.sums.total);
  }

  bool accept() {
    const auto flight = space_.fly(trial_);
    if (!flight || !(flight->cost < ant_.cost)) return false;
    trial_.resize(flight->moves);
    ant_.actions = trial_;
    ant_.cost = flight->cost;
    retrace();
    return true;
  }

  const AttitudeAnts& space_;
  Ant& ant_;
  RunContext& run_;
  std::vector<AttitudeState> states_;
  std::vector<double> costs_;
  std::vector<TailNode> tail_;
  std::vector<Found> found_;
  std::vector<std::uint32_t> trial_;
  TailPrices prices_;
};

}  // namespace

bool ActionString::operator()(const AttitudeAnts& space, Ant& ant, double best_cost, RunContext& run) const {
  const double before = ant.cost;
  Improver improver(space, ant, run);
  for (;;) {
    while (improver.sweep_singles()) continue;
    const bool worth_pairs = ant.cost < best_cost * (1 + pair_margin);
    if (!worth_pairs || !improver.sweep_pairs(pair_distance)) break;
  }
  return ant.cost < before;
}

}  // namespace alate
