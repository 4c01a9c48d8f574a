// Curves over the iterations.
#include <fmt/core.h>

#include <algorithm>
#include <ranges>

#include "out/report/axis.hpp"
#include "out/report/svg.hpp"
#include "out/text.hpp"
#include "study/yin2021/pictures.hpp"

namespace alate::yin2021 {

namespace {

constexpr double kWidth = 420;
constexpr double kHeight = 300;
const PlotArea kArea{.corner = {62, 38}, .size = {340, 196}};

struct Shown {
  const char* title;
  Pick pick;
  double factor;  ///< Shown so many times as large.
};

constexpr std::array<Shown, 5> kShown{{{"Length L of the best route, cell sides", length_of, 1},
                                       {"Its height deviation, 100 F", deviation_of, 100},
                                       {"Its turns T", turns_of, 1},
                                       {"Its composite index S", score_of, 1},
                                       {"Mean S of the ants", mean_score_of, 1}}};

struct Point {
  double iteration = 0;
  double mean = 0;
  double low = 0;  ///< A quarter of the maps lie below.
  double high = 0;
};

struct Curve {
  const char* css_class;
  std::vector<Point> points;
};

/// Over the maps that have a figure at each iteration.
Curve curve_of(const SizeStudy& of_size, const char* method, const char* css_class, const Shown& shown) {
  Curve curve{.css_class = css_class, .points = {}};
  std::size_t iterations = 0;
  for (std::size_t map = 0; map < of_size.maps.seeds.size(); ++map)
    for (const StudyRun& run : of_size.trial(map, method).runs)
      iterations = std::max(iterations, run.plan.history.size());
  for (std::size_t iteration = 1; iteration <= iterations; ++iteration) {
    std::vector<double> values;
    for (std::size_t map = 0; map < of_size.maps.seeds.size(); ++map)
      if (const auto value = mean_at(iteration, shown.pick)(of_size.trial(map, method)))
        values.push_back(shown.factor * *value);
    if (values.empty()) continue;
    std::ranges::sort(values);
    const std::size_t quarter = (values.size() - 1) / 4;
    curve.points.push_back({.iteration = static_cast<double>(iteration),
                            .mean = *mean_of(values),
                            .low = values[quarter],
                            .high = values[values.size() - 1 - quarter]});
  }
  return curve;
}

Axes axes_over(const std::vector<Curve>& curves) {
  Axes axes{.area = kArea, .x_title = "iteration"};
  std::vector<double> values;
  double last = 2;
  for (const Curve& curve : curves) {
    for (const Point& point : curve.points) {
      for (const double value : {point.low, point.mean, point.high}) values.push_back(value);
      last = std::max(last, point.iteration);
    }
  }
  const auto [low, high] = values.empty() ? std::ranges::minmax_result<double>{0, 1} : std::ranges::minmax(values);
  const double room = std::max(0.05 * (high - low), 0.01);
  const Vec2 end = kArea.corner + kArea.size;
  axes.x = {.from = 1, .to = last, .pixel_from = kArea.corner.x(), .pixel_to = end.x()};
  axes.y = {.from = low - room, .to = high + room, .pixel_from = end.y(), .pixel_to = kArea.corner.y()};
  return axes;
}

void draw(Svg& svg, const Axes& axes, const Curve& curve) {
  std::vector<Vec2> line;
  std::vector<Vec2> band;
  for (const Point& point : curve.points) {
    line.emplace_back(axes.x(point.iteration), axes.y(point.mean));
    band.emplace_back(axes.x(point.iteration), axes.y(point.low));
  }
  for (const Point& point : std::views::reverse(curve.points))
    band.emplace_back(axes.x(point.iteration), axes.y(point.high));
  svg.polygon(band, fmt::format("seeds {}", curve.css_class));
  svg.polyline(line, fmt::format("best {}", curve.css_class));
}

std::string figure(const SizeStudy& of_size, const Shown& shown) {
  const std::vector<Curve> curves{curve_of(of_size, kYin, "w0", shown), curve_of(of_size, kLi, "w1", shown)};
  const Axes axes = axes_over(curves);
  Svg svg(kWidth, kHeight, shown.title);
  draw_axes(svg, axes);
  for (const Curve& curve : curves) draw(svg, axes, curve);
  return fmt::format("<figure><h4>{}</h4>\n{}</figure>\n", shown.title, svg.str());
}

}  // namespace

std::string curves_pictures(const Study& study, Size size) {
  std::string html = "<div class=\"panels\">\n";
  for (const Shown& shown : kShown) html += figure(study.on(size), shown);
  return html +
         fmt::format(
             "</div>\n<ul class=\"key\">\n<li><span class=\"swatch s-way w0\"></span>{}</li>\n<li><span "
             "class=\"swatch s-way w1\"></span>{}</li>\n<li><span class=\"swatch s-seeds\"></span>middle half of "
             "the maps</li>\n</ul>\n",
             xml_escape(kYin), xml_escape(kLi));
}

}  // namespace alate::yin2021
