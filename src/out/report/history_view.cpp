#include "out/report/history_view.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <optional>

#include "out/report/axis.hpp"
#include "out/report/svg.hpp"

namespace alate {

namespace {

constexpr double kWidth = 960;
constexpr double kCostHeight = 340;
constexpr double kShareHeight = 220;
constexpr double kMargins = 106;  ///< Above and below a diagram.

using History = std::vector<IterationStats>;
using Pick = std::function<std::optional<double>(const IterationStats&)>;

/// One line of a diagram.
struct Series {
  const char* css_class;
  const char* swatch;
  const char* name;
  Pick pick;
};

const std::vector<Series>& cost_series() {
  static const std::vector<Series> kSeries{
      {"ants worst", "s-worst", "Worst of the iteration", [](const IterationStats& s) { return s.worst; }},
      {"ants mean", "s-ants-mean", "Mean of the iteration", [](const IterationStats& s) { return s.mean; }},
      {"ants best", "s-best", "Best of the iteration", [](const IterationStats& s) { return s.best; }},
      {"route", "s-route", "Best so far", [](const IterationStats& s) { return s.best_so_far; }}};
  return kSeries;
}

const std::vector<Series>& share_series() {
  static const std::vector<Series> kSeries{
      {"route", "s-route", "Routes found", [](const IterationStats& s) { return std::optional(100 * s.arrived); }},
      {"ants mean", "s-ants-mean", "Moves onto a known trail",
       [](const IterationStats& s) { return s.known ? std::optional(100 * *s.known) : std::nullopt; }}};
  return kSeries;
}

/// From the least to the greatest cost shown, with a little room. The first, wild iterations may be cut off: the top is
/// the worst ant of the later half.
Scale cost_scale(const History& history, const PlotArea& area) {
  std::optional<double> low;
  std::optional<double> high;
  for (std::size_t i = 0; i < history.size(); ++i) {
    const IterationStats& now = history[i];
    if (now.best_so_far) low = std::min(low.value_or(*now.best_so_far), *now.best_so_far);
    const auto& top = now.worst ? now.worst : now.best_so_far;
    if (top && (i >= history.size() / 2 || !high))
      high = i == history.size() / 2 ? *top : std::max(high.value_or(*top), *top);
  }
  const double from = low.value_or(0);
  const double room = std::max(0.05 * (high.value_or(1) - from), 1e-3 * std::max(std::abs(from), 1.0));
  return {from - room, high.value_or(1) + room, area.corner.y() + area.size.y(), area.corner.y()};
}

/// Broken where there is nothing to show.
void draw_series(Svg& svg, const Axes& axes, const History& history, const Series& series) {
  std::vector<Vec2> line;
  const auto finish = [&] {
    if (line.size() == 1) svg.circle(line.front(), 2.5, "lowest-dot");
    if (line.size() > 1) svg.polyline(line, series.css_class);
    line.clear();
  };
  for (std::size_t i = 0; i < history.size(); ++i) {
    if (const auto value = series.pick(history[i]))
      line.emplace_back(axes.x(static_cast<double>(i + 1)), axes.y(*value));
    else
      finish();
  }
  finish();
}

std::string diagram(const History& history, const Axes& axes, const std::vector<Series>& lines,
                    std::string_view title) {
  std::vector<Series> shown;
  std::ranges::copy_if(lines, std::back_inserter(shown), [&](const Series& series) {
    return std::ranges::any_of(history, [&](const IterationStats& now) { return series.pick(now).has_value(); });
  });
  Svg svg(kWidth, axes.area.size.y() + kMargins, title);
  draw_axes(svg, axes);
  svg.begin_clip(axes.area.corner, axes.area.size);
  for (const Series& series : shown) draw_series(svg, axes, history, series);
  svg.end_clip();
  std::string items;
  for (const Series& series : shown)
    items += fmt::format("<li><span class=\"swatch {}\"></span>{}</li>\n", series.swatch, series.name);
  return fmt::format("<figure>\n{}<ul class=\"key\">\n{}</ul>\n</figure>\n", svg.str(), items);
}

Axes axes_over(const History& history, double height) {
  Axes axes{.area = {.corner = {76, 44}, .size = {kWidth - 100, height - kMargins}}};
  const double left = axes.area.corner.x();
  axes.x = {1, std::max(2.0, static_cast<double>(history.size())), left, left + axes.area.size.x()};
  axes.x_title = "Iteration";
  return axes;
}

}  // namespace

std::string history_figure(const std::vector<IterationStats>& history) {
  if (history.empty()) return {};
  Axes costs = axes_over(history, kCostHeight);
  costs.y = cost_scale(history, costs.area);
  costs.y_title = "Cost";
  Axes shares = axes_over(history, kShareHeight);
  shares.y = {0, 100, shares.area.corner.y() + shares.area.size.y(), shares.area.corner.y()};
  shares.y_title = "Share, %";
  return diagram(history, costs, cost_series(), "Cost of routes by iteration") +
         diagram(history, shares, share_series(), "Share of tries that found a route, by iteration");
}

}  // namespace alate
