#include "study/konatowski2019/layout_view.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "out/text.hpp"
#include "study/intrusion.hpp"
#include "study/page/convergence_view.hpp"
#include "study/page/scene_view.hpp"
#include "study/page/study_tables.hpp"

namespace alate::konatowski2019 {

namespace {

constexpr std::size_t kRows = kPublished.size();

std::string css_class(std::size_t row) { return fmt::format("w{}", row); }

const Trial* best_trial(const Study& study, std::size_t layout, std::size_t row) {
  return study.main.best_trial(Study::case_of(layout, row));
}

std::string weight_key() {
  std::string items;
  for (std::size_t row = 0; row < kRows; ++row)
    items += fmt::format("<li><span class=\"swatch s-way {}\"></span>fuel {:.1f}, threat {:.1f}</li>\n", css_class(row),
                         kPublished[row].fuel, kPublished[row].threat);
  return items;
}

std::string scene_figure(const Study& study, std::size_t layout) {
  std::vector<SceneRoute> routes;
  for (std::size_t row = 0; row < kRows; ++row)
    if (const Trial* trial = best_trial(study, layout, row))
      routes.push_back({.route = &trial->best()->plan.route, .css_class = css_class(row)});
  const std::string title =
      fmt::format("Layout {}: the best route for each pair of weights, over the spheres", layouts()[layout].name);
  return fmt::format(
      "<figure>\n{}<ul class=\"key\">\n{}<li><span class=\"swatch s-threat\"></span>Threat</li>\n<li "
      "class=\"note\">Thin "
      "lines drop from each node to the floor.</li>\n</ul>\n</figure>\n",
      scene_svg(study.main.cases[Study::case_of(layout, 0)].site(), routes, title), weight_key());
}

/// "1.20, 1.05 at nodes" inside, "0.31 outside" where it is not entered.
std::string depth_text(const Intrusion& depth) {
  if (depth.along_legs <= 0) return fmt::format("{:.2f} outside", -depth.along_legs);
  return depth.at_nodes <= 0 ? fmt::format("{:.2f}, none at nodes", depth.along_legs)
                             : fmt::format("{:.2f}, {:.2f} at nodes", depth.along_legs, depth.at_nodes);
}

std::string row_head(std::size_t row) {
  return fmt::format("<th scope=\"row\">fuel&#160;{:.1f}</th>", kPublished[row].fuel);
}

std::string route_row(const Study& study, std::size_t layout, std::size_t row) {
  const Trial* trial = best_trial(study, layout, row);
  if (trial == nullptr) return fmt::format("<tr>{}<td>no route</td></tr>\n", row_head(row));
  const StudyRun& run = *trial->best();
  const double distances = (run.metrics.cost - kPublished[row].threat * run.metrics.threat) / kPublished[row].fuel;
  const std::string seed = trial->runs.size() > 1 ? fmt::format(", seed {}", run.seed) : "";
  std::string cells = fmt::format("<td>{}{}</td>", xml_escape(study.main.methods[trial->method_index].name), seed);
  for (const double value : {run.metrics.cost, layouts()[layout].best_known[row], run.plan.lower_bound, distances,
                             run.metrics.threat, run.metrics.length_m})
    cells += fmt::format("<td class=\"num\">{:.2f}</td>", value);
  return fmt::format("<tr>{}{}</tr>\n", row_head(row), cells);
}

std::string routes_table(const Study& study, std::size_t layout) {
  std::string rows;
  for (std::size_t row = 0; row < kRows; ++row) rows += route_row(study, layout, row);
  return study_table({"Weights", "Found by"},
                     {"Cost", "Best known before", "Bound", "Sum of distances", "Sum of exposures", "Length"}, rows);
}

std::string intrusion_row(const Study& study, std::size_t layout, std::size_t row) {
  const Trial* trial = best_trial(study, layout, row);
  if (trial == nullptr) return "";
  std::string cells;
  for (const Threat& threat : study.main.cases[Study::case_of(layout, row)].site().threats)
    cells += fmt::format("<td class=\"num\">{}</td>", depth_text(deepest_intrusion(threat, trial->best()->plan.route)));
  return fmt::format("<tr>{}{}</tr>\n", row_head(row), cells);
}

std::string intrusion_table(const Study& study, std::size_t layout) {
  std::vector<std::string> spheres;
  for (const Threat& threat : study.main.cases[Study::case_of(layout, 0)].site().threats)
    spheres.push_back(fmt::format("{}, radius {:g}", threat.name, threat.radius_m));
  std::string rows;
  for (std::size_t row = 0; row < kRows; ++row) rows += intrusion_row(study, layout, row);
  return study_table({"Weights"}, spheres, rows);
}

/// Lines of one method, one a pair of weights; empty for planners that keep no history.
std::vector<Convergence> lines_of(const Study& study, std::size_t layout, std::size_t method) {
  std::vector<Convergence> lines;
  for (std::size_t row = 0; row < kRows; ++row) {
    Convergence line = convergence(study.main.at(Study::case_of(layout, row), method), css_class(row));
    if (!line.points.empty()) lines.push_back(std::move(line));
  }
  return lines;
}

std::string convergence_panels(const Study& study, std::size_t layout) {
  std::vector<std::vector<Convergence>> methods;
  for (std::size_t m = 0; m < study.main.methods.size(); ++m) methods.push_back(lines_of(study, layout, m));
  const PercentRange range = percent_range(methods);
  std::string panels;
  for (std::size_t m = 0; m < methods.size(); ++m) {
    if (methods[m].empty()) continue;
    const std::string& name = study.main.methods[m].name;
    panels += fmt::format("<figure><h4>{}</h4>\n{}</figure>\n", xml_escape(name),
                          convergence_svg(methods[m], range, "Convergence of " + name));
  }
  if (panels.empty()) return "";
  return fmt::format(
      "<h3>Convergence</h3>\n<p class=\"lead\">Cost above the lower bound; both axes are logarithmic. Thick: best so "
      "far, "
      "mean over the seeds, from where every seed has a route. Band: from the best to the worst seed. Thin: mean of "
      "the "
      "ants that arrived.</p>\n<div class=\"panels\">\n{}</div>\n<ul class=\"key\">\n{}<li><span class=\"swatch "
      "s-mean\"></span>mean of the ants</li>\n<li><span class=\"swatch s-seeds\"></span>best to worst "
      "seed</li>\n</ul>\n",
      panels, weight_key());
}

}  // namespace

std::string layout_view(const Study& study, std::size_t layout) {
  return scene_figure(study, layout) + "<h3>The best routes</h3>\n" + routes_table(study, layout) +
         "<h3>How deep they enter the spheres</h3>\n" + intrusion_table(study, layout) +
         convergence_panels(study, layout);
}

}  // namespace alate::konatowski2019
