#include "study/yin2021/figures.hpp"

#include <algorithm>
#include <cmath>

namespace alate::yin2021 {

namespace {

/// Lengths and deviations that differ by less are of sums in another order.
constexpr double kHair = 1e-9;

bool same(double a, double b) { return std::abs(a - b) < kHair; }

const GridStats* stats_at(const StudyRun& run, std::size_t iteration) {
  const auto& history = run.plan.history;
  if (!run.passed || history.empty()) return nullptr;
  const auto& grid = history[std::min(iteration, history.size()) - 1].grid;
  return grid ? &*grid : nullptr;
}

/// One value a run that has it.
template <class Value>
std::vector<double> over_runs(const Trial& trial, Value value) {
  std::vector<double> values;
  for (const StudyRun& run : trial.runs)
    if (const std::optional<double> of_run = value(run)) values.push_back(*of_run);
  return values;
}

std::optional<double> picked(const GridStats* stats, Pick pick) {
  return stats == nullptr ? std::nullopt : pick(*stats);
}

std::optional<double> last_change(const StudyRun& run, Pick pick) {
  if (last_stats(run) == nullptr) return std::nullopt;
  std::size_t last = 0;
  std::optional<double> before;
  for (std::size_t i = 0; i < run.plan.history.size(); ++i) {
    const auto now = picked(stats_at(run, i + 1), pick);
    if (now && (!before || !same(*now, *before))) last = i + 1;
    before = now;
  }
  return static_cast<double>(last);
}

}  // namespace

std::optional<double> length_of(const GridStats& stats) { return stats.best.length_cells; }
std::optional<double> deviation_of(const GridStats& stats) { return stats.best.height_deviation_m; }
std::optional<double> turns_of(const GridStats& stats) { return static_cast<double>(stats.best.turns); }
std::optional<double> score_of(const GridStats& stats) { return composite_index(stats.best); }
std::optional<double> mean_score_of(const GridStats& stats) { return stats.mean_score; }

const GridStats* last_stats(const StudyRun& run) { return stats_at(run, run.plan.history.size()); }

Figure mean_at(std::size_t iteration, Pick pick) {
  return [=](const Trial& trial) {
    return mean_of(over_runs(trial, [&](const StudyRun& run) { return picked(stats_at(run, iteration), pick); }));
  };
}

Figure final_mean(Pick pick) {
  return [=](const Trial& trial) {
    return mean_of(over_runs(trial, [&](const StudyRun& run) { return picked(last_stats(run), pick); }));
  };
}

Figure final_variance(Pick pick) {
  return [=](const Trial& trial) -> std::optional<double> {
    const auto summary =
        summarize(over_runs(trial, [&](const StudyRun& run) { return picked(last_stats(run), pick); }));
    if (!summary || !summary->sd) return std::nullopt;
    return same(summary->least, summary->greatest) ? 0 : *summary->sd * *summary->sd;
  };
}

Figure of_best(Pick pick) {
  return [=](const Trial& trial) {
    const GridStats* best = nullptr;
    for (const StudyRun& run : trial.runs) {
      const GridStats* stats = last_stats(run);
      if (stats != nullptr && (best == nullptr || *score_of(*stats) < *score_of(*best))) best = stats;
    }
    return picked(best, pick);
  };
}

Figure settled(Pick pick) {
  return [=](const Trial& trial) {
    return mean_of(over_runs(trial, [&](const StudyRun& run) { return last_change(run, pick); }));
  };
}

Figure change_since(std::size_t iteration, Pick pick) {
  return [=](const Trial& trial) {
    return mean_of(over_runs(trial, [&](const StudyRun& run) -> std::optional<double> {
      const auto then = picked(stats_at(run, iteration), pick);
      const auto now = picked(last_stats(run), pick);
      return then && now ? std::optional(*now - *then) : std::nullopt;
    }));
  };
}

std::vector<double> Pairs::differences() const {
  std::vector<double> values;
  for (std::size_t i = 0; i < li.size(); ++i) values.push_back(yin[i] - li[i]);
  return values;
}

std::vector<double> Pairs::percent() const {
  std::vector<double> values;
  for (std::size_t i = 0; i < li.size(); ++i)
    if (li[i] != 0) values.push_back(100 * (yin[i] - li[i]) / li[i]);
  return values;
}

Pairs pairs(const Comparison& comparison, const Figure& figure) {
  Pairs pairs;
  for (std::size_t map = 0; map < comparison.maps(); ++map) {
    const auto li = figure(comparison.li_on(map));
    const auto yin = figure(comparison.yin_on(map));
    if (!li || !yin) continue;
    pairs.li.push_back(*li);
    pairs.yin.push_back(*yin);
  }
  return pairs;
}

std::optional<Interval> variance_change(const Comparison& comparison) {
  const Pairs both = pairs(comparison, final_variance(length_of));
  const auto ratio = ratio_interval(both.yin, both.li);
  if (!ratio) return std::nullopt;
  const auto percent = [](double share) { return 100 * (share - 1); };
  return Interval{.value = percent(ratio->value), .low = percent(ratio->low), .high = percent(ratio->high)};
}

std::optional<double> mean_of(const std::vector<double>& values) {
  const auto summary = summarize(values);
  return summary ? std::optional(summary->mean) : std::nullopt;
}

FirstIterations first_iterations(const Comparison& comparison, std::size_t shift) {
  FirstIterations first;
  for (std::size_t map = 0; map < comparison.maps(); ++map) {
    const auto& of_li = comparison.li_on(map).runs;
    const auto& of_yin = comparison.yin_on(map).runs;
    for (std::size_t run = 0; run < of_li.size(); ++run) {
      const GridStats* li = stats_at(of_li[run], 1);
      const GridStats* yin = stats_at(of_yin[(run + shift) % of_yin.size()], 1);
      if (li == nullptr || yin == nullptr) continue;
      ++first.pairs;
      if (same(li->best.length_cells, yin->best.length_cells)) continue;
      ++first.unequal;
      if (same(li->best.height_deviation_m, yin->best.height_deviation_m)) ++first.same_height;
      if (li->best.turns == yin->best.turns) ++first.same_turns;
    }
  }
  return first;
}

}  // namespace alate::yin2021
