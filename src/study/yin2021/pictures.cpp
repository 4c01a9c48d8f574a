#include "study/yin2021/pictures.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "out/report/axis.hpp"
#include "out/report/grid_layer.hpp"
#include "out/report/map_frame.hpp"
#include "out/report/svg.hpp"
#include "out/text.hpp"

namespace alate::yin2021 {

namespace {

constexpr double kMapWidth = 620;
constexpr double kPlotWidth = 460;
constexpr double kPlotHeight = 304;
const PlotArea kArea{.corner = {62, 38}, .size = {380, 226}};

std::string line_key(const char* css_class, const std::string& name) {
  return fmt::format("<li><span class=\"swatch s-way {}\"></span>{}</li>\n", css_class, xml_escape(name));
}

/// The run with the least S, as the colony of the paper reports.
const StudyRun* best_by_score(const Trial& trial) {
  const StudyRun* best = nullptr;
  for (const StudyRun& run : trial.runs)
    if (run.passed && (best == nullptr || composite_index(*run.metrics.grid) < composite_index(*best->metrics.grid)))
      best = &run;
  return best;
}

std::string measures_words(const GridMeasures& measures) {
  return fmt::format("L {:.2f}, 100 F {:.1f}, T {}, S {:.1f}", measures.length_cells, 100 * measures.height_deviation_m,
                     measures.turns, composite_index(measures));
}

void draw_way(Svg& svg, const MapFrame& map, const Route& route, const char* css_class) {
  std::vector<Vec2> line;
  for (const RouteState& state : route.states) line.push_back(map(state.position));
  svg.polyline(line, "halo");
  svg.polyline(line, fmt::format("best {}", css_class));
}

/// One value a map, with the half width of its whisker.
struct Dot {
  double value = 0;
  double spread = 0;
};

/// Values by map, from the least; where they come from and what they are held against.
struct DotPlot {
  std::string title;
  std::string y_title;
  std::vector<Dot> dots;
  double published = 0;
  bool is_logarithm = false;  ///< Values are logarithms to base 10.
};

std::vector<double> marks(const DotPlot& plot, const Scale& y) {
  if (!plot.is_logarithm) return ticks(y.from, y.to, 6);
  std::vector<double> values;
  for (const double value : {0.001, 0.01, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 100.0, 1000.0})
    if (const double at = std::log10(value); at >= y.from && at <= y.to) values.push_back(at);
  return values;
}

/// Dots rise from the left, so no change is told on the left, above all that fell.
void draw_levels(Svg& svg, double none, double published) {
  const double left = kArea.corner.x();
  const double right = left + kArea.size.x();
  svg.line({left, none}, {right, none}, "direct");
  svg.line({left, published}, {right, published}, "limit");
  svg.text({left + 4, none - 6}, "no change", "label");
  svg.text({right - 4, published + 18}, "published", "label", Anchor::end);
}

std::string dot_figure(DotPlot plot) {
  std::ranges::sort(plot.dots, {}, &Dot::value);
  double low = std::min(0.0, plot.published);
  double high = 0;
  for (const Dot& dot : plot.dots) {
    low = std::min(low, dot.value - dot.spread);
    high = std::max(high, dot.value + dot.spread);
  }
  const double room = 0.08 * std::max(high - low, 0.1);
  const Vec2 end = kArea.corner + kArea.size;
  const Scale y{.from = low - room, .to = high + room, .pixel_from = end.y(), .pixel_to = kArea.corner.y()};
  const Scale x{
      .from = 0, .to = static_cast<double>(plot.dots.size()) + 1, .pixel_from = kArea.corner.x(), .pixel_to = end.x()};
  Svg svg(kPlotWidth, kPlotHeight, plot.title);
  for (const double mark : marks(plot, y)) {
    svg.line({kArea.corner.x(), y(mark)}, {end.x(), y(mark)}, "grid");
    svg.text({kArea.corner.x() - 8, y(mark) + 5}, fmt::format("{:g}", plot.is_logarithm ? std::pow(10, mark) : mark),
             "tick", Anchor::end);
  }
  svg.text({2, kArea.corner.y() - 14}, plot.y_title, "axis");
  svg.text({end.x(), end.y() + 26}, "maps, by this figure", "axis", Anchor::end);
  for (std::size_t i = 0; i < plot.dots.size(); ++i) {
    const Dot& dot = plot.dots[i];
    const double at = x(static_cast<double>(i) + 1);
    if (dot.spread > 0) svg.line({at, y(dot.value - dot.spread)}, {at, y(dot.value + dot.spread)}, "drop w0");
    svg.circle({at, y(dot.value)}, 3.4, "node w0");
  }
  draw_levels(svg, y(0), y(plot.published));
  return fmt::format("<figure><h4>{}</h4>\n{}</figure>\n", plot.title, svg.str());
}

/// Both methods on one map: mean, sd and runs of the lengths that were found.
std::optional<Dot> length_change(const Trial& of_li, const Trial& of_yin) {
  constexpr double kNormal95 = 1.96;
  const auto li = of_li.summary();
  const auto yin = of_yin.summary();
  if (!li || !yin || !li->sd || !yin->sd) return std::nullopt;
  const double error = std::sqrt(*li->sd * *li->sd / static_cast<double>(li->count) +
                                 *yin->sd * *yin->sd / static_cast<double>(yin->count));
  return Dot{.value = 100 * (yin->mean / li->mean - 1), .spread = 100 * kNormal95 * error / li->mean};
}

std::optional<Dot> variance_ratio(const Trial& of_li, const Trial& of_yin) {
  const auto li = final_variance(length_of)(of_li);
  const auto yin = final_variance(length_of)(of_yin);
  if (!li || !yin || *li <= 0 || *yin <= 0) return std::nullopt;
  return Dot{.value = std::log10(*yin / *li)};
}

}  // namespace

std::string routes_picture(const Study& study, Size size) {
  const SizeStudy& of_size = study.on(size);
  const Site& site = of_size.maps.cases.front().site();
  const Hillshade cells = grid_picture(*site.grid);
  const MapFrame map = map_frame(site, {}, kMapWidth);
  Svg svg(kMapWidth, map.height(), fmt::format("Best routes on {}", of_size.maps.cases.front().name));
  draw_grid(svg, map, *site.grid, cells);
  std::string keys;
  const std::array<std::pair<const char*, const char*>, 3> shown{{{kImproved, "w2"}, {kYin, "w0"}, {kLi, "w1"}}};
  for (const auto& [method, css_class] : shown) {
    const StudyRun* best = best_by_score(of_size.trial(0, method));
    if (best == nullptr) continue;
    draw_way(svg, map, best->plan.route, css_class);
    keys += line_key(css_class, fmt::format("{}: {}", method, measures_words(*best->metrics.grid)));
  }
  for (const Vec3& place : {site.mission.start, site.mission.goal}) svg.circle(map(place), 7, "end");
  keys += "<li><span class=\"swatch s-blocked\"></span>Blocked cell</li>\n" + height_key(cells, "Height from:");
  return fmt::format("<figure><h4>{}</h4>\n{}<ul class=\"key\">\n{}</ul>\n</figure>\n", of_size.maps.cases.front().name,
                     svg.str(), keys);
}

std::string maps_pictures(const Study& study, Size size) {
  const SizeStudy& of_size = study.on(size);
  DotPlot lengths{.title = fmt::format("{}: change of the mean length on each map", size_name(size)),
                  .y_title = "%",
                  .dots = {},
                  .published = kLengthChange_percent};
  DotPlot variances{.title = fmt::format("{}: ratio of the variances on each map", size_name(size)),
                    .y_title = "Yin / Li",
                    .dots = {},
                    .published = std::log10(1 + kVarianceChange_percent / 100),
                    .is_logarithm = true};
  for (std::size_t map = 0; map < of_size.maps.seeds.size(); ++map) {
    const Trial& li = of_size.trial(map, kLi);
    const Trial& yin = of_size.trial(map, kYin);
    if (const auto dot = length_change(li, yin)) lengths.dots.push_back(*dot);
    if (const auto dot = variance_ratio(li, yin)) variances.dots.push_back(*dot);
  }
  return dot_figure(std::move(lengths)) + dot_figure(std::move(variances));
}

}  // namespace alate::yin2021
