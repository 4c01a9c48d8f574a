// The page of a study.
#include <fmt/core.h>

#include <algorithm>

#include "alate/core/version.hpp"
#include "out/report/page.hpp"
#include "out/report/tables.hpp"
#include "out/text.hpp"
#include "study/matrix/analysis.hpp"
#include "study/matrix/by_group.hpp"
#include "study/matrix/views.hpp"
#include "study/page/study_style.hpp"
#include "study/page/study_tables.hpp"

namespace alate {

namespace {

constexpr double kLevel = 0.05;  ///< A corrected chance below it tells two planners apart.

std::string chance_text(double p) { return p < 0.0001 ? "&lt; 0.0001" : fmt::format("{:.4f}", p); }

/// What is told of one group of scenarios.
class PartPage {
 public:
  explicit PartPage(const StudyPart& part)
      : part_(part), study_(part.study), analysis_(analyse(part.study, part.records)) {}

  std::string html() const {
    std::string body = facts() + section("In short", in_short());
    body += section("All planners", methods_table() + refused());
    body += section("How far the routes lie above " + std::string(words_of(analysis_.yardstick)), boxes());
    body += section("Better with every iteration", bands());
    body += section("What more time buys", gap_time());
    return body + section("Which planners can be told apart", duels_table());
  }

 private:
  std::string section(const std::string& title, const std::string& body) const {
    return page_section(part_.name.empty() ? title : xml_escape(part_.name) + ": " + title, body);
  }

  std::string refused() const {
    std::string rows;
    for (const auto& [planner, why] : part_.refused)
      rows += fmt::format("<tr><th scope=\"row\">{}</th><td>{}</td></tr>\n", xml_escape(planner), xml_escape(why));
    return rows.empty() ? "" : study_table({"Refused by", "It"}, {}, rows);
  }

  std::string facts() const {
    std::size_t runs = 0;
    std::size_t valid = 0;
    for (const MethodFigures& method : analysis_.methods) {
      runs += method.runs;
      valid += valid_of(method);
    }
    return fmt::format("<ul class=\"facts\">\n{}{}{}{}</ul>\n",
                       fact(fmt::format("{}", study_.scenarios.size()), "scenarios"),
                       fact(fmt::format("{}", study_.planners.size()), "planners"),
                       fact(fmt::format("{}", runs), "runs"), fact(fmt::format("{}", valid), "routes that pass"));
  }

  static std::size_t valid_of(const MethodFigures& method) {
    return static_cast<std::size_t>(std::ranges::count_if(method.records, &StudyRecord::valid));
  }

  /// One sentence a budget: who is nearest, and whom that can be said of.
  std::string in_short() const {
    std::string text;
    for (std::size_t budget = 0; budget < study_.budgets.size(); ++budget) text += winner_sentence(budget);
    const auto told = std::ranges::count_if(analysis_.duels, [](const auto& duel) { return duel.corrected < kLevel; });
    if (!analysis_.duels.empty())
      text += fmt::format("<p class=\"lead\">Of {} comparisons of two planners, {} can be told from chance.</p>\n",
                          analysis_.duels.size(), told);
    return text;
  }

  std::string winner_sentence(std::size_t budget) const {
    const MethodFigures* best = nullptr;
    for (const MethodFigures& method : analysis_.methods)
      if (method.budget == budget && method.gap && (best == nullptr || method.gap->mean < best->gap->mean))
        best = &method;
    const std::string with = xml_escape(study_.budgets[budget].text());
    if (best == nullptr) return fmt::format("<p class=\"lead\">With {} no planner found a valid route.</p>\n", with);
    const std::string margin = best->gap_margin ? fmt::format(" (± {:.2f})", *best->gap_margin) : "";
    return fmt::format(
        "<p class=\"lead\">With {}, <b>{}</b> comes nearest: its valid routes lie {:.2f}{} % above {} on "
        "average, and {} of {} runs end with one.</p>\n",
        with, xml_escape(best->name), best->gap->mean, margin, words_of(analysis_.yardstick), valid_of(*best),
        best->runs);
  }

  std::string methods_table() const {
    std::string rows;
    for (const MethodFigures& method : analysis_.methods) {
      const auto spread = spread_of(method.gaps);
      const auto median = spread ? std::optional(spread->median) : std::nullopt;
      const auto mean = method.gap ? std::optional(method.gap->mean) : std::nullopt;
      rows += fmt::format(
          "<tr><th scope=\"row\">{}</th><td>{}</td><td class=\"num\">{} of {}</td><td class=\"num\">{}</td><td "
          "class=\"num\">{}</td><td class=\"num\">{}</td><td class=\"num\">{}</td></tr>\n",
          xml_escape(method.name), xml_escape(study_.budgets[method.budget].text()), valid_of(method), method.runs,
          fixed(mean, 3), fixed(method.gap_margin, 3), fixed(median, 3), milliseconds(method.mean_s));
    }
    return study_table({"Planner", "Budget"}, {"Valid", "Mean gap, %", "95 %, ±", "Median gap, %", "Time, ms"}, rows) +
           fmt::format(
               "<p class=\"soft\">Gaps are of valid routes above {}. The interval is Student’s, of the mean.</p>\n",
               words_of(analysis_.yardstick));
  }

