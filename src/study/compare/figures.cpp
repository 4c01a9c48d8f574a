#include "study/compare/figures.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "study/spread.hpp"

namespace alate {

namespace {

double cost_of(const CompareMark& mark) {
  return mark.standing == Standing::passed ? mark.metrics.cost : std::numeric_limits<double>::infinity();
}

const std::string& name_of(const Comparison& comparison, const CompareFigures& figures) {
  return comparison.contenders[figures.contender].name;
}

std::string listed(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
    text += (i == 0 ? "" : i + 1 == words.size() ? " and " : ", ") + words[i];
  return text;
}

/// Who leads from one time to another.
struct Reign {
  std::optional<std::size_t> leader;  ///< A contender; nothing while none solves it.
  std::size_t from = 0, to = 0;       ///< Times.
};

std::vector<Reign> reigns_of(const Comparison& comparison) {
  std::vector<Reign> reigns;
  for (std::size_t time = 0; time < comparison.times_s.size(); ++time) {
    const auto ranks = ranking(comparison, time);
    const auto leader =
        !ranks.empty() && ranks.front().solves() ? std::optional(ranks.front().contender) : std::nullopt;
    if (reigns.empty() || reigns.back().leader != leader) reigns.push_back({.leader = leader, .from = time});
    reigns.back().to = time;
  }
  return reigns;
}

std::string span_words(const Comparison& comparison, const Reign& reign) {
  const std::string from = time_words(comparison.times_s[reign.from]);
  if (reign.from == reign.to) return "With " + from;
  return fmt::format("From {} to {}", from, time_words(comparison.times_s[reign.to]));
}

std::string reign_sentence(const Comparison& comparison, const Reign& reign) {
  const std::string span = span_words(comparison, reign);
  if (!reign.leader) return span + " no planner has a route that passes the check in at least half of its runs.";
  const auto ranks = ranking(comparison, reign.to);
  const CompareFigures& best = ranks.front();
  std::string text =
      fmt::format("{} {} is best: median cost {}", span, name_of(comparison, best), cost_words(best.median));
  if (reign.from != reign.to) text += fmt::format(" after {}", time_words(comparison.times_s[reign.to]));
  if (best.costs.size() < best.runs) text += fmt::format(", in {} of {} runs", best.costs.size(), best.runs);
  if (ranks.size() < 2 || !ranks[1].solves())
    return text + "; no other has a route that passes in at least half of its runs.";
  const double ahead = 100 * (ranks[1].median / best.median - 1);
  return text + fmt::format("; {} comes next, {:.2f} % above.", name_of(comparison, ranks[1]), ahead);
}

/// Where ours and the best of the others stand to each other at the last time.
std::string peers_sentence(const Comparison& comparison) {
  const auto ranks = ranking(comparison, comparison.times_s.size() - 1);
  const auto best_of = [&](bool peer) {
    return std::ranges::find_if(
        ranks, [&](const auto& each) { return comparison.contenders[each.contender].peer == peer && each.solves(); });
  };
  const auto own = best_of(false);
  const auto peer = best_of(true);
  if (own == ranks.end() || peer == ranks.end()) return "";
  return fmt::format("With {} the best of ours, {}, costs {:.4f} times what the best of the others does, {}.",
                     time_words(comparison.times_s.back()), name_of(comparison, *own), own->median / peer->median,
                     name_of(comparison, *peer));
}

/// Why the runs of one contender failed when all time was up; empty if none did.
std::string failure_sentence(const Comparison& comparison, const CompareFigures& figures) {
  std::vector<std::string> parts;
  std::map<std::string, std::size_t> rules;
  for (const CompareRun& run : comparison.runs)
    if (run.contender == figures.contender && run.marks.back().standing == Standing::refused)
      ++rules[run.marks.back().broken];
  for (const auto& [rule, count] : rules)
    parts.push_back(fmt::format("in {} the check refuses the route ({})", count, rule));
  if (figures.late > 0) parts.push_back(fmt::format("in {} it came too late", figures.late));
  if (figures.none > 0) parts.push_back(fmt::format("in {} there was none", figures.none));
  if (parts.empty()) return "";
  return fmt::format("{} failed in {} of {} runs: {}.", name_of(comparison, figures),
                     figures.runs - figures.costs.size(), figures.runs, listed(parts));
}

std::string ending_sentence(const Comparison& comparison, std::size_t contender) {
  std::map<std::string, std::size_t> endings;
  std::string note;
  for (const CompareRun& run : comparison.runs) {
    if (run.contender != contender || run.ending == "finished") continue;
    ++endings[run.ending];
    note = run.note;
  }
  std::vector<std::string> parts;
  for (const auto& [ending, count] : endings) parts.push_back(fmt::format("{} {} times", ending, count));
  if (parts.empty()) return "";
  return fmt::format("{} did not end well: {} ({}).", comparison.contenders[contender].name, listed(parts), note);
}

}  // namespace

bool CompareFigures::solves() const { return std::isfinite(median); }

std::string cost_words(double cost) {
  if (!std::isfinite(cost)) return "–";
  constexpr int kDigits = 5;
  const int before = cost > 0 ? static_cast<int>(std::floor(std::log10(cost))) + 1 : 1;
  return fmt::format("{:.{}f}", cost, std::clamp(kDigits - before, 1, kDigits));
}

std::string time_words(double seconds) {
  return seconds < 0.0995 ? fmt::format("{:.3g} ms", 1000 * seconds) : fmt::format("{:.3g} s", seconds);
}

CompareFigures figures_of(const Comparison& comparison, std::size_t contender, std::size_t time) {
  CompareFigures figures{.contender = contender};
  std::vector<double> all;
  for (const CompareRun& run : comparison.runs) {
    if (run.contender != contender) continue;
    const CompareMark& mark = run.marks[time];
    ++figures.runs;
    figures.refused += mark.standing == Standing::refused ? 1U : 0U;
    figures.late += mark.standing == Standing::late ? 1U : 0U;
    figures.none += mark.standing == Standing::none ? 1U : 0U;
    all.push_back(cost_of(mark));
    if (mark.standing == Standing::passed) figures.costs.push_back(mark.metrics.cost);
  }
  figures.cost = summarize(figures.costs);
  figures.median = lower_median(std::move(all));
  for (const CompareRun& run : comparison.runs) {
    if (run.contender != contender || !run.marks[time].has_route()) continue;
    const bool is_median = cost_of(run.marks[time]) == figures.median;
    if (figures.typical == nullptr || (is_median && cost_of(figures.typical->marks[time]) != figures.median))
      figures.typical = &run;
  }
  return figures;
}

std::vector<CompareFigures> ranking(const Comparison& comparison, std::size_t time) {
  std::vector<CompareFigures> all;
  for (std::size_t c = 0; c < comparison.contenders.size(); ++c) all.push_back(figures_of(comparison, c, time));
  std::erase_if(all, [](const CompareFigures& each) { return each.runs == 0; });
  std::ranges::stable_sort(all, {}, &CompareFigures::median);
  return all;
}

std::optional<double> best_cost(const Comparison& comparison) {
  std::optional<double> best;
  for (const CompareRun& run : comparison.runs)
    for (const CompareMark& mark : run.marks)
      if (mark.standing == Standing::passed && (!best || mark.metrics.cost < *best)) best = mark.metrics.cost;
  return best;
}

std::vector<std::string> findings(const Comparison& comparison) {
  std::vector<std::string> all;
  if (comparison.runs.empty()) return {"Nothing was run to its end."};
  for (const Reign& reign : reigns_of(comparison)) all.push_back(reign_sentence(comparison, reign));
  all.push_back(peers_sentence(comparison));
  for (const CompareFigures& each : ranking(comparison, comparison.times_s.size() - 1)) {
    all.push_back(failure_sentence(comparison, each));
    all.push_back(ending_sentence(comparison, each.contender));
  }
  std::erase(all, "");
  return all;
}

}  // namespace alate
