#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "out/report/axis.hpp"
#include "study/matrix/views.hpp"

namespace alate {

namespace {

constexpr double kWidth = 420;
constexpr double kHeight = 300;
const PlotArea kArea{.corner = {62, 34}, .size = {340, 204}};

struct TimeAxes {
  Scale x;  ///< Logarithm of milliseconds.
  Scale y;

  Vec2 at(const MethodFigures& method, double gap) const { return {x(std::log10(1000 * method.mean_s)), y(gap)}; }
};

bool is_drawn(const MethodFigures& method) { return method.gap && method.mean_s > 0 && method.planner < kLineStyles; }

/// Whole decades around all times, and from zero to the highest mean.
TimeAxes axes_of(const StudyAnalysis& analysis) {
  double from = 1e9;
  double to = -1e9;
  double most = 0;
  for (const MethodFigures& method : analysis.methods) {
    if (!is_drawn(method)) continue;
    from = std::min(from, std::floor(std::log10(1000 * method.mean_s)));
    to = std::max(to, std::ceil(std::log10(1000 * method.mean_s)));
    most = std::max(most, method.gap->mean + method.gap_margin.value_or(0));
  }
  const Vec2 end = kArea.corner + kArea.size;
  return {.x = {from, std::max(to, from + 1), kArea.corner.x(), end.x()},
          .y = {0, most > 0 ? 1.05 * most : 1, end.y(), kArea.corner.y()}};
}

void draw_grid(Svg& svg, const TimeAxes& axes, const std::string& y_title) {
  const Vec2 end = kArea.corner + kArea.size;
  for (double power = axes.x.from; power <= axes.x.to; ++power) {
    svg.line({axes.x(power), kArea.corner.y()}, {axes.x(power), end.y()}, "grid");
    svg.text({axes.x(power), end.y() + 20}, fmt::format("{:g}", std::pow(10, power)), "tick", Anchor::middle);
  }
  const std::vector<double> marks = ticks(axes.y.from, axes.y.to, 5);
  for (const double value : marks) {
    svg.line({kArea.corner.x(), axes.y(value)}, {end.x(), axes.y(value)}, "grid");
    svg.text({kArea.corner.x() - 8, axes.y(value) + 5}, tick_label(value, marks[1] - marks[0]), "tick", Anchor::end);
  }
  svg.text({end.x(), end.y() + 44}, "ms", "axis", Anchor::end);
  svg.text({4, kArea.corner.y() - 14}, y_title, "axis");
}

void draw_planner(Svg& svg, const TimeAxes& axes, std::vector<const MethodFigures*> methods) {
  std::ranges::sort(methods, {}, &MethodFigures::mean_s);
  std::vector<Vec2> line;
  for (const MethodFigures* method : methods) {
    const double margin = method->gap_margin.value_or(0);
    line.push_back(axes.at(*method, method->gap->mean));
    svg.line(axes.at(*method, std::max(0.0, method->gap->mean - margin)), axes.at(*method, method->gap->mean + margin),
             "whisker " + line_class(*method));
  }
  if (line.size() > 1) svg.polyline(line, "best " + line_class(*methods.front()));
  for (std::size_t i = 0; i < methods.size(); ++i)
    svg.circle(
        line[i], 5, "node " + line_class(*methods[i]),
        fmt::format("{}: {:.3g} %, {:.3g} ms", methods[i]->name, methods[i]->gap->mean, 1000 * methods[i]->mean_s));
}

}  // namespace

std::string gap_time_svg(const StudyAnalysis& analysis) {
  if (std::ranges::none_of(analysis.methods, is_drawn)) return {};
  const TimeAxes axes = axes_of(analysis);
  Svg svg(kWidth, kHeight, "Mean gap over mean planning time");
  draw_grid(svg, axes, fmt::format("% above {}", words_of(analysis.yardstick)));
  for (std::size_t planner = 0; planner < kLineStyles; ++planner) {
    std::vector<const MethodFigures*> methods;
    for (const MethodFigures& method : analysis.methods)
      if (method.planner == planner && is_drawn(method)) methods.push_back(&method);
    if (!methods.empty()) draw_planner(svg, axes, std::move(methods));
  }
  return svg.str();
}

}  // namespace alate
