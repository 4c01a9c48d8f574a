#include "study/mai2023/reproduction.hpp"

#include <fmt/core.h>

#include "study/mai2023/claims.hpp"
#include "study/mai2023/defects.hpp"
#include "study/mai2023/page.hpp"
#include "study/run_settings.hpp"

namespace alate::mai2023 {

namespace {

RunSettings settings(const Study& study, const ReproduceOptions& options, int threads) {
  RunSettings all = run_settings(options.seeds.value_or(kSeeds), threads);
  all.emplace_back("seeds_of_readings",
                   reading_seeds(options) == 0 ? "none" : fmt::format("1 to {}", reading_seeds(options)));
  all.emplace_back("confidence", std::string("95 %, percentile bootstrap over the runs, 2000 samples"));
  for (const Scene scene : kScenes)
    all.emplace_back(fmt::format("least_fitness_{}", kSceneNames[scene]), study.optimum[scene].score);
  append_methods(study.main, all);
  for (std::size_t r = 1; r < readings().size(); ++r) {
    RunSettings of_reading;
    append_methods(study.readings[r - 1], of_reading);
    for (auto& [name, value] : of_reading) all.emplace_back(name + ", " + readings()[r].name, std::move(value));
  }
  for (const Scene scene : kScenes)
    all.emplace_back(fmt::format("layout {}", kSceneNames[scene]), scenario_text(scene));
  return all;
}

/// A measure other than the cost.
Cell cell_of(const Experiment& experiment, const Trial& trial, Measure measure) {
  Cell cell = experiment.cell(trial);
  cell.case_name += fmt::format(", {}", words_of(measure).id);
  const auto summary = summary_of(trial, measure);
  cell.mean = summary ? std::optional(summary->mean) : std::nullopt;
  cell.sd = summary ? summary->sd : std::nullopt;
  cell.best = summary ? std::optional(summary->least) : std::nullopt;
  cell.worst = summary ? std::optional(summary->greatest) : std::nullopt;
  cell.lower_bound = 0;
  return cell;
}

void append_details(const Study& study, Reproduction& result) {
  for (const Measure measure : {kFitness, kIteration, kTime}) {
    for (const Trial& trial : study.main.trials) {
      Cell cell = cell_of(study.main, trial, measure);
      if (measure == kFitness) cell.lower_bound = study.optimum[trial.case_index].score;
      result.details.push_back(std::move(cell));
    }
  }
}

}  // namespace

std::optional<Reproduction> reproduce(Executor& executor, const ReproduceOptions& options) {
  Study study = plan_study(options);
  std::vector<Experiment*> experiments{&study.main};
  for (Experiment& reading : study.readings) experiments.push_back(&reading);
  if (!run_experiments(experiments, executor, options)) return std::nullopt;
  Reproduction result{.paper = "mai2023",
                      .title = "Mai et al. 2023, dual-strategy ant colony over terrain",
                      .notes = notes(),
                      .claims = claims(study),
                      .cells = {},
                      .details = {},
                      .defects = defects(study),
                      .settings = settings(study, options, executor.threads()),
                      .page = {}};
  for (const Trial& trial : study.main.trials) result.cells.push_back(study.main.cell(trial));
  append_details(study, result);
  result.page = page_html(study, result);
  return result;
}

}  // namespace alate::mai2023
