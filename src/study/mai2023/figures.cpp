#include "study/mai2023/figures.hpp"

#include <algorithm>

#include "study/mai2023/fitness.hpp"

namespace alate::mai2023 {

namespace {

constexpr double kKm = 1000;

bool ranks_by_fitness(const Trial& trial) { return trial.planner.parameters.text("fitness") == "paper"; }

std::optional<double> fitness(const Trial& trial, const StudyRun& run) {
  constexpr double kStep_m = 1000;  // the planes of the paper's lattice
  if (ranks_by_fitness(trial)) return run.plan.history.empty() ? std::nullopt : run.plan.history.back().best_so_far;
  const std::vector<Vec3> places = cut_by_planes(run.plan.route, kStep_m);
  return places.empty() ? std::nullopt : std::optional(fitness_of(places).sum());
}

}  // namespace

const MeasureWords& words_of(Measure measure) {
  static const std::array<MeasureWords, kMeasures.size()> words{{{"fitness", "Fitness F", "%", 2},
                                                                 {"length", "Length, km", "%", 2},
                                                                 {"iterations", "Last change", "iterations", 0},
                                                                 {"time", "Time, ms", "%", 0}}};
  return words[measure];
}

std::optional<double> figure(const Trial& trial, const StudyRun& run, Measure measure) {
  constexpr double kMilli = 1000;
  if (!run.passed) return std::nullopt;
  if (measure == kFitness) return fitness(trial, run);
  if (measure == kLength) return run.metrics.length_m / kKm;
  if (measure == kIteration) return static_cast<double>(run.plan.counters.at("last_change"));
  return kMilli * run.wall_s;
}

std::vector<double> figures(const Trial& trial, Measure measure) {
  std::vector<double> values;
  for (const StudyRun& run : trial.runs)
    if (const auto value = figure(trial, run, measure)) values.push_back(*value);
  return values;
}

std::optional<Summary> summary_of(const Trial& trial, Measure measure) { return summarize(figures(trial, measure)); }

std::optional<double> fitness_after(const Trial& trial, std::size_t iteration) {
  std::vector<double> values;
  for (const StudyRun& run : trial.runs) {
    const auto& history = run.plan.history;
    if (history.empty()) continue;
    if (const auto& best = history[std::min(iteration, history.size()) - 1].best_so_far) values.push_back(*best);
  }
  const auto summary = summarize(values);
  return summary ? std::optional(summary->mean) : std::nullopt;
}

std::optional<Interval> change(const Trial& from, const Trial& to, Measure measure) {
  std::vector<double> first;
  std::vector<double> second;
  for (std::size_t i = 0; i < std::min(from.runs.size(), to.runs.size()); ++i) {
    const auto a = figure(from, from.runs[i], measure);
    const auto b = figure(to, to.runs[i], measure);
    if (!a || !b) continue;
    first.push_back(*a);
    second.push_back(*b);
  }
  if (measure == kIteration) {
    std::ranges::transform(second, first, second.begin(), std::minus());
    return mean_interval(second);
  }
  const auto percent = [](double ratio) { return 100 * (ratio - 1); };
  const auto ratio = ratio_interval(second, first);
  if (!ratio) return std::nullopt;
  return Interval{.value = percent(ratio->value), .low = percent(ratio->low), .high = percent(ratio->high)};
}

std::optional<double> gap_percent(const Study& study, Scene scene, std::string_view method) {
  const auto summary = summary_of(study.trial(scene, method), kFitness);
  return summary ? std::optional(100 * (summary->mean / study.optimum[scene].score - 1)) : std::nullopt;
}

std::optional<std::size_t> reaches(const Trial& trial, double fitness) {
  std::size_t iterations = 0;
  for (const StudyRun& run : trial.runs) iterations = std::max(iterations, run.plan.history.size());
  for (std::size_t iteration = 1; iteration <= iterations; ++iteration)
    if (const auto now = fitness_after(trial, iteration); now && *now <= fitness) return iteration;
  return std::nullopt;
}

}  // namespace alate::mai2023
