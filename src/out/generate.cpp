#include "alate/out/generate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>

#include "alate/core/param_table.hpp"
#include "alate/data/scenario_file.hpp"
#include "data/correction_law.hpp"
#include "data/raster_writer.hpp"
#include "out/output_folder.hpp"

namespace alate {

namespace {

using LawNames = std::array<const char*, 2>;
constexpr LawNames kCorrectionLaws{"set1", "set2"};
constexpr LawNames kTerrainLaws{"canyon", "hills"};
constexpr const char* kPointsFile = "points.csv";
constexpr const char* kTerrainFile = "terrain.tif";
constexpr const char* kScenarioFile = "scenario.yaml";

/// Laws are named in the order of their enumerators.
template <class Law>
Law law_named(const LawNames& laws, const std::string& name) {
  const auto* const found = std::ranges::find(laws, name);
  if (found == laws.end()) throw InputError(unknown_name({.file = "--law"}, "law", name, {laws.begin(), laws.end()}));
  return static_cast<Law>(found - laws.begin());
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

/// A small fixed wing from end to end, 60 to 400 m above the ground; above a canyon's walls no one may fly.
std::string scenario_yaml(const DrawnTerrain& terrain, TerrainLaw law) {
  constexpr double kAboveGround_m = 85;
  constexpr double kBelowPlain_m = 760;
  const auto above = [&](const Vec2& place) {
    return std::array<double, 3>{place.x(), place.y(), terrain.height(place) + kAboveGround_m};
  };
  Scenario scenario;
  scenario.frame.local = true;
  scenario.terrain = TerrainSpec{.dem = kTerrainFile, .clearance_m = 60, .ceiling_agl_m = 400};
  if (law == TerrainLaw::canyon) scenario.terrain->ceiling_amsl_m = kBelowPlain_m;
  scenario.start.place.position_m = above(terrain.start);
  scenario.goal.place.position_m = above(terrain.goal);
  scenario.goal.tolerance_m = 20;
  scenario.vehicle = {.turn_radius_m = 66.67, .climb_deg = 8.53, .descent_deg = 8.53};
  scenario.objective.climb = 0.5;
  return to_yaml(scenario);
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

std::vector<std::string> correction_laws() { return {kCorrectionLaws.begin(), kCorrectionLaws.end()}; }
std::vector<std::string> terrain_laws() { return {kTerrainLaws.begin(), kTerrainLaws.end()}; }

std::vector<std::string> write_corrections(const CorrectionRequest& request, const std::string& folder) {
  const CorrectionField field =
      draw_corrections(law_named<CorrectionLaw>(kCorrectionLaws, request.law), request.points, request.seed);
  OutputFolder output(folder);
  output.write(kPointsFile, points_csv(field));
  output.write(kScenarioFile, fmt::format("# Made by: alate generate corrections --points {} --law {} --seed {}\n",
                                          request.points, request.law, request.seed) +
                                  scenario_yaml(field.navigation));
  output.publish();
  return {kScenarioFile, kPointsFile};
}

std::vector<std::string> write_terrain(const TerrainRequest& request, const std::string& folder) {
  const auto law = law_named<TerrainLaw>(kTerrainLaws, request.law);
  const DrawnTerrain terrain = draw_terrain(law, request.side, request.seed);
  OutputFolder output(folder);
  output.write(kTerrainFile, geotiff(terrain));
  output.write(kScenarioFile, fmt::format("# Made by: alate generate terrain --law {} --side {} --seed {}\n",
                                          request.law, request.side, request.seed) +
                                  scenario_yaml(terrain, law));
  output.publish();
  return {kScenarioFile, kTerrainFile};
}

}  // namespace alate
