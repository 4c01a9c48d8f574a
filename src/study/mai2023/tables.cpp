#include "study/mai2023/tables.hpp"

#include <fmt/core.h>

#include "out/text.hpp"
#include "study/page/study_tables.hpp"

namespace alate::mai2023 {

namespace {

std::string number_cell(const std::string& text) { return fmt::format("<td class=\"num\">{}</td>", text); }

std::string row(const std::string& head, const std::string& remark, const std::string& cells) {
  return fmt::format("<tr><th scope=\"row\">{}<br/><span class=\"soft\">{}</span></th>{}</tr>\n", xml_escape(head),
                     xml_escape(remark), cells);
}

/// Times differ by orders of magnitude.
int decimals_of(Measure measure, double value) {
  return measure == kTime && value < 10 ? 2 : words_of(measure).decimals;
}

/// The mean, and below it "120.1 to 131.4, sd 2.31".
std::string measure_cell(const std::optional<Summary>& summary, Measure measure) {
  if (!summary) return number_cell("–");
  const int decimals = decimals_of(measure, summary->mean);
  const std::string spread = summary->count < 2
                                 ? ""
                                 : fmt::format(
                                       "<br/><span class=\"soft interval\">{:.{}f} to {:.{}f}</span><br/><span "
                                       "class=\"soft interval\">sd {}</span>",
                                       summary->least, decimals, summary->greatest, decimals,
                                       fixed(summary->sd, decimals_of(measure, summary->sd.value_or(0))));
  return number_cell(fmt::format("{:.{}f}{}", summary->mean, decimals, spread));
}

std::string change_cell(const std::optional<Interval>& found, int decimals) {
  if (!found) return number_cell("–");
  return number_cell(fmt::format("{:+.{}f}<br/><span class=\"soft interval\">{:.{}f} to {:.{}f}</span>", found->value,
                                 decimals, found->low, decimals, found->high, decimals));
}

}  // namespace

std::string methods_table(const Study& study, Scene scene) {
  std::string rows;
  for (const StudyMethod& method : study.main.methods) {
    const Trial& trial = study.trial(scene, method.name);
    std::string cells = number_cell(fmt::format("{} of {}", trial.costs().size(), trial.runs.size()));
    cells += measure_cell(summary_of(trial, kFitness), kFitness);
    cells += number_cell(fixed(gap_percent(study, scene, method.name), 1));
    for (const Measure measure : {kLength, kIteration, kTime})
      cells += measure_cell(summary_of(trial, measure), measure);
    rows += row(method.name, method.help, cells);
  }
  return study_table(
      {"Method"}, {"Routes", "Fitness F", "Above the least F, %", "Length, km", "Last change, iteration", "Time, ms"},
      rows);
}

std::string readings_table(const Study& study, Scene scene) {
  std::string rows;
  for (std::size_t r = 0; r < readings().size(); ++r) {
    const Trial& aco = study.trial(r, scene, kAco);
    const Trial& mai = study.trial(r, scene, kMai);
    std::string cells;
    for (const Measure measure : {kFitness, kLength, kIteration})
      cells += change_cell(change(aco, mai, measure), measure == kIteration ? 0 : 2);
    for (const Trial* trial : {&aco, &mai}) {
      const auto length = summary_of(*trial, kLength);
      cells += number_cell(length ? fmt::format("{:.2f}", length->mean) : "–");
    }
    rows += row(readings()[r].name, readings()[r].help, cells);
  }
  return study_table(
      {"Reading"},
      {"Change of F, %", "Of the length, %", "Of the last change, iterations", "Length of ACO, km", "Of Mai 2023, km"},
      rows);
}

}  // namespace alate::mai2023
