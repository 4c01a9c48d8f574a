#include "study/zhou2020/page.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "out/report/page.hpp"
#include "out/text.hpp"
#include "study/page/study_style.hpp"
#include "study/page/study_tables.hpp"
#include "study/zhou2020/pictures.hpp"
#include "study/zhou2020/tables.hpp"

namespace alate::zhou2020 {

namespace {

std::string lead(const std::string& text) { return fmt::format("<p class=\"lead\">{}</p>\n", text); }

std::string subsection(const std::string& title, const std::string& content) {
  return fmt::format("<h3>{}</h3>\n{}", xml_escape(title), content);
}

std::string introduction() {
  return lead(
      "The navigation error of an aircraft grows as it flies and is reset at correction points. Which points, so that "
      "no limit is broken and the way is short? The paper answers with a genetic algorithm and a sparse A*; others "
      "tried the same two sets of points. Here each published route is flown and judged, and stands beside the proven "
      "optimum of alate’s exact search.");
}

std::string fronts(const Study& study) {
  std::string html = lead(
      "Length against corrections, and in problem 3 against the chance that no limit is broken though points fail. "
      "Each row is proven: no route is as good or better in every column.");
  for (std::size_t set = 0; set < kSets; ++set)
    for (const Task task : {Task::straight, Task::turning, Task::unreliable})
      html += subsection(case_name(set, task), front_table(study, set, task));
  return html;
}

std::string errors(const Study& study) {
  std::string html = lead("Both errors, in units, on arrival at each point of the shortest proven route.");
  for (std::size_t set = 0; set < kSets; ++set)
    for (const Task task : {Task::straight, Task::turning})
      html += subsection(case_name(set, task), errors_table(study, set, task));
  return html;
}

std::string routes(const Study& study, const std::vector<JudgedRow>& rows) {
  std::string html;
  for (std::size_t set = 0; set < kSets; ++set) html += subsection(set_name(set), routes_picture(study, set, rows));
  return html;
}

std::string genetic(const Study& study) {
  std::string html = lead(
      "Genes are drawn over a rectangle about the straight line, one cell each, and become the nearest point. Six "
      "chromosomes of the first population:");
  html += population_picture(study, 0);
  html += lead(
      "Rates fall as fitness rises: the best individual has the lowest, though the paper’s text says the "
      "opposite of its formula.");
  html += rates_picture(study);
  html += lead(
      "Length by iteration, above the lower bound that each run knows by itself. Line: mean over the seeds, from where "
      "every seed has a "
      "route. Band: from the best to the worst seed.");
  html += "<div class=\"panels\">\n";
  for (std::size_t set = 0; set < kSets; ++set) html += fitness_picture(study, set);
  return html + "</div>\n";
}

}  // namespace

std::string page_html(const Study& study, const std::vector<JudgedRow>& rows, const Reproduction& result) {
  std::string body = reproduction_header(result);
  body += introduction() + verdict_facts(result);
  body += page_section("Published beside ours", claims_table(result.claims));
  body += page_section("Every published route, flown", routes_table(rows));
  body += page_section("What is wrong with the published definition", defects_list(result.defects));
  body += page_section("All methods on problem 1", methods_table(study));
  body +=
      page_section("The paper’s table 5 beside ours",
                   lead("The paper turns at points here, our sparse A* does not: turning only makes routes longer.") +
                       astar_table(study));
  body += page_section("Routes among the points", routes(study, rows));
  body += page_section("The genetic algorithms", genetic(study));
  body += page_section("Errors before each correction", errors(study));
  body += page_section("Proven fronts", fronts(study));
  body += page_section("All runs", cells_table(result.cells));
  body += page_section("How it was made", settings_section(result));
  return html_page("alate: " + result.title, body, kStudyStyle);
}

}  // namespace alate::zhou2020
