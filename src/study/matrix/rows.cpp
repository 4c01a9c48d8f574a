// The tables of a study.
#include <fmt/core.h>

#include "alate/data/height_grid.hpp"
#include "alate/study/study.hpp"
#include "out/text.hpp"
#include "study/matrix/optimum.hpp"

namespace alate {

namespace {

/// scenario,planner,preset,seed,budget
std::string job_cells(const Study& study, const StudyJob& job) {
  const StudyPlanner& planner = study.planners[job.planner];
  return fmt::format("{},{},{},{},{}", csv_cell(study.scenarios[job.scenario].name), csv_cell(planner.name),
                     csv_cell(planner.preset), job.seed, study.budgets[job.budget].text());
}

/// length,height_dev,turns,composite
std::string size_cells(const StudyRecord& record) {
  if (!record.has_route()) return ",,,";
  if (!record.grid) return round_trip(record.length_m) + ",,,";
  return fmt::format("{},{},{},{}", round_trip(record.length_m), round_trip(record.grid->height_deviation_m),
                     record.grid->turns, round_trip(composite_index(*record.grid)));
}

std::string row(const Study& study, const StudyJob& job, const StudyRecord& record, const Optima& optima) {
  const auto optimum = optima.of(job);
  const std::string cost = record.has_route() ? round_trip(record.cost) : "";
  const std::string last = record.improvements.empty() ? "" : std::to_string(record.improvements.back().first);
  return fmt::format("{},{},{},{},{},{},{},{},{}\n", job_cells(study, job), to_string(record.outcome), cost,
                     size_cells(record), last, round_trip(record.lower_bound), round_trip(optimum),
                     round_trip(gap_of(record, optimum)), record.valid);
}

std::string refused_row(const StudyPlanner& planner, const StudyScenario& scenario) {
  return fmt::format("{},{},{},,,refused,,,,,,,,,,false\n", csv_cell(scenario.name), csv_cell(planner.name),
                     csv_cell(planner.preset));
}

}  // namespace

std::string rows_csv(const Study& study, const StudyRecords& records) {
  const Optima optima(study, records);
  std::string text =
      "scenario,planner,preset,seed,budget,outcome,cost,length,height_dev,turns,composite,last_change,lower_bound,"
      "optimum,gap,valid\n";
  for (std::size_t i = 0; i < records.size(); ++i)
    if (records[i] && !study.jobs[i].reference) text += row(study, study.jobs[i], *records[i], optima);
  for (const StudyRefusal& refusal : study.refusals)
    for (const StudyScenario& scenario : study.scenarios)
      if (scenario.group == refusal.group) text += refused_row(study.planners[refusal.planner], scenario);
  return text;
}

std::string times_csv(const Study& study, const StudyRecords& records) {
  std::string text = "scenario,planner,preset,seed,budget,wall_s\n";
  for (std::size_t i = 0; i < records.size(); ++i) {
    if (!records[i] || study.jobs[i].reference) continue;
    text += fmt::format("{},{}\n", job_cells(study, study.jobs[i]), round_trip(records[i]->wall_s));
  }
  return text;
}

}  // namespace alate
