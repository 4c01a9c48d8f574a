#include "out/report/errors_view.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <vector>

#include "check/corrections.hpp"
#include "out/report/axis.hpp"
#include "out/report/number_words.hpp"
#include "out/report/svg.hpp"

namespace alate {

namespace {

constexpr double kWidth = 1000;
constexpr double kHeight = 400;
const PlotArea kArea{{78, 46}, {902, 290}};
constexpr double kHalfMark = 9;  ///< Of a limit's mark.

/// What the errors do at one visit.
struct Fall {
  double along_m = 0;
  Errors before;
  Errors after;
  Navigation::Limits most;
  bool goal = false;
};

std::vector<Fall> falls_of(const Navigation& navigation, const Route& route) {
  std::vector<Fall> falls;
  Errors errors;
  double along = 0;
  for (const Visit& visit : visits_of(navigation, route)) {
    along += visit.length_m;
    const Errors before = grown(navigation, errors, visit.length_m);
    const bool corrects = visit.point != nullptr;
    errors = corrects ? corrected(before, visit.point->kind) : before;
    falls.push_back({.along_m = along,
                     .before = before,
                     .after = errors,
                     .most = corrects ? limits_at(navigation, visit.point->kind)
                                      : Navigation::Limits{navigation.theta, navigation.theta},
                     .goal = !corrects});
  }
  return falls;
}

double highest(const std::vector<Fall>& falls) {
  double high = 1e-9;
  for (const Fall& fall : falls)
    high = std::max({high, fall.before.vertical, fall.before.horizontal, fall.most.vertical, fall.most.horizontal});
  return high;
}

/// One of the two errors.
struct Series {
  double Errors::* error;
  double Navigation::Limits::* limit;
  const char* css;
};

constexpr std::array<Series, 2> kSeries{{{&Errors::vertical, &Navigation::Limits::vertical, "vertical"},
                                         {&Errors::horizontal, &Navigation::Limits::horizontal, "horizontal"}}};

struct Drawing {
  Svg& svg;
  Axes axes;
  double unit_m = 1;  ///< Of the x axis: 1 or 1000.

  Vec2 at(double along_m, double error) const { return {axes.x(along_m / unit_m), axes.y(error)}; }
};

void draw_limits(const Drawing& drawing, const std::vector<Fall>& falls, const Series& series) {
  for (const Fall& fall : falls) {
    const Vec2 limit = drawing.at(fall.along_m, fall.most.*series.limit);
    const Vec2 side{kHalfMark, 0};
    drawing.svg.line(limit - side, limit + side, fmt::format("error-limit {}", series.css));
  }
}

void draw_error(const Drawing& drawing, const std::vector<Fall>& falls, const Series& series) {
  std::vector<Vec2> line{drawing.at(0, 0)};
  for (const Fall& fall : falls) {
    line.push_back(drawing.at(fall.along_m, fall.before.*series.error));
    line.push_back(drawing.at(fall.along_m, fall.after.*series.error));
  }
  drawing.svg.polyline(line, fmt::format("error {}", series.css));
}

std::string legend(const Navigation& navigation) {
  return fmt::format(
      "<ul class=\"key\">\n<li><span class=\"swatch s-vertical\"></span>Vertical error</li>\n"
      "<li><span class=\"swatch s-horizontal\"></span>Horizontal error</li>\n"
      "<li class=\"note\">Short bars: the limit of the error of their colour, at the point where it is judged. Goal: "
      "both below {}. Every correction is shown to work.</li>\n</ul>\n",
      quantity(navigation.theta, "units"));
}

}  // namespace

std::string errors_figure(const Result& result) {
  const Route& route = result.plan.route;
  if (!result.site.navigation || route.states.size() < 2) return {};
  const std::vector<Fall> falls = falls_of(*result.site.navigation, route);
  const double length_m = std::max(falls.back().along_m, 1.0);
  const bool in_km = length_m >= 2000;
  const double unit_m = in_km ? 1000 : 1;
  Svg svg(kWidth, kHeight, "Vertical and horizontal navigation error along the way, with their limits");
  const Drawing drawing{svg,
                        {.area = kArea,
                         .x = {0, length_m / unit_m, kArea.corner.x(), kArea.corner.x() + kArea.size.x()},
                         .y = {0, 1.08 * highest(falls), kArea.corner.y() + kArea.size.y(), kArea.corner.y()},
                         .x_title = in_km ? "Distance flown, km" : "Distance flown, m",
                         .y_title = "Error, units"},
                        unit_m};
  draw_axes(svg, drawing.axes);
  for (const Series& series : kSeries) draw_limits(drawing, falls, series);
  for (const Series& series : kSeries) draw_error(drawing, falls, series);
  return fmt::format("<figure>\n{}{}</figure>\n", svg.str(), legend(*result.site.navigation));
}

}  // namespace alate