  /// A drawing for each budget that has one.
  template <class Draw>
  std::string panels(Draw draw) const {
    std::string all;
    for (std::size_t budget = 0; budget < study_.budgets.size(); ++budget) {
      const std::string svg = draw(study_, analysis_, budget);
      if (!svg.empty())
        all += fmt::format("<figure><h4>{}</h4>{}</figure>\n", xml_escape(study_.budgets[budget].text()), svg);
    }
    return all.empty() ? "" : "<div class=\"panels\">\n" + all + "</div>\n";
  }

  std::string boxes() const {
    const std::string drawings = panels(box_svg);
    return drawings.empty() ? ""
                            : "<p class=\"lead\">Half of the routes lie in the box, split by the median; whiskers "
                              "reach to the last route within 1.5 boxes, circles are routes beyond.</p>\n" +
                                  drawings;
  }

  std::string bands() const {
    const std::string drawings = panels(bands_svg);
    if (drawings.empty()) return {};
    std::string left_out;
    for (const MethodFigures& method : analysis_.methods)
      if (method.budget == 0 && method.planner < kLineStyles && !has_bands(method))
        left_out += (left_out.empty() ? "" : ", ") + xml_escape(method.name);
    if (!left_out.empty())
      left_out = fmt::format(" Left out, since their histories are not told in these costs: {}.", left_out);
    return fmt::format(
        "<p class=\"lead\">The best route so far: the median of all runs, and the band that holds the "
        "middle half. Both axes are logarithmic; lines begin where every run has a route.{}</p>\n{}{}",
        left_out, drawings, key());
  }

  std::string gap_time() const {
    const std::string drawing = gap_time_svg(analysis_);
    return drawing.empty() ? ""
                           : "<p class=\"lead\">Mean gap over mean planning time on one thread, with 95 % "
                             "confidence; a line joins the budgets of one planner.</p>\n<div "
                             "class=\"panels\"><figure>" +
                                 drawing + "</figure></div>\n" + key();
  }

  std::string key() const {
    std::string items;
    for (const MethodFigures& method : analysis_.methods)
      if (method.budget == 0 && method.planner < kLineStyles)
        items += fmt::format("<li><span class=\"swatch s-way {}\"></span>{}</li>\n", line_class(method),
                             xml_escape(method.name));
    const std::string more =
        study_.planners.size() > kLineStyles ? fmt::format("<li>only the first {} are drawn</li>\n", kLineStyles) : "";
    return fmt::format("<ul class=\"key\">\n{}{}</ul>\n", items, more);
  }

  std::string duels_table() const {
    if (analysis_.duels.empty()) return {};
    std::string rows;
    for (const MethodDuel& duel : analysis_.duels) rows += duel_row(duel);
    const char* pairs = analysis_.by_scenario
                            ? "A pair is a scenario: the median of each planner over its seeds."
                            : "A pair is a scenario and a seed, so this speaks of these scenarios, not of others.";
    return fmt::format(
               "<p class=\"lead\">Wilcoxon’s signed-rank test, two-sided, with Holm’s correction for all {} "
               "comparisons. {} A run without a valid route counts as worse than any with one.</p>\n",
               analysis_.duels.size(), pairs) +
           study_table({"Planners", "Budget", "Says"}, {"Pairs", "First better", "Second better", "Corrected p"}, rows);
  }

  std::string duel_row(const MethodDuel& duel) const {
    const MethodFigures& first = analysis_.methods[duel.first];
    const MethodFigures& second = analysis_.methods[duel.second];
    const MethodFigures& better = duel.first_ahead ? first : second;
    const std::string says = duel.corrected < kLevel ? xml_escape(better.name) + " is better" : "cannot be told apart";
    return fmt::format(
        "<tr><th scope=\"row\">{} : {}</th><td>{}</td><td>{}</td><td class=\"num\">{}</td><td class=\"num\">{}</td><td "
        "class=\"num\">{}</td><td class=\"num\">{}</td></tr>\n",
        xml_escape(first.name), xml_escape(second.name), xml_escape(study_.budgets[first.budget].text()), says,
        duel.pairs, duel.first_better, duel.second_better, chance_text(duel.corrected));
  }

  const StudyPart& part_;
  const Study& study_;
  StudyAnalysis analysis_;
};

std::string settings(const Study& study) {
  return "<p class=\"lead\">Each run has one thread. Costs are what the independent check measures. Planners that no "
         "seed changes run once. The same study gives the same rows.csv at any number of threads and processes, "
         "budgets of time apart.</p>\n" +
         pairs_table({{"alate", version()}, {"study", xml_escape(study.file)}, {"fingerprint", study.fingerprint}});
}

}  // namespace

std::string study_html(const Study& study, const StudyRecords& records) {
  std::string body = fmt::format("<header><p>alate study</p><h1>{}</h1></header>\n", xml_escape(study.file));
  for (const StudyPart& part : parts_of(study, records)) body += PartPage(part).html();
  body += page_section("How it was made", settings(study));
  return html_page("alate study: " + study.file, body, std::string(kStudyStyle) + std::string(kViewStyle));
}

}  // namespace alate
