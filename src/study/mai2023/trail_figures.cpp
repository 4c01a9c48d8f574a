#include "study/mai2023/trail_figures.hpp"

#include <algorithm>
#include <cmath>

namespace alate::mai2023 {

namespace {

/// Eq. (17).
double deposit(const ParamValues& values, const IterationStats& stats, double lambda) {
  return values.number("q") / ((1 - lambda) * *stats.best + lambda * *stats.best_so_far);
}

/// Eq. (19): of iteration t, counted from 1.
double lambda_of(const ParamValues& values, std::size_t t) {
  const auto every = static_cast<std::size_t>(values.integer("lambda_every"));
  const std::size_t decays = (t - 1) / every;
  return values.number("lambda") * std::pow(values.number("lambda_decay"), static_cast<double>(decays));
}

template <class Use>
void for_each_deposit(const Trial& trial, const Use& use) {
  for (const StudyRun& run : trial.runs)
    for (std::size_t t = 1; t <= run.plan.history.size(); ++t)
      if (run.plan.history[t - 1].best) use(run, t);
}

}  // namespace

std::optional<double> ants_mean(const Trial& trial, std::size_t from, std::size_t to) {
  std::vector<double> values;
  for (const StudyRun& run : trial.runs)
    for (std::size_t t = from; t <= std::min(to, run.plan.history.size()); ++t)
      if (const auto& mean = run.plan.history[t - 1].mean) values.push_back(*mean);
  const auto summary = summarize(values);
  return summary ? std::optional(summary->mean) : std::nullopt;
}

double scheduled_q0(double initial, std::size_t n, std::size_t count) {
  const auto now = static_cast<double>(n);
  const auto all = static_cast<double>(count);
  if (10 * n < 7 * count) return (all - now) / all * initial;
  return (now - 0.7 * all) / all * initial + initial / 2;
}

std::optional<FixedPoints> fixed_points(const Trial& trial) {
  const ParamValues& values = trial.planner.parameters;
  std::vector<double> points;
  for_each_deposit(trial, [&](const StudyRun& run, std::size_t t) {
    points.push_back(deposit(values, run.plan.history[t - 1], lambda_of(values, t)) / values.number("evaporation"));
  });
  if (points.empty()) return std::nullopt;
  const auto [least, greatest] = std::ranges::minmax(points);
  return FixedPoints{.least = least, .greatest = greatest};
}

std::optional<double> effect_of_decay_percent(const Trial& trial) {
  const ParamValues& values = trial.planner.parameters;
  std::vector<double> effects;
  for_each_deposit(trial, [&](const StudyRun& run, std::size_t t) {
    const auto& history = run.plan.history;
    if (10 * t <= 9 * history.size()) return;
    const double printed = deposit(values, history[t - 1], lambda_of(values, t));
    const double steady = deposit(values, history[t - 1], values.number("lambda"));
    effects.push_back(100 * std::abs(printed / steady - 1));
  });
  const auto summary = summarize(effects);
  return summary ? std::optional(summary->mean) : std::nullopt;
}

double dead_ends_percent(const Trial& trial) {
  double ended = 0;
  double ants = 0;
  for (const StudyRun& run : trial.runs) {
    ended += static_cast<double>(run.plan.counters.at("dead_ends"));
    ants += static_cast<double>(run.plan.counters.at("iterations") *
                                static_cast<std::uint64_t>(trial.planner.parameters.integer("ants")));
  }
  return ants == 0 ? 0 : 100 * ended / ants;
}

}  // namespace alate::mai2023
