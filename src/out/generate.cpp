#include "alate/out/generate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>

#include "alate/core/param_table.hpp"
#include "alate/data/scenario_file.hpp"
#include "data/correction_law.hpp"
#include "out/output_folder.hpp"

namespace alate {

namespace {

constexpr std::array<const char*, 2> kLaws{"set1", "set2"};
constexpr const char* kPointsFile = "points.csv";
constexpr const char* kScenarioFile = "scenario.yaml";

CorrectionLaw law_named(const std::string& name) {
  const auto* const found = std::ranges::find(kLaws, name);
  if (found == kLaws.end()) throw InputError(unknown_name({.file = "--law"}, "law", name, correction_laws()));
  return static_cast<CorrectionLaw>(found - kLaws.begin());
}

/// Two decimals hold every coordinate of the law.
std::string points_csv(const CorrectionField& field) {
  std::string text = "id,x_m,y_m,z_m,kind,may_fail\n";
  const auto add = [&](int id, const Vec3& p, const char* kind, bool may_fail) {
    fmt::format_to(std::back_inserter(text), "{},{:.2f},{:.2f},{:.2f},{},{:d}\n", id, p.x(), p.y(), p.z(), kind,
                   may_fail);
  };
  const Navigation& navigation = field.navigation;
  add(navigation.start_id, field.start, "start", false);
  for (const CorrectionPoint& point : navigation.points)
    add(point.id, point.position, point.kind == PointKind::vertical ? "vertical" : "horizontal", point.success < 1);
  add(navigation.goal_id, field.goal, "end", false);
  return text;
}

std::string scenario_yaml(const Navigation& navigation) {
  Scenario scenario;
  scenario.objective.climb = 0;
  scenario.navigation = NavigationSpec{.points_file = kPointsFile,
                                       .drift_vertical_per_m = navigation.drift_vertical,
                                       .drift_horizontal_per_m = navigation.drift_horizontal,
                                       .alpha = {navigation.at_vertical.vertical, navigation.at_vertical.horizontal},
                                       .beta = {navigation.at_horizontal.vertical, navigation.at_horizontal.horizontal},
                                       .theta = navigation.theta,
                                       .residual = navigation.residual};
  return to_yaml(scenario);
}

}  // namespace

std::vector<std::string> correction_laws() { return {kLaws.begin(), kLaws.end()}; }

std::vector<std::string> write_corrections(const CorrectionRequest& request, const std::string& folder) {
  const CorrectionField field = draw_corrections(law_named(request.law), request.points, request.seed);
  OutputFolder output(folder);
  output.write(kPointsFile, points_csv(field));
  output.write(kScenarioFile, fmt::format("# Made by: alate generate corrections --points {} --law {} --seed {}\n",
                                          request.points, request.law, request.seed) +
                                  scenario_yaml(field.navigation));
  output.publish();
  return {kScenarioFile, kPointsFile};
}

}  // namespace alate
