#include "data/site_navigation.hpp"

#include <fmt/core.h>

#include "data/limits.hpp"
#include "data/points_file.hpp"
#include "data/site_places.hpp"

namespace alate {

namespace {

constexpr const char* kField = "navigation.points";
constexpr double kSamePlace_m = 1;

GivenPoint given_by(const CorrectionPointSpec& spec, int index, double success) {
  GivenPoint given{.point = {.id = spec.id.value_or(index), .kind = spec.kind, .success = spec.may_fail ? success : 1},
                   .geographic = !spec.position_m,
                   .row = index};
  if (spec.position_m) given.point.position = Vec3(spec.position_m->data());
  if (given.geographic)
    given.point.position = {spec.lat_deg.value_or(0), spec.lon_deg.value_or(0), spec.amsl_m.value_or(0)};
  return given;
}

GivenPoints read_list(const NavigationSpec& spec, SiteFaults& faults) {
  GivenPoints points;
  const auto refuse = [&](const PointFault& fault, std::string field) {
    if (!fault.field.empty()) field += "." + fault.field;
    faults.add({.field = std::move(field), .value = fault.value, .limit = fault.limit, .message = fault.message});
  };
  for (std::size_t i = 0; i < spec.points.size(); ++i) {
    if (const auto fault = points.add(given_by(spec.points[i], static_cast<int>(i), spec.success)))
      refuse(*fault, fmt::format("{}.{}", kField, i));
  }
  if (const auto fault = points.missing_end()) refuse(*fault, kField);
  return points;
}

GivenPoints read_file(const NavigationSpec& spec, SiteFaults& faults) {
  try {
    std::vector<Fault> found;
    GivenPoints points = read_points_file(spec.points_file, spec.success, found);
    for (Fault& fault : found) faults.add_found(std::move(fault));
    return points;
  } catch (const InputError& error) {
    Fault fault = error.faults().front();
    fault.field = kField;
    if (fault.value.empty()) fault.value = spec.points_file;
    faults.add(std::move(fault));
    return {};
  }
}

/// Nothing, and a fault, if the frame has no place for the point.
std::optional<Vec3> place_in(const Site& site, const GivenPoint& given, SiteFaults& faults) {
  const Vec3& at = given.point.position;
  if (!given.geographic) return at;
  if (const auto xy = site.frame.from_geo({at.x(), at.y()})) return Vec3{xy->x(), xy->y(), at.z()};
  Fault fault{.field = kField,
              .value = fmt::format("lat {}, lon {}", at.x(), at.y()),
              .message = site.frame.is_local() ? "a local frame has no latitude and longitude"
                                               : "has no image in the frame " + site.frame.name()};
  const std::string& file = site.scenario.navigation->points_file;
  if (file.empty()) {
    fault.field = fmt::format("{}.{}", kField, given.row);
    faults.add(std::move(fault));
  } else {
    fault.file = file;
    fault.line = given.row;
    faults.add_found(std::move(fault));
  }
  return std::nullopt;
}

}  // namespace

GivenPoints read_points(const Scenario& scenario, SiteFaults& faults) {
  if (!scenario.navigation) return {};
  const NavigationSpec& spec = *scenario.navigation;
  return spec.points_file.empty() ? read_list(spec, faults) : read_file(spec, faults);
}

Navigation navigation_of(const Site& site, const GivenPoints& given, SiteFaults& faults) {
  const NavigationSpec& spec = *site.scenario.navigation;
  Navigation navigation{.points = {},
                        .drift_vertical = spec.drift_vertical_per_m,
                        .drift_horizontal = spec.drift_horizontal_per_m,
                        .at_vertical = {spec.alpha[0], spec.alpha[1]},
                        .at_horizontal = {spec.beta[0], spec.beta[1]},
                        .theta = spec.theta,
                        .residual = spec.residual,
                        .turn_model = spec.turn_model,
                        .turn_radius_m = spec.turn_radius_m.value_or(0),
                        .start_id = given.start() ? given.start()->point.id : Navigation::kNoId,
                        .goal_id = given.end() ? given.end()->point.id : Navigation::kNoId};
  navigation.points.reserve(given.points().size());
  std::size_t misplaced = 0;
  for (const GivenPoint& each : given.points()) {
    const auto position = place_in(site, each, faults);
    if (!position && ++misplaced == kMaxFaults) break;
    if (!position) continue;
    navigation.points.push_back(each.point);
    navigation.points.back().position = *position;
  }
  return navigation;
}

std::optional<Vec3> locate_end(const Site& site, const GivenEnd& given, SiteFaults& faults) {
  const auto& [place, point, field] = given;
  if (!point && site.scenario.navigation && !place.given()) {
    faults.add({.field = field, .message = "is missing: neither the scenario nor its points have it"});
    return std::nullopt;
  }
  if (!point) return locate(site, place, field, faults);
  auto by_points = place_in(site, *point, faults);
  if (!by_points || !place.given()) return by_points;
  const auto by_scenario = locate(site, place, field, faults);
  if (!by_scenario) return std::nullopt;
  const double apart = (*by_scenario - *by_points).norm();
  if (apart <= kSamePlace_m) return by_points;
  faults.add(
      {.field = field,
       .value = fmt::format("{:.2f}", apart),
       .limit = fmt::format("<= {}", kSamePlace_m),
       .unit = "m",
       .message = fmt::format("does not lie at point {}, which is the same end of the flight", point->point.id)});
  return std::nullopt;
}

}  // namespace alate
