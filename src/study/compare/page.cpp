// The page of a comparison.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "alate/core/version.hpp"
#include "alate/data/scenario_file.hpp"
#include "out/report/page.hpp"
#include "out/report/routes_map.hpp"
#include "out/report/tables.hpp"
#include "out/text.hpp"
#include "study/compare/figures.hpp"
#include "study/compare/tables.hpp"
#include "study/machine.hpp"
#include "study/matrix/views.hpp"
#include "study/page/convergence_view.hpp"
#include "study/page/study_style.hpp"
#include "study/page/study_tables.hpp"
#include "study/spread.hpp"

namespace alate {

namespace {

constexpr double kMapWidth = 520;
constexpr double kLeastPercent = 0.01;  ///< A cost at the yardstick has no logarithm.

constexpr std::string_view kCompareStyle = R"css(
svg .route.faint { stroke-width: 2; opacity: .55; }
.maps h4 { font-size: 1rem; }
.maps .soft { margin: .2rem 0 0; }
)css";

/// Line styles of those who are drawn, by rank. A planner has that of its place among all planners, so that it looks
/// the same on every page; where there are more planners than styles, one that is free.
std::vector<std::size_t> line_styles(const Ranking& ranks) {
  std::vector<std::size_t> styles(std::min(ranks.size(), kLineStyles), kLineStyles);
  std::array<bool, kLineStyles> taken{};
  const auto take = [&](std::size_t rank, std::size_t style) {
    styles[rank] = style;
    taken[style] = true;
  };
  for (std::size_t rank = 0; rank < styles.size(); ++rank)
    if (ranks[rank].contender < kLineStyles) take(rank, ranks[rank].contender);
  for (std::size_t rank = 0; rank < styles.size(); ++rank)
    if (styles[rank] == kLineStyles)
      take(rank, static_cast<std::size_t>(std::ranges::find(taken, false) - taken.begin()));
  return styles;
}

class ComparePage {
 public:
  explicit ComparePage(const Comparison& comparison)
      : comparison_(comparison),
        last_(comparison.times_s.size() - 1),
        ranks_(ranking(comparison, last_)),
        styles_(line_styles(ranks_)) {
    best_ = best_cost(comparison);
  }

  std::string html() const {
    const std::string title = "Planners compared: " + site().scenario.file;
    std::string body = fmt::format("<header><p>alate comparison</p><h1>{}</h1></header>\n", xml_escape(title));
    body += facts() + page_section("In short", in_short());
    body += page_section("Cost against time", cost_against_time());
    body += page_section("When all time was up", final_table(comparison_, ranks_));
    body += page_section("Median cost, time by time", times_table(comparison_, ranks_));
    body += page_section("The routes", maps());
    body += page_section("What the check refuses", broken_table(comparison_, ranks_));
    body += page_section("Not in this comparison", absent_table(comparison_));
    body += page_section("How it was made", settings());
    return html_page(title, body, std::string(kStudyStyle) + std::string(kViewStyle) + std::string(kCompareStyle));
  }

 private:
  const Site& site() const { return comparison_.world.site(); }
  const Contender& contender(const CompareFigures& each) const { return comparison_.contenders[each.contender]; }
  std::string facts() const {
    std::size_t passed = 0;
    for (const CompareRun& run : comparison_.runs) passed += run.marks.back().standing == Standing::passed ? 1U : 0U;
    std::string items = fact(time_words(comparison_.times_s.back()), "time for each run");
    items += fact(fmt::format("{}", ranks_.size()), "planners");
    items += fact(fmt::format("{}", comparison_.runs.size()), "runs");
    items += fact(fmt::format("{}", passed), "end with a route that passes");
    if (best_) items += fact(cost_words(*best_), "best cost known");
    if (comparison_.lower_bound > 0) items += fact(cost_words(comparison_.lower_bound), "no route costs less");
    return fmt::format("<ul class=\"facts\">\n{}</ul>\n", items);
  }

  std::string in_short() const {
    std::string text;
    if (comparison_.stopped) text += "<p class=\"lead\"><b>Stopped before all runs were made.</b></p>\n";
    for (const std::string& each : findings(comparison_))
      text += fmt::format("<p class=\"lead\">{}</p>\n", xml_escape(each));
    return text;
  }

  /// Median and quartiles of a contender where its median run has a route; nothing at other times.
  Convergence line_of(const CompareFigures& each, std::size_t style) const {
    Convergence line{.css_class = fmt::format("w{}", style), .points = {}};
    for (std::size_t time = 0; time <= last_; ++time) {
      const CompareFigures figures = figures_of(comparison_, each.contender, time);
      const auto spread = spread_of(figures.costs);
      if (!figures.solves() || !spread) continue;
      const auto percent = [&](double cost) { return std::max(kLeastPercent, 100 * (cost / *best_ - 1)); };
      line.points.push_back({.at = comparison_.times_s[time],
                             .best = percent(figures.median),
                             .least = percent(spread->lower_quartile),
                             .greatest = percent(spread->upper_quartile)});
    }
    return line;
  }

