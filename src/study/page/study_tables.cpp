#include "study/page/study_tables.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <limits>

#include "out/report/tables.hpp"
#include "out/text.hpp"

namespace alate {

namespace {

std::string with_unit(const std::optional<double>& value, const std::string& unit) {
  const std::string shown = unit == "%" ? "&#160;%" : unit.empty() ? "" : "&#160;" + xml_escape(unit);
  return value ? fixed(value, unit == "%" ? 1 : 2) + shown : "–";
}

std::string by_case(const Claim& claim) {
  std::string parts;
  for (const auto& [name, value] : claim.by_case)
    parts += fmt::format("<br/>{}&#160;{}", xml_escape(name), fixed(value, claim.unit == "%" ? 1 : 2));
  return parts;
}

std::string claim_row(const Claim& claim) {
  return fmt::format(
      "<tr class=\"{}\"><th scope=\"row\" class=\"text\">{}<br/><code>{}</code></th><td class=\"num\" "
      "title=\"published\">{}</td><td class=\"num\" title=\"ours\">{}{}</td><td class=\"state\">{}</td><td "
      "class=\"why\">{}</td></tr>\n",
      to_string(claim.verdict), xml_escape(claim.text), xml_escape(claim.id), with_unit(claim.published, claim.unit),
      with_unit(claim.ours, claim.unit), by_case(claim), verdict_words(claim.verdict), xml_escape(claim.why));
}

/// "1.34 %", by how much the mean lies above the bound.
std::string gap_of(const Cell& cell) {
  if (!cell.mean || cell.lower_bound <= 0) return "–";
  return fmt::format("{:.2f}&#160;%", 100 * (*cell.mean - cell.lower_bound) / cell.lower_bound);
}

std::string cell_row(const Cell& cell, bool winner) {
  return fmt::format(
      "<tr{}><th scope=\"row\">{}</th><td>{}</td><td class=\"num\">{} of {}</td><td class=\"num\">{}</td><td "
      "class=\"num\">{}</td><td class=\"num\">{}</td><td class=\"num\">{}</td><td class=\"num\">{}</td><td "
      "class=\"num\">{}</td></tr>\n",
      winner ? " class=\"winner\"" : "", xml_escape(cell.case_name), xml_escape(cell.method), cell.found, cell.runs,
      fixed(cell.mean, 2), fixed(cell.sd, 2), fixed(cell.best, 2), fixed(cell.lower_bound, 2), gap_of(cell),
      milliseconds(cell.wall_s));
}

std::string case_block(const std::vector<Cell>& cells, const std::string& name) {
  double least = std::numeric_limits<double>::infinity();
  for (const Cell& cell : cells)
    if (cell.case_name == name && cell.mean) least = std::min(least, *cell.mean);
  std::string rows;
  for (const Cell& cell : cells)
    if (cell.case_name == name) rows += cell_row(cell, cell.mean == least);
  return fmt::format("<tbody>\n{}</tbody>\n", rows);
}

}  // namespace

std::string fixed(const std::optional<double>& value, int decimals) {
  return value ? fmt::format("{:.{}f}", *value, decimals) : "–";
}

std::string milliseconds(double seconds) { return fixed(1000 * seconds, seconds < 0.01 ? 2 : seconds < 0.1 ? 1 : 0); }

std::string verdict_words(ClaimVerdict verdict) {
  std::string words = to_string(verdict);
  std::ranges::replace(words, '_', ' ');
  return words;
}

std::string claims_table(const std::vector<Claim>& claims) {
  std::string rows;
  for (const Claim& claim : claims) rows += claim_row(claim);
  return fmt::format(
      "<div class=\"scroll\"><table class=\"claims\"><thead><tr><th scope=\"col\">Claim</th><th scope=\"col\" "
      "class=\"num\">Published</th><th scope=\"col\" class=\"num\">Ours</th><th scope=\"col\">Verdict</th><th "
      "scope=\"col\">Why</th></tr></thead>\n<tbody>\n{}</tbody></table></div>\n",
      rows);
}

std::string cells_table(const std::vector<Cell>& cells) {
  std::string blocks;
  std::string last;
  for (const Cell& cell : cells) {
    if (cell.case_name == last) continue;
    last = cell.case_name;
    blocks += case_block(cells, last);
  }
  return fmt::format(
      "<div class=\"scroll\"><table class=\"study cells\"><thead><tr><th scope=\"col\">Case</th><th "
      "scope=\"col\">Method</th>"
      "<th scope=\"col\" class=\"num\">Routes</th><th scope=\"col\" class=\"num\">Mean</th><th scope=\"col\" "
      "class=\"num\">SD</th><th scope=\"col\" class=\"num\">Best</th><th scope=\"col\" class=\"num\">Bound</th><th "
      "scope=\"col\" class=\"num\">Mean above bound</th><th scope=\"col\" class=\"num\">Time, ms</th></tr></thead>\n"
      "{}</table></div>\n",
      blocks);
}

std::string study_table(const std::vector<std::string>& words, const std::vector<std::string>& numbers,
                        const std::string& rows) {
  std::string heads;
  for (const std::string& head : words) heads += fmt::format("<th scope=\"col\">{}</th>", xml_escape(head));
  for (const std::string& head : numbers)
    heads += fmt::format(R"(<th scope="col" class="num">{}</th>)", xml_escape(head));
  return fmt::format(
      R"(<div class="scroll"><table class="study"><thead><tr>{}</tr></thead>
<tbody>
{}</tbody></table></div>
)",
      heads, rows);
}

