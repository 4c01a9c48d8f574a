// Beam search: step by step, only the best few states are kept; wider and wider passes.
//
// Pass i keeps at most width * 2^(i-1) states a step. All states of a step are as many moves from the start, and are
// ranked by f = cost so far + guide, ties by (f, g, index). Only the best of each bin of the space is kept, so that
// near-copies do not fill the beam; coarse and fine bins take turns. States whose lower bound cannot beat the best
// arrival are dropped. The cheapest arrival of all passes wins, so more passes are never worse. Ends at the greatest
// width, or when a pass dropped nothing: wider passes would be the same.
//
// Source: Lowerre 1976 (beam search); anytime widening after Zhou, Hansen 2005, without their backtracking.
// Cost: width x actions expansions a step. Any number of threads gives the same bits: entry i writes slots
// i * actions ..., and states are kept in order of rank.
#pragma once

#include <algorithm>
#include <optional>
#include <tuple>
#include <unordered_set>

#include "alate/core/run_context.hpp"
#include "search/search_result.hpp"

namespace alate {

struct BeamOptions {
  std::size_t width = 32;            ///< Of the first pass.
  std::size_t max_width = 8192;      ///< Of the last pass.
  std::uint64_t default_passes = 4;  ///< Where neither a budget nor a time limit is given.
};

template <Space S>
class Beam {
 public:
  Beam(const S& space, BeamOptions options) : space_(space), options_(options) {}

  /// `incumbent`: a route that is already known, or nothing.
  SearchResult run(RunContext& run, SearchResult incumbent = {}) {
    best_ = std::move(incumbent);
    const typename S::State start = space_.start();
    if (space_.is_goal(start)) {
      best_.found = true;
      best_.cost = 0;
      return best_;
    }
    bin_scale_ = kCoarse;
    const std::size_t widest = std::min(options_.max_width, kMaxRanks / space_.actions());
    for (std::size_t width = options_.width; run.start_iteration(options_.default_passes); width *= 2) {
      pass(start, width, run);
      if (!dropped_ || 2 * width > widest) break;
      bin_scale_ = bin_scale_ == kCoarse ? kFine : kCoarse;
    }
    return best_;
  }

 private:
  struct Entry {
    typename S::State state;
    double cost = 0;
    std::uint32_t node = 0;
  };
  /// A candidate of the next step. `index` = entry * actions + action.
  struct Rank {
    double f = 0;
    double g = 0;
    std::uint64_t index = 0;
    bool operator<(const Rank& other) const { return std::tie(f, g, index) < std::tie(other.f, other.g, other.index); }
  };
  struct Tested {
    typename S::State state;
    Rank rank;
    std::uint64_t bin = 0;
    bool keep = false;
    bool arrives = false;
  };
  static constexpr std::size_t kMaxRanks = 1U << 22U;  ///< 100 MB.
  static constexpr double kCoarse = 1;
  static constexpr double kFine = 0.5;
  /// Arrivals outrank all else: with a full beam the cheapest must not be missed.
  static constexpr double kFirst = -kInfinity;

  void pass(const typename S::State& start, std::size_t width, RunContext& run) {
    dropped_ = false;
    tree_ = MoveTree{};
    beam_.assign(1, Entry{.state = start});
    for (std::size_t step = 0; step < space_.step_limit() && !beam_.empty(); ++step) {
      rank_candidates(run);
      if (!run.keep_going()) return;
      keep_best(width, run);
      run.report(best_.found ? std::optional(best_.cost) : std::nullopt);
    }
  }

