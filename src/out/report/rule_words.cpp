#include "out/report/rule_words.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <utility>

#include "out/report/number_words.hpp"

namespace alate {

namespace {

using Words = std::pair<std::string_view, std::string_view>;
constexpr std::array<Words, 17> kTitles{{{"terrain_clearance", "Height above ground"},
                                         {"ceiling", "Ceiling"},
                                         {"threat_core", "Distance to threat cores"},
                                         {"turn", "Turns"},
                                         {"climb", "Climb"},
                                         {"descent", "Descent"},
                                         {"step", "Moves the aircraft can make"},
                                         {"bounds", "Inside the known ground"},
                                         {"arrival", "Arrival at the goal"},
                                         {"vertical_error", "Vertical error"},
                                         {"horizontal_error", "Horizontal error"},
                                         {"final_error", "Error at the goal"},
                                         {"zone", "Airspace zones"},
                                         {"fence", "Fence"},
                                         {"endurance", "Range"},
                                         {"return_home", "Way home"},
                                         {"autopilot", "Autopilot"}}};

std::string limit(const char* word, const std::optional<double>& value, const char* unit) {
  return value ? fmt::format("{} {}", word, quantity(*value, unit)) : "";
}

std::string in_degrees(const char* word, const std::optional<double>& angle_rad) {
  return angle_rad ? limit(word, degrees(*angle_rad), "°") : "";
}

std::string ceilings(const Band& band) {
  const std::string above_ground = limit("at most", band.ceiling_agl_m, "m above ground");
  const std::string above_sea = limit("at most", band.ceiling_amsl_m, "m above sea level");
  return above_ground + (above_ground.empty() || above_sea.empty() ? "" : ", ") + above_sea;
}

/// The larger radius where both the vehicle and its navigation have one.
std::optional<double> least_radius(const Site& site) {
  const auto& own = site.vehicle.turn_radius_m;
  if (!site.navigation || site.navigation->turn_model == TurnModel::none) return own;
  return std::max(own.value_or(0), site.navigation->turn_radius_m);
}

std::string error_limit(std::string_view rule, const Navigation& navigation) {
  if (rule == "final_error") return fmt::format("below {} units", navigation.theta);
  const auto error = rule == "vertical_error" ? &Navigation::Limits::vertical : &Navigation::Limits::horizontal;
  return fmt::format("at most {} units at vertical, {} at horizontal points", navigation.at_vertical.*error,
                     navigation.at_horizontal.*error);
}

}  // namespace

std::string rule_title(std::string_view rule) {
  for (const auto& [name, title] : kTitles) {
    if (name == rule) return std::string(title);
  }
  return std::string(rule);
}

std::string rule_limit(std::string_view rule, const Site& site) {
  const Vehicle& vehicle = site.vehicle;
  if (rule == "terrain_clearance" && site.grid) {
    if (!site.has_ground()) return "no blocked cell, no corner of one cut";
    return limit("no blocked cell, no corner of one cut; at least", site.band.clearance_m, "m");
  }
  if (rule == "terrain_clearance" && site.voxels) return "no blocked cell, no edge or corner of one cut";
  if (rule == "terrain_clearance") return limit("at least", site.band.clearance_m, "m");
  if (rule == "ceiling") return ceilings(site.band);
  if (rule == "threat_core") return "outside every core";
  if (rule == "turn") return limit("radius at least", least_radius(site), "m");
  if (rule == "climb") return in_degrees("at most", vehicle.climb_rad);
  if (rule == "descent") return in_degrees("at most", vehicle.descent_rad);
  if (rule == "step") return limit("steps of", vehicle.step_m, "m, rotations from the lists");
  if (rule == "arrival") return limit("within", site.mission.tolerance_m, "m");
  if (rule.ends_with("_error") && site.navigation) return error_limit(rule, *site.navigation);
  if (rule == "endurance") return limit("at most", vehicle.range_m, "m");
  return {};
}

}  // namespace alate
