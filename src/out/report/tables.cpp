#include "out/report/tables.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "alate/core/version.hpp"
#include "out/notes.hpp"
#include "out/report/number_words.hpp"
#include "out/report/rule_words.hpp"
#include "out/text.hpp"

namespace alate {

namespace {

using Rows = std::vector<std::pair<std::string, std::string>>;

std::string figure(double value, std::string_view unit) { return xml_escape(quantity(value, unit)); }

std::string place(const Site& site, std::size_t leg, const Vec3& where) {
  if (!where.allFinite()) return fmt::format("leg {}", leg);
  const auto geo = site.frame.to_geo(where.head<2>());
  if (!geo) return fmt::format("leg {}, x {:.0f} m, y {:.0f} m", leg, where.x(), where.y());
  return fmt::format("leg {}, {:.5f}, {:.5f}", leg, geo->lat_deg, geo->lon_deg);
}

struct RuleRow {
  std::string_view rule;
  std::string_view state;  ///< "pass", "fail", "unknown" or "not checked"; also the class of the row.
  std::string limit;
  std::string worst;
  std::string where;
};

std::string row_html(const RuleRow& row) {
  const std::string css = row.state == "not checked" ? "skipped" : std::string(row.state);
  const char* mark = row.state == "pass" ? "✓" : row.state == "fail" ? "✕" : row.state == "unknown" ? "?" : "–";
  return fmt::format(
      "<tr class=\"{}\"><th scope=\"row\">{}<br/><code>{}</code></th><td class=\"state\">{} {}</td>"
      "<td title=\"limit\">{}</td><td title=\"worst\">{}</td><td title=\"where\">{}</td></tr>\n",
      css, xml_escape(rule_title(row.rule)), xml_escape(row.rule), mark, row.state, xml_escape(row.limit), row.worst,
      row.where);
}

/// "12.5 m to spare". The check gives a straight flight a turn radius of 1e9 m.
std::string worst_words(const Margin& margin, bool failed) {
  constexpr double kNoTurn_m = 1e8;
  if (margin.rule == "turn" && margin.margin > kNoTurn_m) return "no turns";
  if (margin.unit == "places" && !failed) return "nowhere touched";
  if (failed) return figure(-margin.margin, margin.unit) + " over the limit";
  return figure(std::max(0.0, margin.margin), margin.unit) + " to spare";
}

std::string judged_row(const Result& result, const Margin& margin) {
  const auto count = std::ranges::count(result.verdict.violations, margin.rule, &Violation::rule);
  std::string worst = worst_words(margin, count > 0);
  if (count > 1) worst += fmt::format(" ({} places)", count);
  return row_html({.rule = margin.rule,
                   .state = count > 0 ? "fail" : "pass",
                   .limit = rule_limit(margin.rule, result.site),
                   .worst = worst,
                   .where = place(result.site, margin.leg, margin.where)});
}

/// Rules that were broken but have no margin of their own.
std::string other_violations(const Result& result) {
  std::string rows;
  for (const Violation& violation : result.verdict.violations) {
    if (std::ranges::find(result.verdict.margins, violation.rule, &Margin::rule) != result.verdict.margins.end())
      continue;
    rows += row_html({.rule = violation.rule,
                      .state = "fail",
                      .limit = rule_limit(violation.rule, result.site),
                      .worst = figure(violation.value, violation.unit),
                      .where = place(result.site, violation.leg, violation.where)});
  }
  return rows;
}

std::string parameter_list(const ParamValues& parameters) {
  std::string list;
  for (const auto& [name, value] : parameters.all())
    list += fmt::format("<code>{}&#160;=&#160;{}</code> ", xml_escape(name), xml_escape(to_text(value)));
  return list.empty() ? "none" : list;
}

std::string listed(const std::vector<std::string>& items) {
  std::string list;
  for (const std::string& item : items) list += fmt::format("<code>{}</code> ", xml_escape(item));
  return list.empty() ? "none" : list;
}

}  // namespace

std::string pairs_table(const Rows& rows) {
  std::string html = "<table class=\"pairs\">\n";
  for (const auto& [name, value] : rows)
    html += fmt::format("<tr><th scope=\"row\">{}</th><td>{}</td></tr>\n", xml_escape(name), value);
  return html + "</table>\n";
}

std::string rules_table(const Result& result) {
  std::string rows;
  for (const Margin& margin : result.verdict.margins) rows += judged_row(result, margin);
  rows += other_violations(result);
  for (const NotChecked& rule : result.verdict.not_checked) {
    rows += row_html({.rule = rule.rule,
                      .state = rule.unknown ? "unknown" : "not checked",
                      .limit = {},
                      .worst = xml_escape(rule.why),
                      .where = {}});
  }
  return fmt::format(
      "<div class=\"scroll\"><table class=\"rules\"><thead><tr><th scope=\"col\">Rule</th><th scope=\"col\">Result</th>"
      "<th scope=\"col\">Limit</th><th scope=\"col\">Worst margin</th><th scope=\"col\">Where</th></tr></thead>\n"
      "<tbody>\n{}</tbody></table></div>\n",
      rows);
}

std::string numbers_table(const Result& result) {
  Rows rows;
  const bool physical = result.site.scenario.objective.model == CostModel::physical;
  if (!result.plan.route.empty()) {
    const Metrics& m = result.metrics;
    rows = {{"Cost", figure(m.cost, physical ? "m" : "")},
            {"Best possible, at least", figure(result.plan.lower_bound, physical ? "m" : "")},
            {"Gap", xml_escape(gap_in_words(result))},
            {"Length", figure(m.length_m, "m")},
            {"Climb, all told", figure(m.climb_m, "m")},
            {"Descent, all told", figure(m.descent_m, "m")},
            {"Exposure to threats", figure(m.threat, physical ? "m" : "")}};
    if (m.corrections) rows.emplace_back("Corrections", whole(*m.corrections));
    if (m.probability) rows.emplace_back("Chance of success", chance_in_words(*m.probability));
    if (m.grid) {
      rows.emplace_back("Turns", whole(m.grid->turns));
      rows.emplace_back("Standard deviation of the heights of its cells", figure(m.grid->height_deviation_m, "m"));
      rows.emplace_back("Composite index (Yin et al. 2021)", figure(composite_index(*m.grid), ""));
    }
    if (m.min_clearance_m) rows.emplace_back("Lowest height above ground", figure(*m.min_clearance_m, "m"));
  }
  rows.emplace_back("Planning time", figure(result.wall_s, "s"));
  for (const auto& [name, count] : result.plan.counters) rows.emplace_back("Counted: " + name, whole(count));
  return pairs_table(rows);
}

std::string settings_table(const Result& result) {
  const ChosenPlanner& planner = result.planner;
  Rows rows{{"Scenario", fmt::format("<code>{}</code>", xml_escape(result.site.scenario.file))},
            {"Overrides", listed(result.site.scenario.overrides)},
            {"Planner", fmt::format("<code>{}</code>, preset <code>{}</code>", xml_escape(planner.name),
                                    xml_escape(planner.preset))},
            {"Chosen by", fmt::format("{}: {}", xml_escape(planner.chosen_by), xml_escape(planner.why))},
            {"Parameters", parameter_list(planner.parameters)},
            {"Seed", fmt::format("{}", result.plan.seed)},
            {"Threads", fmt::format("{}", result.threads)},
            {"Outcome", fmt::format("{}, stopped: {}", to_string(result.plan.outcome), to_string(result.plan.stop))},
            {"Same again with this seed", result.plan.reproducible ? "yes" : "no: the clock or the user ended the run"},
            {"Frame", fmt::format("<code>{}</code>", xml_escape(result.site.frame.name()))},
            {"alate", xml_escape(version())}};
  return pairs_table(rows);
}

}  // namespace alate
