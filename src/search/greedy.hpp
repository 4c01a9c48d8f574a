// Greedy walk: always the cheapest next candidate.
//
// Every step takes the candidate with the least score: J (cost of the leg alone) or J + h (with the guide). Ties go to
// the first. Where no candidate may be flown, or the step limit is met, the walk steps back and takes the next best; a
// bin of states that has once been left that way is not entered again. Without step-backs this is the greedy walk
// that Konatowski, Pawlowski 2019 is compared with. Deterministic; ends at the first arrival, no better than that.
#pragma once

#include <algorithm>
#include <numeric>
#include <unordered_set>

#include "alate/core/run_context.hpp"
#include "search/search_result.hpp"

namespace alate {

struct GreedyOptions {
  bool use_guide = true;
  std::size_t max_step_backs = 20000;
};

template <Space S>
class Greedy {
 public:
  Greedy(const S& space, GreedyOptions options) : space_(space), options_(options) {}

  SearchResult run(RunContext& run) {
    std::vector<Step> walk{first(space_.start())};
    while (!walk.empty() && step_backs_ <= options_.max_step_backs && run.keep_going()) {
      if (space_.is_goal(walk.back().state)) return arrival(walk);
      if (walk.size() > space_.step_limit() || !advance(walk)) step_back(walk);
    }
    return result_;
  }

 private:
  /// A state on the walk, its candidates from best to worst, and which was last taken.
  struct Step {
    typename S::State state;
    double cost = 0;
    std::vector<std::size_t> order;
    std::vector<double> costs;
    std::size_t next = 0;
    bool expanded = false;
  };

  static Step first(typename S::State state) { return {.state = std::move(state)}; }

  void expand(Step& step) {
    space_.expand(step.state, candidates_);
    ++result_.expansions;
    result_.candidates += candidates_.size();
    std::vector<double> score(candidates_.cost.begin(), candidates_.cost.end());
    if (options_.use_guide)
      for (std::size_t k = 0; k < score.size(); ++k) score[k] += candidates_.guide[k];
    for (std::size_t k = 0; k < score.size(); ++k)
      if (score[k] < kInfinity) step.order.push_back(k);
    std::ranges::stable_sort(step.order, {}, [&](std::size_t k) { return score[k]; });
    for (const std::size_t k : step.order) step.costs.push_back(candidates_.cost[k]);
    step.expanded = true;
  }

  /// Moves to the best candidate not yet taken; false if there is none.
  bool advance(std::vector<Step>& walk) {
    Step& step = walk.back();
    if (!step.expanded) expand(step);
    while (step.next < step.order.size()) {
      const std::size_t i = step.next++;
      typename S::State state = space_.next(step.state, step.order[i]);
      if (dead_.contains(space_.bin(state, kBinScale)) || !space_.is_free(step.state, state)) continue;
      Step ahead = first(std::move(state));
      ahead.cost = step.cost + step.costs[i];
      walk.push_back(std::move(ahead));
      return true;
    }
    return false;
  }

  void step_back(std::vector<Step>& walk) {
    dead_.insert(space_.bin(walk.back().state, kBinScale));
    walk.pop_back();
    ++step_backs_;
  }

  SearchResult arrival(const std::vector<Step>& walk) {
    result_.found = true;
    result_.cost = walk.back().cost;
    for (std::size_t i = 0; i + 1 < walk.size(); ++i) result_.actions.push_back(walk[i].order[walk[i].next - 1]);
    return result_;
  }

  static constexpr double kBinScale = 0.5;

  const S& space_;
  GreedyOptions options_;
  Candidates candidates_;
  SearchResult result_;
  std::size_t step_backs_ = 0;
  std::unordered_set<std::uint64_t> dead_;
};

}  // namespace alate