std::string reproduction_header(const Reproduction& result) {
  return fmt::format("<header><p>alate reproduction of a paper</p><h1>{}</h1></header>\n", xml_escape(result.title));
}

std::string notes_list(const std::vector<std::string>& notes) {
  std::string items;
  for (const std::string& note : notes) items += fmt::format("<li>{}</li>\n", xml_escape(note));
  return fmt::format("<ol class=\"notes\">\n{}</ol>\n", items);
}

std::string defects_list(const std::vector<Defect>& defects) {
  std::string items;
  for (const Defect& defect : defects) {
    const std::string measured =
        defect.measured.empty() ? "" : fmt::format("<p class=\"measured\">{}</p>", xml_escape(defect.measured));
    items +=
        fmt::format("<li><b>{}</b><p>{}</p>{}</li>\n", xml_escape(defect.title), xml_escape(defect.text), measured);
  }
  return items.empty() ? "" : fmt::format("<ul class=\"defects\">\n{}</ul>\n", items);
}

std::string fact(const std::string& value, const std::string& name) {
  return fmt::format("<li><b>{}</b><span>{}</span></li>\n", value, name);
}

std::string verdict_facts(const Reproduction& result, const std::string& more) {
  std::string items;
  for (const ClaimVerdict verdict :
       {ClaimVerdict::holds, ClaimVerdict::does_not_hold, ClaimVerdict::impossible, ClaimVerdict::cannot_be_told}) {
    const auto count = std::ranges::count(result.claims, verdict, &Claim::verdict);
    items += fact(fmt::format("{}", count), (count == 1 ? "claim: " : "claims: ") + verdict_words(verdict));
  }
  std::size_t runs = 0;
  for (const Cell& cell : result.cells) runs += cell.runs;
  items += fact(fmt::format("{}", runs), "runs") + more;
  return fmt::format("<ul class=\"facts\">\n{}</ul>\n", items);
}

std::string settings_section(const Reproduction& result) {
  std::vector<std::pair<std::string, std::string>> rows;
  for (const auto& [name, value] : result.settings) {
    const std::string text = xml_escape(to_text(value));
    rows.emplace_back(name, name.starts_with("layout ") ? fmt::format("<pre>{}</pre>", text) : text);
  }
  return "<p class=\"lead\">Each run has one thread; times are of planning alone, and are longer if the machine had "
         "other work. Costs are what the independent check measures, and only routes that it passed are counted. A "
         "standard deviation is of the sample. Planners without chance run once.</p>\n" +
         pairs_table(rows);
}

}  // namespace alate
