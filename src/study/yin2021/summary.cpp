#include "study/yin2021/summary.hpp"

#include <algorithm>
#include <cmath>

namespace alate::yin2021 {

namespace {

using Measured = double (*)(const GridMeasures&);

/// Mean over the runs of a trial that passed, of what the check measures.
Figure measured_mean(Measured measured) {
  return [=](const Trial& trial) {
    std::vector<double> values;
    for (const StudyRun& run : trial.runs)
      if (run.passed && run.metrics.grid) values.push_back(measured(*run.metrics.grid));
    return mean_of(values);
  };
}

/// Mean over the maps where the figure exists.
std::optional<double> over_maps(const Experiment& experiment, std::size_t method, const Figure& figure) {
  std::vector<double> values;
  for (std::size_t map = 0; map < experiment.cases.size(); ++map)
    if (const auto value = figure(experiment.at(map, method))) values.push_back(*value);
  return mean_of(values);
}

double true_score(const GridMeasures& measures) { return composite_index(measures); }

}  // namespace

Cell cell_over_maps(const SizeStudy& of_size, const Experiment& experiment, std::size_t method) {
  Cell total{.method = experiment.methods[method].name};
  const auto count = static_cast<double>(experiment.cases.size());
  for (std::size_t map = 0; map < experiment.cases.size(); ++map) {
    const Cell cell = experiment.cell(experiment.at(map, method));
    total.runs += cell.runs;
    total.found += cell.found;
    total.wall_s += cell.wall_s / count;
  }
  total.lower_bound = *mean_of(of_size.maps.optimum);
  const auto field = [&](const Figure& figure) { return over_maps(experiment, method, figure); };
  total.mean = field([&](const Trial& trial) { return experiment.cell(trial).mean; });
  total.best = field([&](const Trial& trial) { return experiment.cell(trial).best; });
  total.sd = field([&](const Trial& trial) {
    const auto sd = experiment.cell(trial).sd;
    return sd ? std::optional(*sd * *sd) : std::nullopt;
  });
  if (total.sd) total.sd = std::sqrt(*total.sd);
  return total;
}

Cell cell_on_map(const SizeStudy& of_size, std::size_t map, std::string_view method) {
  Cell cell = of_size.main.cell(of_size.trial(map, method));
  cell.lower_bound = of_size.maps.optimum[map];
  return cell;
}

MethodSummary summarize_method(const SizeStudy& of_size, std::string_view method) {
  const std::size_t m = method_index(of_size.main, method);
  const auto field = [&](const Figure& figure) { return over_maps(of_size.main, m, figure); };
  return {.cell = cell_over_maps(of_size, of_size.main, m),
          .height_dev = field(measured_mean([](const GridMeasures& g) { return g.height_deviation_m; })),
          .turns = field(measured_mean([](const GridMeasures& g) { return static_cast<double>(g.turns); })),
          .score = field(measured_mean(true_score)),
          .settled = field(settled(length_of))};
}

ReadingSummary summarize_reading(const Study& study, Size size, std::size_t reading) {
  const Comparison both = study.compare(size, reading);
  const Pairs lengths = pairs(both, final_mean(length_of));
  return {.length_percent = mean_interval(lengths.percent()),
          .variance_percent = variance_change(both),
          .score_percent = mean_interval(pairs(both, final_mean(score_of)).percent()),
          .turns = mean_interval(pairs(both, final_mean(turns_of)).differences()),
          .li_length = mean_of(lengths.li),
          .true_li_score = over_maps(*both.of_li, both.li, measured_mean(true_score))};
}

}  // namespace alate::yin2021
