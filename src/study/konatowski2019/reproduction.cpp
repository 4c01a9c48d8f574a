#include "study/konatowski2019/reproduction.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "alate/core/version.hpp"
#include "study/konatowski2019/claims.hpp"
#include "study/konatowski2019/defects.hpp"
#include "study/konatowski2019/page.hpp"
#include "study/machine.hpp"

namespace alate::konatowski2019 {

namespace {

using Settings = std::vector<std::pair<std::string, ParamValue>>;

/// "attitude-aco, preset acs: ants=50 ...", with the iterations if they were set.
std::string method_text(const StudyMethod& method, const ChosenPlanner& planner) {
  std::string text = fmt::format("{}, preset {}:", planner.name, planner.preset);
  for (const auto& [name, value] : planner.parameters.all()) text += fmt::format(" {}={}", name, to_text(value));
  if (method.iterations) text += fmt::format(", {} iterations", *method.iterations);
  return text;
}

Settings settings(const Study& study, const ReproduceOptions& options, int threads) {
  const Machine machine = this_machine();
  Settings all{{"alate", version()},
               {"seeds", fmt::format("1 to {}", options.seeds)},
               {"runs_without_chance", std::int64_t{1}},
               {"goal_tolerance", study.main.cases.front().site().mission.tolerance_m},
               {"step_limit", kStepLimit},
               {"threads", std::int64_t{threads}},
               {"threads_per_run", std::int64_t{1}},
               {"processor", machine.processor},
               {"cores", static_cast<std::int64_t>(machine.cores)},
               {"compiler", machine.compiler}};
  for (std::size_t m = 0; m < study.main.methods.size(); ++m)
    all.emplace_back("method " + study.main.methods[m].name,
                     method_text(study.main.methods[m], study.main.at(0, m).planner));
  for (const Layout& layout : layouts()) all.emplace_back("layout " + layout.name, layout.scenario);
  return all;
}

}  // namespace

std::optional<Reproduction> reproduce(Executor& executor, const ReproduceOptions& options) {
  Study study = plan_study(options);
  if (!run_experiments({&study.main, &study.open}, executor, options)) return std::nullopt;
  Reproduction result{.paper = "konatowski2019",
                      .title = "Konatowski and Pawłowski 2019, ant colony on attitudes",
                      .claims = claims(study),
                      .defects = defects(study),
                      .settings = settings(study, options, executor.threads())};
  for (const Experiment* experiment : {&study.main, &study.open})
    for (const Trial& trial : experiment->trials) result.cells.push_back(experiment->cell(trial));
  result.page = page_html(study, result);
  return result;
}

}  // namespace alate::konatowski2019
