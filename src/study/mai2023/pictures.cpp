#include "study/mai2023/pictures.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <numeric>

#include "out/report/axis.hpp"
#include "out/report/profile.hpp"
#include "out/report/svg.hpp"
#include "out/text.hpp"
#include "study/page/convergence_view.hpp"
#include "study/page/terrain_view.hpp"

namespace alate::mai2023 {

namespace {

constexpr const char* kLeast = "the least F of the lattice";

struct Shown {
  std::string name;
  std::string css_class;
  Route route;
};

/// The run with the least F, the first of equals; null if none has a route.
const StudyRun* best_run(const Trial& trial) {
  const StudyRun* best = nullptr;
  for (const StudyRun& run : trial.runs)
    if (figure(trial, run, kFitness) &&
        (best == nullptr || *figure(trial, run, kFitness) < *figure(trial, *best, kFitness)))
      best = &run;
  return best;
}

Route route_over(const std::vector<Vec3>& places) {
  Route route;
  for (const Vec3& place : places)
    route.states.push_back({.position = place, .leg = route.states.empty() ? LegKind::start : LegKind::straight});
  return route;
}

std::vector<Shown> shown_routes(const Study& study, Scene scene) {
  std::vector<Shown> all;
  const auto add = [&](const char* method, const char* css_class) {
    if (const StudyRun* run = best_run(study.trial(scene, method)))
      all.push_back({.name = method, .css_class = css_class, .route = run->plan.route});
  };
  add(kMai, "w0");
  add(kAco, "w1");
  all.push_back({.name = kLeast, .css_class = "w2", .route = route_over(study.optimum[scene].places)});
  return all;
}

std::string key_item(const std::string& css_class, const std::string& name) {
  return fmt::format("<li><span class=\"swatch s-way {}\"></span>{}</li>\n", css_class, xml_escape(name));
}

constexpr double kKm = 1000;
constexpr double kWidth = 420;
constexpr double kHeight = 250;
const PlotArea kArea{.corner = {72, 34}, .size = {330, 156}};

struct HeightRange {
  double from = 0;
  double to = 1;
};

/// Over the way flown, both in km.
std::string profile(const Site& site, const Shown& shown, const HeightRange& range) {
  constexpr int kSamples = 300;
  const std::vector<ProfileSample> samples = sample_profile(site, shown.route, kSamples);
  const Vec2 end = kArea.corner + kArea.size;
  const Axes axes{.area = kArea,
                  .x = {0, samples.back().along_m / kKm, kArea.corner.x(), end.x()},
                  .y = {range.from, range.to, end.y(), kArea.corner.y()},
                  .x_title = "flown, km",
                  .y_title = "height, km"};
  std::vector<Vec2> ground{{kArea.corner.x(), end.y()}};
  std::vector<Vec2> way;
  for (const ProfileSample& sample : samples) {
    ground.emplace_back(axes.x(sample.along_m / kKm), axes.y(sample.ground_m.value_or(0) / kKm));
    way.emplace_back(axes.x(sample.along_m / kKm), axes.y(sample.position.z() / kKm));
  }
  ground.push_back(end);
  Svg svg(kWidth, kHeight, "Heights along the route of " + shown.name);
  draw_axes(svg, axes);
  svg.polygon(ground, "ground");
  svg.polyline(way, "best " + shown.css_class);
  return fmt::format("<figure><h4>{}</h4>\n{}</figure>\n", xml_escape(shown.name), svg.str());
}

HeightRange height_range(const Site& site, const std::vector<Shown>& routes) {
  constexpr int kSamples = 300;
  HeightRange range{.from = 0, .to = 1};
  for (const Shown& each : routes)
    for (const ProfileSample& sample : sample_profile(site, each.route, kSamples))
      range.to = std::max({range.to, sample.position.z() / kKm, sample.ground_m.value_or(0) / kKm});
  return {.from = range.from, .to = 1.08 * range.to};
}

struct Line {
  const char* method;
  const char* css_class;
};
using Panel = std::array<Line, 3>;

std::string curve_key(const Panel& panel) {
  return std::accumulate(panel.begin(), panel.end(), std::string(), [](const std::string& items, const Line& line) {
    return items + key_item(line.css_class, line.method);
  });
}

}  // namespace

std::string routes_picture(const Study& study, Scene scene) {
  const std::vector<Shown> shown = shown_routes(study, scene);
  std::vector<SceneRoute> routes;
  std::string key;
  for (const Shown& each : shown) {
    routes.push_back({.route = &each.route, .css_class = each.css_class});
    key += key_item(each.css_class, each.name);
  }
  const TerrainPicture picture{.world = study.main.cases[scene].world,
                               .area = {.min = Vec2::Zero(), .max = Vec2::Constant(50 * kKm)}};
  return fmt::format(
      "<figure>\n{}<ul class=\"key\">\n{}<li class=\"note\">The best run of each by F. Heights are drawn {:g} times "
      "larger than distances; where a hill hides a route it shines through.</li>\n</ul>\n</figure>\n",
      terrain_svg(picture, routes, fmt::format("Best routes over the scene {}", kSceneNames[scene])), key,
      picture.exaggeration);
}

std::string profiles_pictures(const Study& study, Scene scene) {
  const std::vector<Shown> shown = shown_routes(study, scene);
  const Site& site = study.main.cases[scene].site();
  const HeightRange range = height_range(site, shown);
  std::string html = "<div class=\"panels\">\n";
  for (const Shown& each : shown) html += profile(site, each, range);
  return html + "</div>\n";
}

std::string curves_pictures(const Study& study, Scene scene) {
  static constexpr std::array<Panel, 2> kPanels{
      {{{{kMai, "w0"}, {kAco, "w1"}, {kImprovedF, "w2"}}}, {{{kSelection, "w0"}, {kUpdate, "w1"}, {kMaiBlind, "w2"}}}}};
  std::vector<std::vector<Convergence>> diagrams;
  for (const Panel& panel : kPanels) {
    std::vector<Convergence> lines;
    for (const Line& line : panel) {
      Convergence drawn = convergence(study.trial(scene, line.method), line.css_class, study.optimum[scene].score);
      if (!drawn.points.empty()) lines.push_back(std::move(drawn));
    }
    diagrams.push_back(std::move(lines));
  }
  const PercentRange range = percent_range(diagrams);
  std::string html = "<div class=\"panels wide\">\n";
  for (std::size_t p = 0; p < kPanels.size(); ++p)
    html += fmt::format("<figure>{}<ul class=\"key\">\n{}</ul></figure>\n",
                        convergence_svg(diagrams[p], range, "Best F over the iterations"), curve_key(kPanels[p]));
  return html +
         "</div>\n<ul class=\"key\">\n<li><span class=\"swatch s-mean\"></span>mean of the ants</li>\n<li><span "
         "class=\"swatch s-seeds\"></span>best to worst seed</li>\n</ul>\n";
}

}  // namespace alate::mai2023
