#include "alate/data/site.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "data/grid_dem.hpp"
#include "data/raster_extent.hpp"
#include "data/site_faults.hpp"
#include "data/site_frame.hpp"
#include "data/site_grid.hpp"
#include "data/site_navigation.hpp"
#include "data/site_places.hpp"
#include "data/voxel_map.hpp"

namespace alate {

namespace {

std::optional<double> in_radians(const std::optional<double>& angle_deg) {
  if (!angle_deg) return std::nullopt;
  return radians(*angle_deg);
}

std::vector<double> in_radians(const std::vector<double>& angles_deg) {
  std::vector<double> angles;
  for (const double angle : angles_deg) angles.push_back(radians(angle));
  return angles;
}

Vehicle vehicle_of(const VehicleSpec& spec) {
  return {.speed_mps = spec.speed_mps,
          .turn_radius_m = spec.turn_radius_m,
          .climb_rad = in_radians(spec.climb_deg),
          .descent_rad = in_radians(spec.descent_deg),
          .range_m = spec.range_m,
          .step_m = spec.step_m,
          .roll_rad = in_radians(spec.roll_deg),
          .pitch_rad = in_radians(spec.pitch_deg),
          .yaw_rad = in_radians(spec.yaw_deg)};
}

PeakGround peaks_of(const TerrainSpec& spec) {
  PeakGround ground{.maximum = spec.combine == PeakCombination::max};
  for (const PeakSpec& peak : spec.peaks) {
    ground.peaks.push_back({.center = {peak.center_m[0], peak.center_m[1]},
                            .height_m = peak.height_m,
                            .slope_m = {peak.slope_m[0], peak.slope_m[1]}});
  }
  const auto extent = spec.extent_m.value_or(std::array<double, 2>{});
  ground.area = {Vec2::Zero(), Vec2{extent[0], extent[1]}};
  return ground;
}

/// A place that misses the raster altogether is often why the raster cannot be brought into the frame.
void judge_against_extent(const Scenario& scenario, const std::string& dem, SiteFaults& faults) {
  const auto extent = raster_extent(dem);
  if (!extent) return;
  const auto judge = [&](const PlaceSpec& place, const char* field) {
    if (!place.lat_deg || !place.lon_deg || extent->contains({*place.lat_deg, *place.lon_deg})) return;
    faults.add({.field = field,
                .value = fmt::format("lat {}, lon {}", *place.lat_deg, *place.lon_deg),
                .limit = extent->text(),
                .message = "lies outside the terrain"});
  };
  judge(scenario.start.place, "start");
  judge(scenario.goal.place, "goal");
}

/// False, and faults at `field`, if the raster cannot be read.
bool read_raster(Site& site, const std::string& dem, const std::string& field, SiteFaults& faults) {
  std::vector<Fault> found;
  auto raster = read_height_raster(dem, site.frame, found);
  for (Fault& fault : found) {
    fault.field = field;
    faults.add(std::move(fault));
  }
  if (!raster) {
    judge_against_extent(site.scenario, dem, faults);
    return false;
  }
  if (raster->voids > 0)
    site.warnings.push_back(
        fmt::format("{}: {} of {} posts are unknown ground", raster->name, raster->voids, raster->posts.size()));
  site.ground = std::move(*raster);
  return true;
}

bool read_cells(Site& site, SiteFaults& faults) {
  const GridSpec& spec = *site.scenario.grid;
  if (spec.dem.empty() && is_voxel_map(spec.map)) {
    site.voxels = read_voxels(site.scenario, faults);
  } else if (spec.dem.empty()) {
    site.grid = read_grid(site.scenario, faults);
  } else if (read_raster(site, spec.dem, "grid.dem", faults)) {
    site.band.clearance_m = spec.clearance_m;
    site.grid = cut_grid(std::get<HeightRaster>(site.ground), spec, faults);
  }
  return site.grid || site.voxels;
}

/// False if the ground cannot be read.
bool read_ground(Site& site, SiteFaults& faults) {
  if (site.scenario.grid) return read_cells(site, faults);
  if (!site.scenario.terrain) return true;
  const TerrainSpec& spec = *site.scenario.terrain;
  site.band = {
      .clearance_m = spec.clearance_m, .ceiling_agl_m = spec.ceiling_agl_m, .ceiling_amsl_m = spec.ceiling_amsl_m};
  if (spec.dem.empty()) {
    if (!spec.peaks.empty()) site.ground = peaks_of(spec);
    return true;
  }
  return read_raster(site, spec.dem, "terrain.dem", faults);
}

void place_mission(Site& site, const GivenPoints& points, SiteFaults& faults) {
  const Scenario& scenario = site.scenario;
  const auto start = locate_end(site, {scenario.start.place, points.start(), "start"}, faults);
  const auto goal = locate_end(site, {scenario.goal.place, points.end(), "goal"}, faults);
  if (start) {
    judge_scale(site.frame, start->head<2>(), faults);
    judge_place(site, *start, "start", faults);
  }
  if (goal) judge_place(site, *goal, "goal", faults);
  if (!start || !goal) return;
  const auto& heading_deg = scenario.start.heading_deg;
  site.mission = {.start = *start,
                  .heading_rad = heading_deg ? radians(*heading_deg) : heading_of(*goal - *start),
                  .heading_given = heading_deg.has_value(),
                  .goal = *goal,
                  .tolerance_m = scenario.goal.tolerance_m};
}

}  // namespace

bool Vehicle::has_attitude_steps() const {
  return step_m && !roll_rad.empty() && !pitch_rad.empty() && !yaw_rad.empty();
}

std::optional<double> Site::ground_height(const Vec2& xy) const {
  if (const auto* raster = std::get_if<HeightRaster>(&ground)) return raster->height(xy);
  if (const auto* peaks = std::get_if<PeakGround>(&ground)) {
    if (peaks->area.contains(xy)) return peaks->height(xy);
  }
  return std::nullopt;
}

Site load_site(const Scenario& scenario) {
  Site site;
  site.scenario = scenario;
  site.vehicle = vehicle_of(scenario.vehicle);
  SiteFaults faults(scenario);
  const GivenPoints points = read_points(scenario, faults);
  throw_if_any(faults.take());
  const auto frame = choose_frame(scenario, points, faults);
  if (frame) {
    site.frame = *frame;
    if (read_ground(site, faults)) {
      site.threats = locate_threats(site, faults);
      if (scenario.navigation) site.navigation = navigation_of(site, points, faults);
      place_mission(site, points, faults);
    }
  }
  throw_if_any(faults.take());
  return site;
}

}  // namespace alate
