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

std::string fact(const std::string& value, const std::string& name) {
  return fmt::format("<li><b>{}</b><span>{}</span></li>\n", value, name);
}

std::string facts(const Study& study, const Reproduction& result) {
  std::string items;
  for (const ClaimVerdict verdict :
       {ClaimVerdict::holds, ClaimVerdict::does_not_hold, ClaimVerdict::impossible, ClaimVerdict::cannot_be_told}) {
    const auto count = std::ranges::count(result.claims, verdict, &Claim::verdict);
    items += fact(fmt::format("{}", count), (count == 1 ? "claim: " : "claims: ") + verdict_words(verdict));
  }
  std::size_t runs = 0;
  for (const Cell& cell : result.cells) runs += cell.runs;
  items += fact(fmt::format("{}", runs), "runs");
  const Duel guided = duel(study, kGuided, kLiteral);
  items += fact(fmt::format("{} of {}", guided.won, guided.cells),
                fmt::format("cells where {} beats {}", kGuided, kLiteral));
  return fmt::format("<ul class=\"facts\">\n{}</ul>\n", items);
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

std::string settings_section(const Reproduction& result) {
  std::vector<std::pair<std::string, std::string>> rows;
  for (const auto& [name, value] : result.settings) {
    const std::string text = xml_escape(to_text(value));
    rows.emplace_back(name, name.starts_with("layout ") ? fmt::format("<pre>{}</pre>", text) : text);
  }
  return "<p class=\"lead\">Each run has one thread; times are of planning alone, and are longer if the machine had "
         "other "
         "work. Costs are what the independent check measures, and only routes that it passed are counted. A standard "
         "deviation is of the sample. Planners without chance run once.</p>\n" +
         pairs_table(rows);
}

}  // namespace

std::string page_html(const Study& study, const Reproduction& result) {
  std::string body =
      fmt::format("<header><p>alate reproduction of a paper</p><h1>{}</h1></header>\n", xml_escape(result.title));
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
