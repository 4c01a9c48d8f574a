#include "study/zhou2020/tables.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include "out/text.hpp"
#include "study/page/study_tables.hpp"

namespace alate::zhou2020 {

namespace {

std::string word_cell(const std::string& text) { return fmt::format("<td>{}</td>", xml_escape(text)); }

std::string number_cell(const std::optional<double>& value, int decimals) {
  return fmt::format("<td class=\"num\">{}</td>", fixed(value, decimals));
}

std::optional<double> percent(const std::optional<double>& share) {
  return share ? std::optional(100 * *share) : std::nullopt;
}

template <class Count>
std::optional<double> as_number(const std::optional<Count>& count) {
  return count ? std::optional(static_cast<double>(*count)) : std::nullopt;
}

std::string row(const std::string& head, const std::string& cells) {
  return fmt::format("<tr><th scope=\"row\">{}</th>{}</tr>\n", xml_escape(head), cells);
}

/// With a remark under its head.
std::string row(const std::string& head, const std::string& remark, const std::string& cells) {
  return fmt::format("<tr><th scope=\"row\">{}<br/><span class=\"soft\">{}</span></th>{}</tr>\n", xml_escape(head),
                     xml_escape(remark), cells);
}

std::string published_row(const JudgedRow& judged_row) {
  const PublishedRoute& published = *judged_row.published;
  const JudgedRoute* judged = judged_row.judged && !judged_row.judged->route.empty() ? &*judged_row.judged : nullptr;
  const std::string cells = number_cell(published.length_m, 2) +
                            number_cell(judged != nullptr ? std::optional(judged->metrics.length_m) : std::nullopt, 2) +
                            number_cell(as_number(published.corrections), 0) +
                            number_cell(judged != nullptr ? as_number(judged->metrics.corrections) : std::nullopt, 0) +
                            number_cell(percent(published.probability), 0) +
                            number_cell(percent(judged != nullptr ? judged->metrics.probability : std::nullopt), 2) +
                            number_cell(percent(judged_row.gap), 2);
  const std::string state = !judged_row.judged              ? "route not printed"
                            : judged_row.judged->feasible() ? "keeps all limits"
                                                            : judged_row.judged->broken;
  return row(published.source, case_name(published.set, published.task) + ": " + state, cells);
}

const char* kind_words(PointKind kind) {
  switch (kind) {
    case PointKind::vertical:
      return "vertical";
    case PointKind::horizontal:
      return "horizontal";
    default:
      return "";
  }
}

}  // namespace

std::string routes_table(const std::vector<JudgedRow>& rows) {
  std::string html;
  for (const JudgedRow& each : rows) html += published_row(each);
  return study_table(
      {"Source"},
      {"Claimed, m", "True, m", "Claimed corrections", "True", "Claimed chance, %", "True, %", "Gap to the optimum, %"},
      html);
}

std::string errors_table(const Study& study, std::size_t set, Task task) {
  const Plan& proven = study.proven(set, task);
  std::string rows;
  for (const Arrival& arrival : arrivals_of(study.site(set, task), proven.route))
    rows += row(arrival.where, word_cell(kind_words(arrival.kind)) + number_cell(arrival.vertical, 3) +
                                   number_cell(arrival.horizontal, 3) + number_cell(arrival.flown_m, 2));
  return study_table({"Point", "Corrects"}, {"Vertical error before", "Horizontal error before", "Flown, m"}, rows);
}

std::string front_table(const Study& study, std::size_t set, Task task) {
  std::string rows;
  for (const FrontPoint& point : study.proven(set, task).front)
    rows += row(fmt::format("{}", point.corrections), number_cell(point.length_m, 2) +
                                                          number_cell(100 * point.probability, 2) +
                                                          word_cell(fmt::format("{}", fmt::join(point.points, " "))));
  return study_table({"Corrections"}, {"Length, m", "Chance, %", "Points"}, rows);
}

std::string astar_table(const Study& study) {
  std::string rows;
  for (const PublishedRoute& published : published_routes()) {
    if (published.method.empty()) continue;
    const StudyRun* best = study.trial(published.set, published.method).best();
    rows += row(published.method,
                number_cell(published.length_m, 2) + number_cell(as_number(published.corrections), 0) +
                    number_cell(best != nullptr ? std::optional(best->metrics.length_m) : std::nullopt, 2) +
                    number_cell(best != nullptr ? as_number(best->metrics.corrections) : std::nullopt, 0));
  }
  return study_table({"Run"}, {"Printed length, m", "Printed corrections", "Ours, m", "Our corrections"}, rows);
}

std::string methods_table(const Study& study) {
  std::string rows;
  for (std::size_t m = 0; m < study.methods.methods.size(); ++m) {
    const StudyMethod& method = study.methods.methods[m];
    std::string cells;
    for (std::size_t set = 0; set < kSets; ++set) {
      const Trial& trial = study.methods.at(set, m);
      const Cell cell = study.methods.cell(trial);
      const double optimum = study.proven(set, Task::straight).cost;
      cells += fmt::format("<td class=\"num\">{} of {}</td>", cell.found, cell.runs) + number_cell(cell.mean, 1) +
               number_cell(cell.mean ? std::optional(100 * (*cell.mean / optimum - 1)) : std::nullopt, 2) +
               fmt::format("<td class=\"num\">{}</td>", milliseconds(cell.wall_s));
    }
    rows += row(method.name, method.help, cells);
  }
  return study_table({"Method"}, {"Set 1: found", "Mean, m", "Gap, %", "ms", "Set 2: found", "Mean, m", "Gap, %", "ms"},
                     rows);
}

}  // namespace alate::zhou2020
