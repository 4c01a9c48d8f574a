#include "out/report/report.hpp"

#include <fmt/core.h>

#include <filesystem>

#include "alate/data/scenario_file.hpp"
#include "out/notes.hpp"
#include "out/report/errors_view.hpp"
#include "out/report/front_view.hpp"
#include "out/report/history_view.hpp"
#include "out/report/map_view.hpp"
#include "out/report/number_words.hpp"
#include "out/report/page.hpp"
#include "out/report/profile_view.hpp"
#include "out/report/tables.hpp"
#include "out/text.hpp"

namespace alate {

namespace {

/// The scenario's folder and file name without extension, as far as they tell one run from another.
std::string title_of(const Scenario& scenario) {
  if (scenario.file.empty() || scenario.file == "-") return "Route";
  const std::filesystem::path file(scenario.file);
  const std::string folder = file.parent_path().filename().string();
  return file.stem() == "scenario" && !folder.empty() && folder != "." && folder != ".." ? folder
                                                                                         : file.stem().string();
}

std::string verdict_banner(const Result& result) {
  const bool found = !result.plan.route.empty();
  const Status status = found ? result.verdict.status : Status::fail;
  const char* css = status == Status::pass ? "pass" : status == Status::fail ? "fail" : "unknown";
  const char* mark = status == Status::pass ? "✓" : status == Status::fail ? "✕" : "?";
  return fmt::format("<p class=\"verdict {}\"><b>{}</b>{}</p>\n", css, mark, xml_escape(summary(result)));
}

std::string fact(const std::string& value, const std::string& name) {
  return fmt::format("<li><b>{}</b><span>{}</span></li>\n", value, name);
}

std::string facts(const Result& result) {
  const Metrics& metrics = result.metrics;
  std::string items =
      fact(metrics.grid ? quantity(metrics.length_m, "m") : length_in_words(metrics.length_m), "length");
  if (metrics.min_clearance_m) {
    const double asked = result.site.band.clearance_m;
    items += fact(fmt::format("{:.0f} m", *metrics.min_clearance_m),
                  fmt::format("lowest above ground, {:.0f} m asked", asked));
  }
  if (metrics.corrections) items += fact(fmt::format("{}", *metrics.corrections), "corrections");
  if (metrics.probability) items += fact(chance_in_words(*metrics.probability), "chance of success");
  if (metrics.grid) {
    items += fact(fmt::format("{}", metrics.grid->turns), "turns");
    items += fact(quantity(metrics.grid->height_deviation_m, "m"), "deviation of height");
    items += fact(fmt::format("{:.2f}", composite_index(*metrics.grid)), "composite index");
  } else {
    items += fact(fmt::format("{:.0f} m", metrics.climb_m), "climb, all told");
  }
  if (!result.site.threats.empty()) {
    const bool physical = result.site.scenario.objective.model == CostModel::physical;
    items += fact(fmt::format("{:.0f}{}", metrics.threat, physical ? " m" : ""), "exposure to threats");
  }
  if (const auto& speed = result.site.vehicle.speed_mps)
    items += fact(fmt::format("{:.0f} min", metrics.length_m / *speed / 60), fmt::format("at {:.3g} m/s", *speed));
  return fmt::format("<ul class=\"facts\">\n{}</ul>\n", items);
}

std::string file_list(const Result& result) {
  std::string items;
  for (const std::string& file : result.files)
    items += fmt::format("<li><a href=\"{0}\">{0}</a></li>\n", xml_escape(file));
  return items.empty() ? "" : fmt::format("<ul>\n{}</ul>\n", items);
}

std::string warning_list(const Result& result) {
  std::string items;
  for (const std::string& warning : all_warnings(result)) items += fmt::format("<li>{}</li>\n", xml_escape(warning));
  return items.empty() ? "" : fmt::format("<ul>\n{}</ul>\n", items);
}

std::string scenario_text(const Scenario& scenario) {
  return fmt::format("<details><summary>The scenario, as it was read</summary>\n<pre>{}</pre></details>\n",
                     xml_escape(to_yaml(scenario)));
}

std::string body(const Result& result) {
  const bool found = !result.plan.route.empty();
  std::string html = fmt::format("<header><p>alate route report</p><h1>{}</h1></header>\n",
                                 xml_escape(title_of(result.site.scenario)));
  html += verdict_banner(result);
  if (found) html += facts(result);
  html += page_section("Map", map_figure(result));
  if (!result.site.grid || result.site.has_ground())
    html += page_section("Height along the way", profile_figure(result));
  html += page_section("Navigation errors along the way", errors_figure(result));
  html += page_section("The best trade-offs", front_figure(result));
  if (found) html += page_section("What was checked", rules_table(result));
  html += page_section("How the search went", history_figure(result.plan.history));
  html += page_section("Numbers", numbers_table(result));
  html += page_section("To know before flying", warning_list(result));
  html += page_section("How it was made", settings_table(result) + scenario_text(result.site.scenario));
  html += page_section("Files", file_list(result));
  return html + fmt::format("<p class=\"notice\">{}</p>\n", xml_escape(notice(result.site)));
}

}  // namespace

std::string report_html(const Result& result) {
  return html_page("alate: " + title_of(result.site.scenario), body(result));
}

}  // namespace alate
