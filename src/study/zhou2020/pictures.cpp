#include "study/zhou2020/pictures.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "ga/adaptive_rates.hpp"
#include "out/report/axis.hpp"
#include "out/report/map_frame.hpp"
#include "out/report/point_layer.hpp"
#include "out/report/svg.hpp"
#include "out/route_points.hpp"
#include "out/text.hpp"
#include "plan/correction/correction_planners.hpp"
#include "space/correction_route.hpp"
#include "study/page/convergence_view.hpp"

namespace alate::zhou2020 {

namespace {

constexpr double kMapWidth = 1000;
constexpr std::size_t kChromosomesDrawn = 6;

struct DrawnRoute {
  const Route* route = nullptr;
  std::string css_class;
  std::string name;
};

void draw_line(Svg& svg, const MapFrame& map, const DrawnRoute& drawn) {
  std::vector<Vec2> line;
  for (const Vec3& at : drawn_line(*drawn.route)) line.push_back(map(at));
  svg.polyline(line, "best " + drawn.css_class);
}

std::string line_key(const std::string& css_class, const std::string& name) {
  return fmt::format("<li><span class=\"swatch s-way {}\"></span>{}</li>\n", css_class, xml_escape(name));
}

/// Points, straight line and the given routes.
std::string points_figure(const Site& site, const std::vector<DrawnRoute>& routes, const std::string& title) {
  const MapFrame map = map_frame(site, *routes.front().route, kMapWidth);
  Svg svg(kMapWidth, map.height(), title);
  svg.rect({0, 0}, {svg.width(), svg.height()}, "blank");
  draw_points(svg, map, site);
  svg.line(map(site.mission.start), map(site.mission.goal), "direct");
  std::string keys;
  for (const DrawnRoute& drawn : routes) {
    draw_line(svg, map, drawn);
    if (!drawn.name.empty()) keys += line_key(drawn.css_class, drawn.name);
  }
  draw_used_points(svg, map, site, *routes.front().route);
  return fmt::format("<figure>\n{}<ul class=\"key\">\n{}{}</ul>\n</figure>\n", svg.str(), keys, points_key(map, site));
}

/// The published route of problem 1 on this set that comes nearest to the optimum; null if none keeps the limits.
const JudgedRow* best_published(const std::vector<JudgedRow>& rows, std::size_t set) {
  const JudgedRow* best = nullptr;
  for (const JudgedRow& row : rows) {
    const bool counts = row.published->set == set && row.published->task == Task::straight && row.gap;
    if (counts && (best == nullptr || *row.gap < *best->gap)) best = &row;
  }
  return best;
}

void draw_rate(Svg& svg, const Axes& axes, const AdaptiveRate& rate, const std::string& css_class) {
  constexpr int kPieces = 200;
  constexpr FitnessStats kStats{.mean = 0.5, .most = 1};
  std::vector<Vec2> line;
  for (int i = 0; i <= kPieces; ++i) {
    const double fitness = static_cast<double>(i) / kPieces;
    line.emplace_back(axes.x(fitness), axes.y(rate(fitness, kStats)));
  }
  svg.polyline(line, "best " + css_class);
}

}  // namespace

std::string routes_picture(const Study& study, std::size_t set, const std::vector<JudgedRow>& rows) {
  std::vector<DrawnRoute> routes{
      {.route = &study.proven(set, Task::straight).route, .css_class = "w0", .name = "Proven optimum"}};
  if (const StudyRun* best = study.trial(set, kImproved).best())
    routes.push_back({.route = &best->plan.route, .css_class = "w1", .name = kImproved});
  if (const JudgedRow* published = best_published(rows, set))
    routes.push_back(
        {.route = &published->judged->route, .css_class = "w2", .name = "Published: " + published->published->source});
  return points_figure(study.site(set, Task::straight), routes,
                       fmt::format("Routes among the points of {}", set_name(set)));
}

std::string population_picture(const Study& study, std::size_t set) {
  const StudyCase& each = study.methods.cases[set];
  const auto chromosomes =
      first_chromosomes(Problem(each.world), study.trial(set, kPaperGa).planner.parameters, kChromosomesDrawn);
  std::vector<Route> flown;
  for (const auto& ids : chromosomes) flown.push_back(route_through(each.site(), ids).route);
  std::vector<DrawnRoute> routes;
  for (std::size_t i = 0; i < flown.size(); ++i)
    routes.push_back({.route = &flown[i], .css_class = fmt::format("w{}", i % 3), .name = ""});
  return points_figure(each.site(), routes, fmt::format("First population on {}", set_name(set)));
}

std::string rates_picture(const Study& study) {
  const ParamValues& values = study.trial(0, kPaperGa).planner.parameters;
  const AdaptiveRate crossover{.high = values.number("pr1"), .low = values.number("pr2")};
  const AdaptiveRate mutation{.high = values.number("pm1"), .low = values.number("pm2")};
  Svg svg(600, 330, "Adaptive rates over fitness");
  const PlotArea area{.corner = {70, 34}, .size = {500, 226}};
  const Axes axes{.area = area,
                  .x = {.from = 0, .to = 1, .pixel_from = area.corner.x(), .pixel_to = area.corner.x() + area.size.x()},
                  .y = {.from = 0, .to = 1, .pixel_from = area.corner.y() + area.size.y(), .pixel_to = area.corner.y()},
                  .x_title = "fitness, share of the greatest; the mean at 0.5",
                  .y_title = "rate"};
  draw_axes(svg, axes);
  draw_rate(svg, axes, crossover, "w0");
  draw_rate(svg, axes, mutation, "w1");
  return fmt::format("<div class=\"panels\"><figure>\n{}<ul class=\"key\">\n{}{}</ul>\n</figure></div>\n", svg.str(),
                     line_key("w0", "Crossover"), line_key("w1", "Mutation"));
}

std::string fitness_picture(const Study& study, std::size_t set) {
  std::vector<Convergence> lines;
  std::string keys;
  const std::array<std::pair<const char*, const char*>, 3> shown{
      {{kPaperGa, "w0"}, {kPlainGa, "w1"}, {kImproved, "w2"}}};
  for (const auto& [method, css_class] : shown) {
    lines.push_back(convergence(study.trial(set, method), css_class));
    keys += line_key(css_class, lines.back().points.empty() ? std::string(method) + ": not every seed found a route"
                                                            : std::string(method));
  }
  return fmt::format("<figure>\n{}<ul class=\"key\">\n{}</ul>\n</figure>\n",
                     convergence_svg(lines, percent_range({lines}), set_name(set)), keys);
}

}  // namespace alate::zhou2020