  std::string cost_against_time() const {
    if (!best_ || *best_ <= 0) return "";
    std::vector<Convergence> lines;
    for (std::size_t rank = 0; rank < styles_.size(); ++rank) {
      Convergence line = line_of(ranks_[rank], styles_[rank]);
      if (line.points.size() > 1) lines.push_back(std::move(line));
    }
    if (lines.empty()) return "";
    const std::string svg = convergence_svg(
        lines, percent_range({lines}), "Cost against time",
        {.from = comparison_.times_s.front(), .x_title = "seconds", .y_title = "% above the best known"});
    return fmt::format(
        "<p class=\"lead\">The median run of the six that end best, and the band that holds the middle half of the "
        "routes that pass; beside it how these spread when all time was up. Both axes are logarithmic, and a line "
        "begins where the median run has a route that passes. The best known is the cheapest route of this comparison, "
        "so the "
        "planner that found it may come down to the axis.</p>\n<div "
        "class=\"panels wide\"><figure>{}</figure>{}</div>\n{}",
        svg, boxes(), key());
  }

  std::string key() const {
    std::string items;
    for (std::size_t rank = 0; rank < styles_.size(); ++rank)
      if (ranks_[rank].solves())
        items += fmt::format("<li><span class=\"swatch s-way w{}\"></span>{}</li>\n", styles_[rank],
                             shown_name(comparison_, ranks_[rank]));
    return fmt::format("<ul class=\"key\">\n{}</ul>\n", items);
  }

  /// Routes that pass, when all time was up. There is a best cost.
  std::string boxes() const {
    const Study study{.budgets = {{.time_s = comparison_.times_s.back()}}};
    StudyAnalysis analysis;
    for (std::size_t rank = 0; rank < ranks_.size(); ++rank) {
      MethodFigures method{.planner = rank < styles_.size() ? styles_[rank] : rank,
                           .name = contender(ranks_[rank]).name};
      for (const double cost : ranks_[rank].costs) method.gaps.push_back(100 * (cost / *best_ - 1));
      method.gap = summarize(method.gaps);
      analysis.methods.push_back(std::move(method));
    }
    const std::string svg = box_svg(study, analysis, 0);
    return svg.empty() ? "" : fmt::format("<figure>{}</figure>", svg);
  }

  /// One frame that holds all routes.
  MapFrame frame() const {
    Route all;
    for (const CompareRun& run : comparison_.runs)
      all.states.insert(all.states.end(), run.route.states.begin(), run.route.states.end());
    return map_frame(site(), all, kMapWidth);
  }

  std::string maps() const {
    const MapFrame map = frame();
    std::string panels;
    for (const CompareFigures& each : ranks_) {
      if (each.typical == nullptr || each.typical->route.empty()) continue;
      std::vector<MapRoute> routes;
      for (const CompareRun& run : comparison_.runs)
        if (run.contender == each.contender && !run.route.empty())
          routes.push_back({.route = &run.route, .faint = &run != each.typical});
      std::ranges::find(routes, false, &MapRoute::faint)->verdict = &each.typical->verdict;
      const CompareMark& mark = each.typical->marks.back();
      panels += fmt::format(
          "<figure><h4>{}</h4>{}<p class=\"soft\">{}: cost {}, {:.0f} m long, up {:.0f} m</p></figure>\n",
          shown_name(comparison_, each), routes_map(site(), map, routes, "Routes of " + contender(each).name),
          mark.standing == Standing::passed ? "passed" : xml_escape("not allowed: " + why_not(mark)),
          cost_words(mark.metrics.cost), mark.metrics.length_m, mark.metrics.climb_m);
    }
    if (panels.empty()) return "";
    return "<p class=\"lead\">Thick: the route of the median run; thin: those of the other seeds; crosses: where it "
           "breaks a rule.</p>\n<div class=\"panels wide maps\">\n" +
           panels + "</div>\n";
  }

  static std::string why_not(const CompareMark& mark) {
    return mark.standing == Standing::late ? "too late" : mark.broken;
  }

  std::string settings() const {
    const Machine machine = this_machine();
    std::string contenders;
    for (const Contender& each : comparison_.contenders)
      contenders += fmt::format("{}{}{}: {}<br/>", xml_escape(each.name), each.preset.empty() ? "" : ", preset ",
                                xml_escape(each.preset), xml_escape(each.help));
    std::string times;
    for (const double time : comparison_.times_s) times += (times.empty() ? "" : ", ") + time_words(time);
    return "<p class=\"lead\">One run after another, seed by seed, each on one thread; reading the scenario is not in "
           "the time. Ours make a run of its own for each time. A planner of another program hands over each better "
           "route "
           "with its time, and one run tells of all. A route that comes later than its time by more than a twentieth, "
           "or 5 ms, is too late. Planners that no seed changes run once. Times are of this machine, and longer if it "
           "had "
           "other work.</p>\n" +
           pairs_table({{"alate", version()},
                        {"scenario", xml_escape(site().scenario.file)},
                        {"times", times},
                        {"seeds", fmt::format("1 to {}", comparison_.seeds)},
                        {"processor", xml_escape(machine.processor)},
                        {"cores", fmt::format("{}", machine.cores)},
                        {"compiler", xml_escape(machine.compiler)},
                        {"planners", contenders}}) +
           fmt::format("<details><summary>The scenario, as it was read</summary>\n<pre>{}</pre></details>\n",
                       xml_escape(to_yaml(site().scenario)));
  }

  const Comparison& comparison_;
  std::size_t last_;
  Ranking ranks_;
  std::vector<std::size_t> styles_;
  std::optional<double> best_;
};

}  // namespace

std::string compare_html(const Comparison& comparison) { return ComparePage(comparison).html(); }

}  // namespace alate
