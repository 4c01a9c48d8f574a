#include "study/konatowski2019/page.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "out/report/page.hpp"
#include "out/report/tables.hpp"
#include "out/text.hpp"
#include "study/konatowski2019/layout_view.hpp"
#include "study/konatowski2019/overview.hpp"
#include "study/page/study_style.hpp"
#include "study/page/study_tables.hpp"

namespace alate::konatowski2019 {

namespace {

std::string facts(const Study& study, const Reproduction& result) {
  const Duel guided = duel(study, kGuided, kLiteral);
  return verdict_facts(result, fact(fmt::format("{} of {}", guided.won, guided.cells),
                                    fmt::format("cells where {} beats {}", kGuided, kLiteral)));
}

std::string introduction() {
  return "<p class=\"lead\">The paper plans a flight round threats with an ant colony that picks one of 125 rotations "
         "of "
         "the aircraft at each step. Here its rule runs as printed, with misprints mended, beside the next steps that "
         "it "
         "names, plain baselines and alate’s own planner. The paper shows its threats in a figure only (Figure 3), "
         "which "
         "cannot be read off: layouts A, C and F are ours, so its absolute costs cannot be told. What follows from its "
         "formulas and its printed numbers can.</p>\n";
}

}  // namespace

std::string page_html(const Study& study, const Reproduction& result) {
  std::string body = reproduction_header(result);
  body += introduction() + facts(study, result);
  body += page_section("Published beside ours", claims_table(result.claims));
  body += page_section("All methods at a glance", overview_table(study));
  body += page_section("What is wrong with the published definition", defects_list(result.defects));
  for (std::size_t layout = 0; layout < layouts().size(); ++layout)
    body += page_section("Layout " + layouts()[layout].name, layout_view(study, layout));
  body += page_section("All runs", cells_table(result.cells));
  body += page_section("How it was made", settings_section(result));
  return html_page("alate: " + result.title, body, kStudyStyle);
}

}  // namespace alate::konatowski2019
