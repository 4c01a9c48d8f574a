#include "study/zhou2020/reproduction.hpp"

#include "study/run_settings.hpp"
#include "study/zhou2020/claims.hpp"
#include "study/zhou2020/defects.hpp"
#include "study/zhou2020/page.hpp"

namespace alate::zhou2020 {

std::optional<Reproduction> reproduce(Executor& executor, const ReproduceOptions& options) {
  Study study = plan_study(options);
  if (!run_experiments({&study.exact, &study.methods}, executor, options)) return std::nullopt;
  Reproduction result{.paper = "zhou2020",
                      .title = "Zhou et al. 2020, routes through correction points",
                      .defects = defects(study),
                      .settings = run_settings(options.seeds.value_or(kSeeds), executor.threads())};
  append_methods(study.methods, result.settings);
  const std::vector<JudgedRow> rows = judge_rows(study);
  for (const JudgedRow& row : rows) result.claims.push_back(row.claim);
  for (const Experiment* experiment : {&study.exact, &study.methods})
    for (const Trial& trial : experiment->trials) result.cells.push_back(experiment->cell(trial));
  result.page = page_html(study, rows, result);
  return result;
}

}  // namespace alate::zhou2020
