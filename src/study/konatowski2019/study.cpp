#include "study/konatowski2019/study.hpp"

#include <algorithm>

namespace alate::konatowski2019 {

namespace {

/// Without threats only these are needed: the paper's own, and two that find the cheapest route.
std::vector<StudyMethod> methods_in_the_open(const ReproduceOptions& options) {
  std::vector<StudyMethod> all = methods(options.iterations);
  std::erase_if(all, [](const StudyMethod& method) {
    constexpr std::array kKept{kLiteral20, kLiteral, kLiteral100, kBeam, kGuided};
    return std::ranges::find(kKept, method.name) == kKept.end();
  });
  return all;
}

}  // namespace

Study plan_study(const ReproduceOptions& options) {
  std::vector<StudyCase> cases;
  for (const Layout& layout : layouts())
    for (const Published& row : kPublished) cases.push_back(make_case(layout, row));
  std::vector<StudyCase> open;
  open.push_back(make_case(open_layout(), kPublished.back()));
  return {.main = plan_experiment(std::move(cases), methods(options.iterations), options.seeds.value_or(kSeeds)),
          .open = plan_experiment(std::move(open), methods_in_the_open(options), options.seeds.value_or(kSeeds))};
}

const Trial& Study::trial(std::size_t layout, std::size_t row, std::string_view method) const {
  return main.at(case_of(layout, row), method_index(main, method));
}

const Route* Study::base_route() const {
  const Trial* trial = open.best_trial(0);
  return trial == nullptr ? nullptr : &trial->best()->plan.route;
}

double gain_percent(double from, double to) { return 100 * (from - to) / from; }

std::optional<double> gain_over_first(const Trial& trial) {
  std::vector<double> gains;
  for (const StudyRun& run : trial.runs) {
    const auto first =
        std::ranges::find_if(run.plan.history, [](const auto& it) { return it.best_so_far.has_value(); });
    if (run.passed && first != run.plan.history.end())
      gains.push_back(gain_percent(*first->best_so_far, run.metrics.cost));
  }
  const auto summary = summarize(gains);
  return summary ? std::optional(summary->mean) : std::nullopt;
}

Duel duel(const Study& study, std::string_view first, std::string_view second) {
  Duel duel;
  const std::size_t a = method_index(study.main, first);
  const std::size_t b = method_index(study.main, second);
  for (std::size_t c = 0; c < study.main.cases.size(); ++c) {
    const auto of_a = study.main.at(c, a).summary();
    const auto of_b = study.main.at(c, b).summary();
    if (!of_a || !of_b) continue;
    ++duel.cells;
    if (of_a->mean < of_b->mean) ++duel.won;
    duel.saving_percent += gain_percent(of_b->mean, of_a->mean);
  }
  if (duel.cells > 0) duel.saving_percent /= static_cast<double>(duel.cells);
  return duel;
}

}  // namespace alate::konatowski2019
