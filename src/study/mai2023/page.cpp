#include "study/mai2023/page.hpp"

#include <fmt/core.h>

#include "out/report/page.hpp"
#include "out/text.hpp"
#include "study/mai2023/pictures.hpp"
#include "study/mai2023/tables.hpp"
#include "study/page/study_style.hpp"
#include "study/page/study_tables.hpp"
#include "study/page/terrain_view.hpp"

namespace alate::mai2023 {

namespace {

std::string lead(const std::string& text) { return fmt::format("<p class=\"lead\">{}</p>\n", text); }

std::string subsection(const std::string& title, const std::string& content) {
  return fmt::format("<h3>{}</h3>\n{}", title, content);
}

std::string introduction() {
  return lead(
      "The paper gives an ant colony over terrain two strategies: a choice that is deterministic with a changing "
      "chance, and pheromone for the best ant of each iteration alone. It claims to be superior to the traditional "
      "colony on length, fitness, iteration number and time. Here both run side by side, with the same parameters and "
      "seeds.");
}

std::string facts(const Study& study, const Reproduction& result) {
  std::size_t runs = 0;
  for (const Experiment& reading : study.readings)
    for (const Trial& trial : reading.trials) runs += trial.runs.size();
  return verdict_facts(result, fact(fmt::format("{}", runs), "more runs, under other readings"));
}

std::string scene_title(Scene scene) {
  constexpr std::array<const char*, kScenes.size()> kTitles{"Simple scene", "Medium scene", "A third scene, ours"};
  return kTitles[scene];
}

std::string scene_section(const Study& study, Scene scene) {
  return lead(fmt::format("Mean over the seeds, and below it best to worst. The least F that any string of moves of "
                          "the lattice has, found exactly, is {:.2f}.",
                          study.optimum[scene].score)) +
         methods_table(study, scene) + subsection("Best routes", routes_picture(study, scene)) +
         subsection("Their heights", profiles_pictures(study, scene)) +
         subsection("Over the iterations",
                    lead("Best F so far, percent above the least; both axes are logarithmic. Thick: mean over the "
                         "seeds, from where every seed has a route.") +
                        curves_pictures(study, scene));
}

std::string readings_section(const Study& study) {
  std::string html = lead(
      "What the paper leaves open, one thing at a time: changes from ACO to Mai 2023, each with its 95 % interval over "
      "the runs. Negative: the paper's method is lower. Where a reading changes F itself, F is that of the reading.");
  for (const Scene scene : kScenes) html += subsection(scene_title(scene), readings_table(study, scene));
  return html;
}

}  // namespace

std::string page_html(const Study& study, const Reproduction& result) {
  std::string body = reproduction_header(result);
  body += introduction() + facts(study, result);
  body += page_section("What must be known first", notes_list(result.notes));
  body += page_section("The paper's claims beside our figures",
                       lead("Changes from ACO to Mai 2023; in brackets 95 % confidence intervals over the runs. A "
                            "change of up to 1 %, or of half an iteration, counts as hardly any.") +
                           claims_table(result.claims));
  for (const Scene scene : kScenes) body += page_section(scene_title(scene), scene_section(study, scene));
  body += page_section("Every reading", readings_section(study));
  body += page_section("What to know of the published method", defects_list(result.defects));
  body += page_section("All runs, by length in metres", cells_table(result.cells));
  body += page_section("How it was made", settings_section(result));
  return html_page("alate: " + result.title, body, std::string(kStudyStyle) + std::string(kTerrainStyle));
}

}  // namespace alate::mai2023
