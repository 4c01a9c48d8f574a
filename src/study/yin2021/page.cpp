#include "study/yin2021/page.hpp"

#include <fmt/core.h>

#include "out/report/page.hpp"
#include "out/text.hpp"
#include "study/page/study_style.hpp"
#include "study/page/study_tables.hpp"
#include "study/yin2021/pictures.hpp"
#include "study/yin2021/tables.hpp"

namespace alate::yin2021 {

namespace {

std::string lead(const std::string& text) { return fmt::format("<p class=\"lead\">{}</p>\n", text); }

std::string subsection(const std::string& title, const std::string& content) {
  return fmt::format("<h3>{}</h3>\n{}", title, content);
}

template <class OnSize>
std::string by_size(OnSize on_size) {
  std::string html;
  for (const Size size : kBoth) html += subsection(size_name(size), on_size(size));
  return html;
}

std::string introduction() {
  return lead(
      "The paper adds one factor, mu, to the heuristic of an ant colony on grids with heights, and reports shorter "
      "routes with far less spread than its baseline. Here both run side by side on many maps; they differ by mu "
      "alone.");
}

std::string facts(const Study& study, const Reproduction& result) {
  std::size_t drawn = 0;
  std::size_t passed_over = 0;
  for (const SizeStudy& of_size : study.sizes) {
    drawn += of_size.maps.seeds.size();
    passed_over += of_size.maps.passed_over;
  }
  return verdict_facts(
      result, fact(fmt::format("{}", drawn), fmt::format("maps; {} more, without a way, passed over", passed_over)));
}

std::string routes(const Study& study) {
  std::string html = lead(
      "The first map of each size. The best route of all runs by S; alate's own colony looks for short routes, the "
      "other two for a low S.");
  html += "<div class=\"panels wide\">\n";
  for (const Size size : kBoth) html += routes_picture(study, size);
  return html + "</div>\n";
}

std::string passed_over_words(const Study& study) {
  std::string words;
  for (const Size size : kBoth)
    words += fmt::format("{}{} of {}", words.empty() ? "" : " and ", study.on(size).maps.passed_over, size_name(size));
  return words + " were passed over";
}

std::string maps(const Study& study) {
  std::string html = lead(
      "Dots: one a map, whiskers: 95 % of its mean, by the normal law. The paper has one map: any of these might have "
      "been it. Maps where one variance is 0 have no ratio. Maps without a way are drawn again with the next seed: " +
      passed_over_words(study) + ".");
  html += "<div class=\"panels wide\">\n";
  for (const Size size : kBoth) html += maps_pictures(study, size);
  html += "</div>\n";
  for (const Size size : kBoth)
    html += fmt::format("<details><summary>All maps of {}</summary>\n{}</details>\n", size_name(size),
                        maps_table(study, size));
  return html;
}

std::string all_runs(const Reproduction& result) {
  return lead(
             "Each row sums up all maps of a size: means over the maps; SD is the root of the mean variance within a "
             "map; the bound is the mean exact optimum.") +
         cells_table(result.cells);
}

}  // namespace

std::string page_html(const Study& study, const Reproduction& result) {
  std::string body = reproduction_header(result);
  body += introduction() + facts(study, result);
  body += page_section("What must be known first", notes_list(result.notes));
  body += page_section("Published beside ours",
                       lead("Figures in brackets are 95 % confidence intervals over the maps. A change of up to 1 %, "
                            "or of half a turn or iteration, counts as hardly any.") +
                           claims_table(result.claims));
  body += page_section("All methods at a glance", lead("As meant; means over all maps and runs.") +
                                                      by_size([&](Size size) { return methods_table(study, size); }));
  body += page_section("What is wrong with what was published", defects_list(result.defects));
  body += page_section("Every reading",
                       lead("Changes from the baseline to the new method, each with its 95 % interval over the maps. "
                            "True S has F over the route's own cells, whatever the colony thinks.") +
                           by_size([&](Size size) { return readings_table(study, size); }));
  body += page_section("Map by map", maps(study));
  body += page_section("Over the iterations",
                       lead("As meant; mean over the maps of the mean over the runs that have a route by then.") +
                           by_size([&](Size size) { return curves_pictures(study, size); }));
  body += page_section("Best routes", routes(study));
  body += page_section("All runs", all_runs(result));
  body += page_section("How it was made", settings_section(result));
  return html_page("alate: " + result.title, body, kStudyStyle);
}

}  // namespace alate::yin2021
