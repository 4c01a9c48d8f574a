#include "data/site_places.hpp"

#include <fmt/core.h>

#include <cmath>

#include "data/raster_extent.hpp"
#include "data/site_grid.hpp"

namespace alate {

namespace {

/// Rounding between a height above ground and the ground itself must not make a fault.
constexpr double kRoundingMetres = 1e-6;

std::string number(double value) { return fmt::format("{:.2f}", value); }

/// The ground's limits in the user's own coordinates where it has them.
std::string extent_of(const Site& site) {
  if (std::holds_alternative<HeightRaster>(site.ground)) {
    const Scenario& scenario = site.scenario;
    if (const auto box = raster_extent(scenario.grid ? scenario.grid->dem : scenario.terrain->dem)) return box->text();
    const Box2& area = std::get<HeightRaster>(site.ground).area;
    return fmt::format("x {:.1f} to {:.1f}, y {:.1f} to {:.1f}", area.min.x(), area.max.x(), area.min.y(),
                       area.max.y());
  }
  const Box2& area = std::get<PeakGround>(site.ground).area;
  return fmt::format("x {:.1f} to {:.1f}, y {:.1f} to {:.1f}", area.min.x(), area.max.x(), area.min.y(), area.max.y());
}

std::string text_of(const Site& site, const Vec3& position) {
  if (const auto geo = site.frame.to_geo(position.head<2>()))
    return fmt::format("lat {:.6f}, lon {:.6f}", geo->lat_deg, geo->lon_deg);
  return fmt::format("x {:.1f}, y {:.1f}", position.x(), position.y());
}

/// Ground height for a place; a fault if there is none.
std::optional<double> ground_under(const Site& site, const Vec2& xy, const std::string& field, SiteFaults& faults) {
  if (!site.has_ground()) return std::nullopt;
  const auto ground = site.ground_height(xy);
  const Vec3 at{xy.x(), xy.y(), 0};
  if (!ground) {
    faults.add(
        {.field = field, .value = text_of(site, at), .limit = extent_of(site), .message = "lies outside the terrain"});
    return std::nullopt;
  }
  if (std::isnan(*ground)) {
    faults.add(
        {.field = field, .value = text_of(site, at), .message = "lies on unknown ground (a void of the terrain)"});
    return std::nullopt;
  }
  return ground;
}

std::optional<Vec2> locate_plane(const Site& site, const PlaceSpec& place, const std::string& field,
                                 SiteFaults& faults) {
  if (place.position_m) return Vec2{(*place.position_m)[0], (*place.position_m)[1]};
  if (!place.lat_deg || !place.lon_deg) {
    faults.add({.field = field, .message = "has no place: give lat and lon, or metres of the frame"});
    return std::nullopt;
  }
  if (const auto xy = site.frame.from_geo({*place.lat_deg, *place.lon_deg})) return xy;
  faults.add({.field = field,
              .value = fmt::format("lat {}, lon {}", *place.lat_deg, *place.lon_deg),
              .message = site.frame.is_local() ? "a local frame has no latitude and longitude"
                                               : "has no image in the frame " + site.frame.name()});
  return std::nullopt;
}

/// The cell around a place that is given without a height.
std::optional<Vec3> locate_around(const Site& site, const Vec2& xy, const std::string& field, SiteFaults& faults) {
  if (const auto cell = site.grid->cell_at(xy)) return locate_cell(site, *cell, field, faults);
  faults.add({.field = field,
              .value = text_of(site, {xy.x(), xy.y(), 0}),
              .limit = extent_of(site),
              .message = "lies outside the grid"});
  return std::nullopt;
}

PlaceSpec place_of(const ThreatSpec& threat) {
  PlaceSpec place{.lat_deg = threat.lat_deg, .lon_deg = threat.lon_deg, .amsl_m = threat.amsl_m, .agl_m = threat.agl_m};
  if (threat.center_m) place.position_m = threat.center_m;
  return place;
}

std::optional<Vec3> locate_cylinder(const Site& site, const CylinderSpec& cylinder, const std::string& field,
                                    SiteFaults& faults) {
  PlaceSpec place{.lat_deg = cylinder.lat_deg, .lon_deg = cylinder.lon_deg, .amsl_m = cylinder.floor_m};
  if (cylinder.center_m) place.position_m = {{(*cylinder.center_m)[0], (*cylinder.center_m)[1], cylinder.floor_m}};
  return locate(site, place, field, faults);
}

bool in_core(const Threat& threat, const Vec3& position) {
  if (threat.core_m <= 0) return false;
  if (threat.shape == Threat::Shape::sphere) return (position - threat.center).norm() < threat.core_m;
  return position.z() >= threat.floor_m && position.z() <= threat.top_m &&
         (position - threat.center).head<2>().norm() < threat.core_m;
}

void judge_height(const Site& site, const Vec3& position, const std::string& field, SiteFaults& faults) {
  const auto found = ground_under(site, position.head<2>(), field, faults);
  if (!found) return;
  const double ground = *found;
  const double above = position.z() - ground;
  const Band& band = site.band;
  if (above < -kRoundingMetres) {
    faults.add({.field = field,
                .value = number(position.z()),
                .limit = ">= " + number(ground),
                .unit = "m above sea level",
                .message = "lies under the ground"});
  } else if (above < band.clearance_m - kRoundingMetres) {
    faults.add({.field = field,
                .value = number(above),
                .limit = ">= " + number(band.clearance_m),
                .unit = "m above ground",
                .message = "is lower than the clearance"});
  }
  if (band.ceiling_agl_m && above > *band.ceiling_agl_m + kRoundingMetres) {
    faults.add({.field = field,
                .value = number(above),
                .limit = "<= " + number(*band.ceiling_agl_m),
                .unit = "m above ground",
                .message = "is above the ceiling"});
  }
}

}  // namespace

std::optional<Vec3> locate(const Site& site, const PlaceSpec& place, const std::string& field, SiteFaults& faults) {
  if (place.cell && (site.grid || site.voxels)) return locate_cell(site, place, field + ".cell", faults);
  const auto xy = locate_plane(site, place, field, faults);
  if (!xy) return std::nullopt;
  if (place.position_m) return Vec3{xy->x(), xy->y(), (*place.position_m)[2]};
  if (place.amsl_m) return Vec3{xy->x(), xy->y(), *place.amsl_m};
  if (!place.agl_m && site.grid && site.has_ground()) return locate_around(site, *xy, field, faults);
  if (!place.agl_m || !site.has_ground()) {
    faults.add({.field = field, .message = place.agl_m ? "a height above ground needs a terrain" : "has no height"});
    return std::nullopt;
  }
  const auto ground = ground_under(site, *xy, field, faults);
  if (!ground) return std::nullopt;
  return Vec3{xy->x(), xy->y(), *ground + *place.agl_m};
}

std::vector<Threat> locate_threats(const Site& site, SiteFaults& faults) {
  std::vector<Threat> threats;
  for (std::size_t i = 0; i < site.scenario.threats.size(); ++i) {
    const ThreatSpec& spec = site.scenario.threats[i];
    const std::string field = fmt::format("threats.{}", i);
    const auto center = spec.cylinder ? locate_cylinder(site, *spec.cylinder, field + ".cylinder", faults)
                                      : locate(site, place_of(spec), field, faults);
    if (!center) continue;
    threats.push_back({.name = spec.name,
                       .shape = spec.cylinder ? Threat::Shape::cylinder : Threat::Shape::sphere,
                       .center = *center,
                       .radius_m = spec.radius_m,
                       .level = spec.level,
                       .core_m = spec.core_m,
                       .floor_m = spec.cylinder ? spec.cylinder->floor_m : 0,
                       .top_m = spec.cylinder ? spec.cylinder->top_m : 0});
  }
  return threats;
}

void judge_place(const Site& site, const Vec3& position, const std::string& field, SiteFaults& faults) {
  judge_height(site, position, field, faults);
  const auto& ceiling = site.band.ceiling_amsl_m;
  if (ceiling && position.z() > *ceiling + kRoundingMetres) {
    faults.add({.field = field,
                .value = number(position.z()),
                .limit = "<= " + number(*ceiling),
                .unit = "m above sea level",
                .message = "is above the ceiling"});
  }
  for (const Threat& threat : site.threats) {
    if (!in_core(threat, position)) continue;
    faults.add({.field = field,
                .value = text_of(site, position),
                .limit = fmt::format(">= {} m from it", threat.core_m),
                .message = fmt::format("lies in the core of threat '{}'", threat.name)});
  }
}

}  // namespace alate
