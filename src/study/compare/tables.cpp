#include "study/compare/tables.hpp"

#include <fmt/core.h>

#include <optional>

#include "out/text.hpp"
#include "study/page/study_tables.hpp"

namespace alate {

namespace {

/// What became of the runs, in a few words.
std::string verdict_of(const CompareFigures& each) {
  if (each.costs.size() == each.runs) return "allowed";
  std::string words = each.costs.empty() ? "" : "partly allowed";
  const auto add = [&](std::size_t count, const char* what) {
    if (count > 0) words += fmt::format("{}{} {}", words.empty() ? "" : ", ", count, what);
  };
  add(each.refused, "refused");
  add(each.late, "late");
  add(each.none, "without a route");
  return words;
}

std::string above_best(const CompareFigures& each, const std::optional<double>& best) {
  return each.solves() && best && *best > 0 ? fmt::format("{:+.2f}", 100 * (each.median / *best - 1)) : "–";
}

}  // namespace

std::string shown_name(const Comparison& comparison, const CompareFigures& each) {
  const Contender& who = comparison.contenders[each.contender];
  return xml_escape(who.name) + (who.peer ? " <span class=\"soft\">other program</span>" : "");
}

std::string final_table(const Comparison& comparison, const Ranking& ranks) {
  const std::optional<double> best = best_cost(comparison);
  std::string rows;
  for (const CompareFigures& each : ranks) {
    const auto value = [&](double Summary::* member) {
      return each.cost ? std::optional((*each.cost).*member) : std::nullopt;
    };
    const auto shown = [](const std::optional<double>& cost) { return cost ? cost_words(*cost) : "–"; };
    rows += fmt::format(
        "<tr><th scope=\"row\">{}</th><td>{}</td><td class=\"num\">{} of {}</td><td class=\"num\">{}</td><td "
        "class=\"num\">{}</td><td class=\"num\">{}</td><td class=\"num\">{}</td><td class=\"num\">{}</td><td "
        "class=\"num\">{}</td></tr>\n",
        shown_name(comparison, each), xml_escape(verdict_of(each)), each.costs.size(), each.runs,
        cost_words(each.median), above_best(each, best), shown(value(&Summary::mean)),
        shown(each.cost ? each.cost->sd : std::nullopt), shown(value(&Summary::least)),
        shown(value(&Summary::greatest)));
  }
  return study_table({"Planner", "The check says"},
                     {"Passed", "Median", "% above best", "Mean", "SD", "Least", "Greatest"}, rows) +
         "<p class=\"soft\">Costs are what the independent check measures, of routes that pass. For the median a run "
         "without one counts as costlier than any with one.</p>\n";
}

std::string times_table(const Comparison& comparison, const Ranking& ranks) {
  std::string rows;
  std::vector<std::string> heads;
  for (const double time : comparison.times_s) heads.push_back(time_words(time));
  for (const CompareFigures& each : ranks) {
    rows += fmt::format("<tr><th scope=\"row\">{}</th>", shown_name(comparison, each));
    for (std::size_t time = 0; time < comparison.times_s.size(); ++time) {
      const CompareFigures then = figures_of(comparison, each.contender, time);
      const std::string some = then.costs.size() < then.runs && !then.costs.empty()
                                   ? fmt::format(" <span class=\"soft\">{} of {}</span>", then.costs.size(), then.runs)
                                   : "";
      rows += fmt::format("<td class=\"num\">{}{}</td>", cost_words(then.median), some);
    }
    rows += "</tr>\n";
  }
  return study_table({"Planner"}, heads, rows) +
         "<p class=\"soft\">A dash says that more than half of the runs had no route that passes; “2 of 5” how many "
         "had one, where not all did.</p>\n";
}

std::string broken_table(const Comparison& comparison, const Ranking& ranks) {
  std::string rows;
  for (const CompareFigures& each : ranks) {
    const Contender& who = comparison.contenders[each.contender];
    for (const CompareRun& run : comparison.runs) {
      if (run.contender != each.contender) continue;
      const CompareMark& mark = run.marks.back();
      const bool bad_end = run.ending != "finished";
      if (mark.standing != Standing::refused && run.refused == 0 && !bad_end) continue;
      const std::string handed = who.peer ? fmt::format("{} of {}", run.refused, run.routes) : "";
      rows += fmt::format(
          "<tr><th scope=\"row\">{}</th><td>{}</td><td>{}</td><td class=\"num\">{}</td><td "
          "class=\"num\">{}</td></tr>\n",
          xml_escape(who.name), xml_escape(mark.broken), bad_end ? xml_escape(run.ending + ": " + run.note) : "",
          run.seed, handed);
    }
  }
  if (rows.empty()) return "<p class=\"lead\">Nothing: every route that was handed over passes.</p>\n";
  return study_table({"Planner", "Rules that its route breaks", "How the program ended"},
                     {"Seed", "Refused of handed over"}, rows);
}

std::string absent_table(const Comparison& comparison) {
  std::string rows;
  for (const CompareRefusal& each : comparison.refusals)
    rows += fmt::format("<tr><th scope=\"row\">{}</th><td>{}</td></tr>\n", xml_escape(each.name), xml_escape(each.why));
  std::string text;
  for (const std::string& note : comparison.notes) text += fmt::format("<p class=\"lead\">{}</p>\n", xml_escape(note));
  return text + (rows.empty() ? "" : "<div class=\"told\">" + study_table({"Planner", "Why"}, {}, rows) + "</div>");
}

}  // namespace alate