  /// Expands every entry into its own slots, then drops what is not in K.
  void rank_candidates(RunContext& run) {
    const std::size_t actions = space_.actions();
    ranks_.resize(beam_.size() * actions);
    run.executor().for_ranges(beam_.size(), [&](std::size_t begin, std::size_t end) {
      Candidates candidates;
      for (std::size_t i = begin; i < end; ++i) {
        if (!run.keep_going()) return;
        space_.expand(beam_[i].state, candidates);
        for (std::size_t k = 0; k < actions; ++k) {
          const double g = beam_[i].cost + candidates.cost[k];
          const double f = space_.arrives(candidates, k) ? kFirst : g + candidates.guide[k];
          ranks_[i * actions + k] = {f, g, i * actions + k};
        }
      }
    });
    best_.expansions += beam_.size();
    best_.candidates += ranks_.size();
    std::erase_if(ranks_, [](const Rank& rank) { return !(rank.f < kInfinity && rank.g < kInfinity); });
  }

  /// Replaces the beam by the best candidates that may be flown. The costly tests run on small groups in order of
  /// rank, and only until the beam is full.
  void keep_best(std::size_t width, RunContext& run) {
    next_.clear();
    bins_.clear();
    const std::size_t group = 2 * width;
    std::size_t sorted = 0;
    std::size_t from = 0;
    while (from < ranks_.size() && next_.size() < width && run.keep_going()) {
      if (from == sorted) sorted = sort_more(sorted, std::max(group, sorted));
      const std::size_t to = std::min(from + group, sorted);
      test(from, to, run);
      for (std::size_t i = 0; i < to - from; ++i) take(tested_[i], width);
      from = to;
    }
    dropped_ = dropped_ || from < ranks_.size();
    std::swap(beam_, next_);
  }

  /// Puts the next `count` ranks in order; the rest stays as it is, as most are never looked at.
  std::size_t sort_more(std::size_t sorted, std::size_t count) {
    const auto from = ranks_.begin() + static_cast<std::ptrdiff_t>(sorted);
    const std::size_t end = std::min(sorted + count, ranks_.size());
    const auto to = ranks_.begin() + static_cast<std::ptrdiff_t>(end);
    if (to != ranks_.end()) std::nth_element(from, to, ranks_.end());
    std::sort(from, to);
    return end;
  }

  void test(std::size_t from, std::size_t to, RunContext& run) {
    tested_.resize(to - from);
    run.executor().for_ranges(to - from, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) tested_[i] = tested(ranks_[from + i]);
    });
  }

  /// Only reads what all threads share: bins and best are those before this group.
  Tested tested(const Rank& rank) const {
    const Entry& parent = beam_[rank.index / space_.actions()];
    Tested result{.state = space_.next(parent.state, rank.index % space_.actions()), .rank = rank};
    result.arrives = space_.is_goal(result.state);
    result.bin = space_.bin(result.state, bin_scale_);
    const bool useful =
        rank.g + space_.lower_bound(result.state) < best_.cost && (result.arrives || !bins_.contains(result.bin));
    result.keep = useful && space_.is_free(parent.state, result.state);
    return result;
  }

  void take(const Tested& tested, std::size_t width) {
    if (!tested.keep) return;
    const std::uint32_t parent = beam_[tested.rank.index / space_.actions()].node;
    const std::size_t action = tested.rank.index % space_.actions();
    if (tested.arrives) {
      if (tested.rank.g < best_.cost) record(parent, action, tested.rank.g);
    } else if (next_.size() >= width || !bins_.insert(tested.bin).second) {
      dropped_ = true;
    } else {
      next_.push_back({.state = tested.state, .cost = tested.rank.g, .node = tree_.add(parent, action)});
    }
  }

  void record(std::uint32_t parent, std::size_t action, double cost) {
    best_.found = true;
    best_.cost = cost;
    best_.actions = tree_.path_to(parent);
    best_.actions.push_back(action);
  }

  const S& space_;
  BeamOptions options_;
  SearchResult best_;
  MoveTree tree_;
  std::vector<Entry> beam_, next_;
  std::vector<Rank> ranks_;
  std::vector<Tested> tested_;
  std::unordered_set<std::uint64_t> bins_;
  double bin_scale_ = kCoarse;
  bool dropped_ = false;  ///< Did this pass drop anything that could have led to a better arrival?
};

}  // namespace alate
