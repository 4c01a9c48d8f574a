// A comparison for terminals and for other programs.
#include <fmt/core.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "alate/core/version.hpp"
#include "out/json_parts.hpp"
#include "out/output_folder.hpp"
#include "out/text.hpp"
#include "study/compare/figures.hpp"
#include "study/machine.hpp"

namespace alate {

namespace {

using Json = nlohmann::ordered_json;

Json finite(double value) { return number(std::optional(value)); }

Json figures_json(const Comparison& comparison, std::size_t contender) {
  Json times = Json::array();
  for (std::size_t time = 0; time < comparison.times_s.size(); ++time) {
    const CompareFigures figures = figures_of(comparison, contender, time);
    const auto& cost = figures.cost;
    times.push_back({{"time_s", comparison.times_s[time]},
                     {"runs", figures.runs},
                     {"passed", figures.costs.size()},
                     {"refused", figures.refused},
                     {"late", figures.late},
                     {"none", figures.none},
                     {"median", finite(figures.median)},
                     {"mean", cost ? finite(cost->mean) : Json()},
                     {"sd", cost ? number(cost->sd) : Json()},
                     {"least", cost ? finite(cost->least) : Json()},
                     {"greatest", cost ? finite(cost->greatest) : Json()}});
  }
  return times;
}

Json contenders_json(const Comparison& comparison) {
  Json all = Json::array();
  for (std::size_t c = 0; c < comparison.contenders.size(); ++c) {
    const Contender& each = comparison.contenders[c];
    all.push_back({{"name", each.name},
                   {"preset", each.preset.empty() ? Json() : Json(each.preset)},
                   {"peer", each.peer},
                   {"times", figures_json(comparison, c)}});
  }
  return all;
}

Json runs_json(const Comparison& comparison) {
  Json all = Json::array();
  for (const CompareRun& run : comparison.runs)
    all.push_back({{"planner", comparison.contenders[run.contender].name},
                   {"seed", run.seed},
                   {"ending", run.ending},
                   {"note", run.note.empty() ? Json() : Json(run.note)},
                   {"routes", run.routes},
                   {"refused", run.refused},
                   {"route", route_json(comparison.world.site(), run.route)}});
  return all;
}

std::string csv_line(const Comparison& comparison, const CompareRun& run, std::size_t time) {
  const Contender& who = comparison.contenders[run.contender];
  const CompareMark& mark = run.marks[time];
  const auto size = [&](double value) { return mark.has_route() ? round_trip(value) : ""; };
  const Metrics& metrics = mark.metrics;
  return fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{}\n", csv_cell(who.name), csv_cell(who.preset), who.peer,
                     run.seed, round_trip(comparison.times_s[time]), to_string(mark.standing), size(metrics.cost),
                     size(metrics.length_m), size(metrics.climb_m), size(metrics.threat), round_trip(mark.took_s),
                     csv_cell(mark.broken), run.ending);
}

}  // namespace

std::string to_text(const Comparison& comparison) {
  std::string text;
  if (comparison.stopped) text += "Stopped before all runs were made.\n";
  for (const std::string& each : findings(comparison)) text += each + "\n";
  text += fmt::format("\nMedian cost of routes that pass the check, seeds 1 to {}:\n{:<24}", comparison.seeds, "");
  for (const double time : comparison.times_s) text += fmt::format(" {:>10}", time_words(time));
  text += fmt::format(" {:>10}\n", "passed");
  for (const CompareFigures& each : ranking(comparison, comparison.times_s.size() - 1)) {
    text += fmt::format("{:<24}", comparison.contenders[each.contender].name);
    for (std::size_t time = 0; time < comparison.times_s.size(); ++time)
      text += fmt::format(" {:>10}", cost_words(figures_of(comparison, each.contender, time).median));
    text += fmt::format(" {:>10}\n", fmt::format("{} of {}", each.costs.size(), each.runs));
  }
  for (const std::string& note : comparison.notes) text += note + "\n";
  std::string refused;
  for (const CompareRefusal& each : comparison.refusals) refused += (refused.empty() ? "" : ", ") + each.name;
  return refused.empty() ? text : text + fmt::format("Cannot plan this (the page and JSON say why): {}.\n", refused);
}

std::string to_json(const Comparison& comparison) {
  const Machine machine = this_machine();
  const Site& site = comparison.world.site();
  Json refusals = Json::array();
  for (const CompareRefusal& each : comparison.refusals) refusals.push_back({{"name", each.name}, {"why", each.why}});
  const Json json{{"schema", 1},
                  {"alate", version()},
                  {"scenario", site.scenario.file},
                  {"overrides", site.scenario.overrides},
                  {"seconds", comparison.times_s.back()},
                  {"seeds", comparison.seeds},
                  {"stopped", comparison.stopped},
                  {"findings", findings(comparison)},
                  {"best_cost", number(best_cost(comparison))},
                  {"lower_bound", finite(comparison.lower_bound)},
                  {"contenders", contenders_json(comparison)},
                  {"refusals", refusals},
                  {"notes", comparison.notes},
                  {"machine", {{"processor", machine.processor}, {"compiler", machine.compiler}}},
                  {"runs", runs_json(comparison)}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string compare_csv(const Comparison& comparison) {
  std::string text = "planner,preset,peer,seed,time_s,standing,cost,length_m,climb_m,threat,took_s,broken,ending\n";
  for (const CompareRun& run : comparison.runs)
    for (std::size_t time = 0; time < comparison.times_s.size(); ++time) text += csv_line(comparison, run, time);
  return text;
}

CompareFolder::CompareFolder(const std::string& folder) : output_(std::make_unique<OutputFolder>(folder)) {}
CompareFolder::~CompareFolder() = default;

std::vector<std::string> CompareFolder::write(const Comparison& comparison) {
  output_->write("compare.html", compare_html(comparison));
  output_->write("rows.csv", compare_csv(comparison));
  output_->write("result.json", to_json(comparison));
  output_->publish();
  return {"compare.html", "rows.csv", "result.json"};
}

}  // namespace alate
