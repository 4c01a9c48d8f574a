#include "study/konatowski2019/reproduction.hpp"

#include "study/konatowski2019/claims.hpp"
#include "study/konatowski2019/defects.hpp"
#include "study/konatowski2019/page.hpp"
#include "study/run_settings.hpp"

namespace alate::konatowski2019 {

namespace {

RunSettings settings(const Study& study, const ReproduceOptions& options, int threads) {
  RunSettings all = run_settings(options.seeds.value_or(kSeeds), threads);
  all.emplace_back("goal_tolerance", study.main.cases.front().site().mission.tolerance_m);
  all.emplace_back("step_limit", kStepLimit);
  append_methods(study.main, all);
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
