#include "study/yin2021/tables.hpp"

#include <fmt/core.h>

#include "out/text.hpp"
#include "study/page/study_tables.hpp"

namespace alate::yin2021 {

namespace {

std::string number_cell(const std::string& text) { return fmt::format("<td class=\"num\">{}</td>", text); }

std::string number_cell(const std::optional<double>& value, int decimals) {
  return number_cell(fixed(value, decimals));
}

/// "-0.31", with its interval below.
std::string interval_cell(const std::optional<Interval>& interval, int decimals) {
  if (!interval) return number_cell("–");
  return number_cell(fmt::format("{:+.{}f}<br/><span class=\"soft interval\">{:.{}f} to {:.{}f}</span>",
                                 interval->value, decimals, interval->low, decimals, interval->high, decimals));
}

std::string row(const std::string& head, const std::string& remark, const std::string& cells) {
  return fmt::format("<tr><th scope=\"row\">{}<br/><span class=\"soft\">{}</span></th>{}</tr>\n", xml_escape(head),
                     xml_escape(remark), cells);
}

std::optional<double> hundredfold(const std::optional<double>& value) {
  return value ? std::optional(100 * *value) : std::nullopt;
}

std::optional<double> gap_percent(const Cell& cell) {
  return cell.mean ? std::optional(100 * (*cell.mean / cell.lower_bound - 1)) : std::nullopt;
}

}  // namespace

std::string methods_table(const Study& study, Size size) {
  std::string rows;
  for (const StudyMethod& method : study.on(size).main.methods) {
    const MethodSummary summary = summarize_method(study.on(size), method.name);
    const Cell& cell = summary.cell;
    rows += row(method.name, method.help,
                number_cell(fmt::format("{} of {}", cell.found, cell.runs)) + number_cell(cell.mean, 2) +
                    number_cell(gap_percent(cell), 2) + number_cell(cell.sd, 2) +
                    number_cell(hundredfold(summary.height_dev), 1) + number_cell(summary.turns, 1) +
                    number_cell(summary.score, 1) + number_cell(summary.settled, 1) +
                    number_cell(milliseconds(cell.wall_s)));
  }
  return study_table(
      {"Method"},
      {"Routes", "Length L", "Above the optimum, %", "SD in a map", "100 F", "Turns T", "S", "Last change of L", "ms"},
      rows);
}

std::string readings_table(const Study& study, Size size) {
  std::string rows;
  for (std::size_t r = 0; r < readings().size(); ++r) {
    const ReadingSummary summary = summarize_reading(study, size, r);
    rows += row(readings()[r].name, readings()[r].help,
                interval_cell(summary.length_percent, 2) + interval_cell(summary.variance_percent, 1) +
                    interval_cell(summary.score_percent, 2) + interval_cell(summary.turns, 2) +
                    number_cell(summary.li_length, 2) + number_cell(summary.true_li_score, 1));
  }
  return study_table({"Reading"},
                     {"Change of L, %", "Of its variance, %", "Of S, %", "Of T", "Baseline's L", "Its true S"}, rows);
}

std::string maps_table(const Study& study, Size size) {
  const SizeStudy& of_size = study.on(size);
  std::string rows;
  for (std::size_t map = 0; map < of_size.maps.seeds.size(); ++map) {
    const Cell li = cell_on_map(of_size, map, kLi);
    const Cell yin = cell_on_map(of_size, map, kYin);
    const auto change = li.mean && yin.mean ? std::optional(100 * (*yin.mean / *li.mean - 1)) : std::nullopt;
    const auto ratio =
        li.sd && yin.sd && *li.sd > 0 ? std::optional(*yin.sd * *yin.sd / (*li.sd * *li.sd)) : std::nullopt;
    rows += fmt::format("<tr><th scope=\"row\">{}</th>{}</tr>\n", of_size.maps.seeds[map],
                        number_cell(li.lower_bound, 2) + number_cell(li.mean, 2) + number_cell(li.sd, 2) +
                            number_cell(yin.mean, 2) + number_cell(yin.sd, 2) + number_cell(change, 2) +
                            number_cell(ratio, 3));
  }
  return study_table({"Seed of the map"},
                     {"Optimum", "Li: mean L", "SD", "Yin: mean L", "SD", "Change of L, %", "Ratio of variances"},
                     rows);
}

}  // namespace alate::yin2021
