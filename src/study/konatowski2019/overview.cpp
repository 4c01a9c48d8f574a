#include "study/konatowski2019/overview.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "out/text.hpp"
#include "study/page/study_tables.hpp"

namespace alate::konatowski2019 {

namespace {

/// The best cost known before, or a better one of these runs.
double best_known(const Study& study, std::size_t case_index) {
  const double before = layouts()[case_index / kPublished.size()].best_known[case_index % kPublished.size()];
  const Trial* best = study.main.best_trial(case_index);
  return best == nullptr ? before : std::min(before, best->best()->metrics.cost);
}

std::string method_row(const Study& study, std::size_t method) {
  std::string cells;
  double wall_s = 0;
  for (std::size_t c = 0; c < study.main.cases.size(); ++c) {
    const Trial& trial = study.main.at(c, method);
    const auto summary = trial.summary();
    const double known = best_known(study, c);
    const auto above = summary ? std::optional(100 * (summary->mean - known) / known) : std::nullopt;
    cells += fmt::format("<td class=\"num\">{}</td>", fixed(above, 2));
    wall_s += study.main.cell(trial).wall_s / static_cast<double>(study.main.cases.size());
  }
  const StudyMethod& named = study.main.methods[method];
  return fmt::format(
      "<tr><th scope=\"row\">{}<br/><span class=\"soft\">{}</span></th>{}<td class=\"num\">{}</td></tr>\n",
      xml_escape(named.name), xml_escape(named.help), cells, milliseconds(wall_s));
}

}  // namespace

std::string overview_table(const Study& study) {
  std::vector<std::string> heads;
  for (const StudyCase& each : study.main.cases) heads.push_back(each.name);
  heads.emplace_back("Time, ms");
  std::string rows;
  for (std::size_t m = 0; m < study.main.methods.size(); ++m) rows += method_row(study, m);
  return "<p class=\"lead\">How far the mean cost lies above the best cost known, in percent. A case is a layout and "
         "its "
         "fuel weight; fuel and threat weights sum to 1.</p>\n" +
         study_table({"Method"}, heads, rows);
}

}  // namespace alate::konatowski2019
