#include "data/scenario_fields.hpp"

#include <fmt/ranges.h>

#include "data/scenario_slots.hpp"

namespace alate {

namespace {

const Range kLatitude = from_to(-90, 90);
const Range kLongitude = from_to(-180, 180);
const Range kPointId = from_to(0, kMaxPointId);
const Range kSide = from_to(1, kMaxGridSide);
const Range kCell = from_to(0, kMaxGridSide - 1);

// Declared first: the groups below name each other.
Description describe(GeoPoint& point);
Description describe(PeakSpec& peak);
Description describe(CylinderSpec& cylinder);
Description describe(ThreatSpec& threat);
Description describe(FrameSpec& frame);
Description describe(TerrainSpec& terrain);
Description describe(RandomGridSpec& random);
Description describe(GridSpec& grid);
Description describe(StartSpec& start);
Description describe(GoalSpec& goal);
Description describe(VehicleSpec& vehicle);
Description describe(ObjectiveSpec& objective);
Description describe(CorrectionPointSpec& point);
Description describe(NavigationSpec& navigation);
Description describe(PlannerSpec& planner);

template <class Struct>
Group group(Struct& value) {
  return {.open = [&value] { return describe(value); }};
}

template <class Struct>
Group group(std::optional<Struct>& value) {
  return {.present = value.has_value(), .open = [&value] { return describe(value ? *value : value.emplace()); }};
}

template <class Struct>
Groups groups(std::vector<Struct>& values, std::size_t least = 0) {
  return {.count = values.size(), .least = least, .at = [&values](std::size_t index) {
            if (values.size() <= index) values.resize(index + 1);
            return describe(values[index]);
          }};
}

Description describe(FrameSpec& frame) {
  return {.fields = {written_if(
                         !frame.origin && !frame.local,
                         field("crs", "",
                               "\"auto\" takes the UTM zone of the midpoint of start and goal, which must have lat and "
                               "lon, or of the middle of `grid.dem`, or a local frame beside any other `grid`, or "
                               "`navigation` where all is in metres; else any projected CRS in metres, such as "
                               "\"EPSG:21781\".",
                               text(frame.crs))),
                     field("origin", "", "A transverse Mercator of scale 1 around this point, which becomes (0, 0).",
                           group(frame.origin)),
                     written_if(frame.local,
                                field("local", "", "true: plain metres with no place on Earth.", flag(frame.local)))},
          .one_of = {{"crs"}, {"origin"}, {"local"}}};
}

Description describe(GeoPoint& point) {
  return {.fields = {required(field("lat", "deg", "Latitude, WGS 84.", number(point.lat_deg, kLatitude))),
                     required(field("lon", "deg", "Longitude, WGS 84.", number(point.lon_deg, kLongitude)))}};
}

Description describe(TerrainSpec& terrain) {
  return {
      .fields = {field("dem", "", "Raster of ground heights above mean sea level, in any CRS; relative to this file.",
                       text(terrain.dem, Text::Use::path)),
                 field("peaks", "", "Ground made of Gaussian hills, in a frame with an origin or a local one.",
                       groups(terrain.peaks, 1)),
                 written_if(!terrain.peaks.empty(), field("combine", "", "How peaks are laid over each other.",
                                                          choice(terrain.combine, {"sum", "max"}))),
                 field("extent_m", "m", "Width and height of the ground made of peaks, from (0, 0).",
                       numbers(terrain.extent_m, above(0))),
                 field("clearance_m", "m", "Least height of every leg above ground.",
                       number(terrain.clearance_m, at_least(0))),
                 field("ceiling_agl_m", "m", "Greatest height above ground; above clearance_m.",
                       number(terrain.ceiling_agl_m, above(0))),
                 field("ceiling_amsl_m", "m", "Greatest height above mean sea level.", number(terrain.ceiling_amsl_m))},
      .one_of = {{"dem"}, {"peaks", "extent_m"}}};
}

Description describe(PeakSpec& peak) {
  return {.fields = {required(field("center_m", "m", "Top of the hill, x and y.", numbers(peak.center_m))),
                     required(field("height_m", "m", "Height h of the hill.", number(peak.height_m, at_least(0)))),
                     required(field("slope_m", "m", "Widths sx and sy of h exp(-((x-cx)/sx)^2 - ((y-cy)/sy)^2).",
                                    numbers(peak.slope_m, above(0))))}};
}

Description describe(RandomGridSpec& random) {
  return {.fields = {
              required(field("size", "cells", "Columns and rows.", whole_numbers(random.size, kSide))),
              field("obstacles", "", "Chance of each cell to be blocked; start and goal are kept free.",
                    number(random.obstacles, from_to(0, 1))),
              field("seed", "", "The same seed draws the same cells.", whole(random.seed, from_to(0, kMaxGridSeed)))}};
}

Description describe(GridSpec& grid) {
  const bool cut = !grid.dem.empty();
  return {
      .fields =
          {field(
               "map", "",
               "Map in a format of the Moving AI benchmarks, in the plane (.map) or of voxels (.3dmap, or a file that "
               "begins with `voxel`); relative to this file.",
               text(grid.map, Text::Use::path)),
           field("random", "", "Cells drawn at random.", group(grid.random)),
           field("dem", "",
                 "Raster of ground heights above mean sea level, in any CRS, cut as a whole into cells of "
                 "cell_m; relative to this file. A cell is as high as the highest post under or beside it.",
                 text(grid.dem, Text::Use::path)),
           field("level_amsl_m", "m",
                 "Flight level of the whole route, beside dem. A cell is blocked where its height and "
                 "clearance_m reach it, and where ground is unknown.",
                 number(grid.level_amsl_m)),
           written_if(cut, field("clearance_m", "m", "Least height above ground; dem only.",
                                 number(grid.clearance_m, at_least(0)))),
           written_if(!cut, field("heights", "",
                                  "Height of each cell of a map or of random cells. peaks: the absolute "
                                  "value of MATLAB's peaks over the whole grid, rotated by 90 degrees (Yin "
                                  "et al. 2021).",
                                  choice(grid.heights, {"flat", "peaks"}))),
           field("cell_m", "m", "Side of a cell; required beside dem.",
                 number(grid.cell_m, from_to(kLeastCell, kMostCell)))},
      .one_of = {{"map"}, {"random"}, {"dem", "level_amsl_m"}}};
}

Description describe_place(PlaceSpec& place) {
  return {
      .fields =
          {field("position_m", "m", "x east, y north in the frame, z above mean sea level.", numbers(place.position_m)),
           field("cell", "",
                 "Column and row of a cell of `grid`, [0, 0] is the upper left; or x, y and z of a voxel: [x, y, z] "
                 "has its "
                 "middle at ((x + 0.5), (y + 0.5), (z + 0.5)) times cell_m.",
                 whole_numbers(place.cell, place.layer, kCell)),
           field("lat", "deg",
                 "Latitude, WGS 84. Beside `grid.dem` lat and lon alone stand for the middle of the cell around them.",
                 number(place.lat_deg, kLatitude)),
           field("lon", "deg", "Longitude, WGS 84.", number(place.lon_deg, kLongitude)),
           field("amsl_m", "m", "Height above mean sea level.", number(place.amsl_m)),
           field("agl_m", "m", "Height above ground; needs terrain.", number(place.agl_m))},
      .one_of = {{"position_m"}, {"cell"}, {"lat", "lon"}, {"lat", "lon", "amsl_m"}, {"lat", "lon", "agl_m"}}};
}

Description describe(StartSpec& start) {
  Description description = describe_place(start.place);
  description.fields.push_back(
      field("heading_deg", "deg", "Heading at the start, clockwise from grid north (+y). Not given: towards the goal.",
            number(start.heading_deg, from_to(-360, 360))));
  return description;
}

Description describe(GoalSpec& goal) {
  Description description = describe_place(goal.place);
  description.fields.push_back(
      field("tolerance_m", "m", "A route that ends this near has arrived.", number(goal.tolerance_m, at_least(0))));
  return description;
}

Description describe(VehicleSpec& vehicle) {
  const Range positive = above(0);
  const Range steepness = between(0, 90);
  const Range rotation = from_to(-90, 90);
  return {
      .fields = {field("speed_mps", "m/s", "Speed over ground.", number(vehicle.speed_mps, positive)),
                 field("turn_radius_m", "m", "Least radius of a turn.", number(vehicle.turn_radius_m, positive)),
                 field("climb_deg", "deg", "Steepest climb.", number(vehicle.climb_deg, steepness)),
                 field("descent_deg", "deg", "Steepest descent.", number(vehicle.descent_deg, steepness)),
                 field("range_m", "m", "Greatest length of the route.", number(vehicle.range_m, positive)),
                 field("step_m", "m", "Length of one move on the attitude lattice.", number(vehicle.step_m, positive)),
                 field("roll_deg", "deg", "Rolls of one move; right wing down is positive.",
                       numbers(vehicle.roll_deg, rotation)),
                 field("pitch_deg", "deg", "Pitches of one move; nose up is positive.",
                       numbers(vehicle.pitch_deg, rotation)),
                 field("yaw_deg", "deg", "Yaws of one move; to the right is positive.",
                       numbers(vehicle.yaw_deg, rotation))},
      .one_of = {{}, {"step_m", "roll_deg", "pitch_deg", "yaw_deg"}}};
}

Description describe(ThreatSpec& threat) {
  return {
      .fields = {field("name", "", "Must be unique. Not given: \"threat 1\" for the first, and so on.",
                       text(threat.name, Text::Use::label)),
                 field("center_m", "m", "Centre of a sphere: x, y, z in the frame.", numbers(threat.center_m)),
                 field("lat", "deg", "Latitude of a sphere's centre, WGS 84.", number(threat.lat_deg, kLatitude)),
                 field("lon", "deg", "Longitude of a sphere's centre, WGS 84.", number(threat.lon_deg, kLongitude)),
                 field("amsl_m", "m", "Height of a sphere's centre above mean sea level.", number(threat.amsl_m)),
                 field("agl_m", "m", "Height of a sphere's centre above ground; needs terrain.", number(threat.agl_m)),
                 field("cylinder", "", "An upright cylinder in place of a sphere.", group(threat.cylinder)),
                 required(field("radius_m", "m", "The threat is felt within this distance.",
                                number(threat.radius_m, above(0)))),
                 field("level", "", "How bad the threat is.", number(threat.level, at_least(0))),
                 field("core_m", "m", "No leg may come this near; at most radius_m. 0: no core.",
                       number(threat.core_m, at_least(0)))},
      .one_of = {{"center_m"}, {"lat", "lon", "amsl_m"}, {"lat", "lon", "agl_m"}, {"cylinder"}}};
}

Description describe(CylinderSpec& cylinder) {
  return {.fields = {field("center_m", "m", "Axis, x and y in the frame.", numbers(cylinder.center_m)),
                     field("lat", "deg", "Latitude of the axis, WGS 84.", number(cylinder.lat_deg, kLatitude)),
                     field("lon", "deg", "Longitude of the axis, WGS 84.", number(cylinder.lon_deg, kLongitude)),
                     required(field("floor_m", "m", "Lower end above mean sea level.", number(cylinder.floor_m))),
                     required(field("top_m", "m", "Upper end above mean sea level; above floor_m.",
                                    number(cylinder.top_m)))},
          .one_of = {{"center_m"}, {"lat", "lon"}}};
}

Description describe(ObjectiveSpec& objective) {
  const bool physical = objective.model == CostModel::physical;
  Choice model = choice(objective.model, {"physical", "konatowski2019"});
  model.set = [&objective](std::size_t given) {
    objective.model = static_cast<CostModel>(given);
    objective.threat = objective.model == CostModel::physical ? 20 : 0.5;
  };
  return {.fields = {field("model", "",
                           "physical: metres, length * L + threat * exposure + climb * ascent. konatowski2019: "
                           "fuel * distance to the goal + threat * depth in threats, summed over nodes.",
                           model),
                     written_if(physical, field("length", "", "Weight of the route's length; physical only.",
                                                number(objective.length, at_least(0)))),
                     field("threat", "", "Weight of the exposure to threats; 0.5 if not given under konatowski2019.",
                           number(objective.threat, at_least(0))),
                     written_if(physical, field("climb", "",
                                                "Weight of the metres climbed; physical only. Not given beside "
                                                "`navigation` or `grid`: 0, so that the cost is the length.",
                                                number(objective.climb, at_least(0)))),
                     written_if(!physical,
                                field("fuel", "",
                                      "Weight of the distance to the goal; konatowski2019 only. fuel + threat is 1.",
                                      number(objective.fuel, from_to(0, 1))))}};
}

Description describe(CorrectionPointSpec& point) {
  return {.fields = {field("id", "", "Not given: its place in the list, from 0. Must be unique.",
                           whole(point.id, kPointId)),
                     field("position_m", "m", "x, y in the frame, z above mean sea level.", numbers(point.position_m)),
                     field("lat", "deg", "Latitude, WGS 84.", number(point.lat_deg, kLatitude)),
                     field("lon", "deg", "Longitude, WGS 84.", number(point.lon_deg, kLongitude)),
                     field("amsl_m", "m", "Height above mean sea level.", number(point.amsl_m)),
                     required(field("kind", "", "What the point resets; start and end are the ends of the flight.",
                                    choice(point.kind, {"start", "end", "vertical", "horizontal"}))),
                     field("may_fail", "", "true: the correction works with the chance `success` only.",
                           flag(point.may_fail))},
          .one_of = {{"position_m"}, {"lat", "lon", "amsl_m"}}};
}

/// `drift_per_m` is a group of its own in the file only.
Description describe_drift(NavigationSpec& navigation) {
  return {.fields = {field("vertical", "units/m", "Growth of the vertical error.",
                           number(navigation.drift_vertical_per_m, at_least(0))),
                     field("horizontal", "units/m", "Growth of the horizontal error.",
                           number(navigation.drift_horizontal_per_m, at_least(0)))}};
}

Description describe(NavigationSpec& navigation) {
  return {
      .fields = {
          field("points", "",
                "CSV file with the columns id, x_m, y_m, z_m (or lat, lon, amsl_m), kind, may_fail and, if wanted, "
                "success; relative to this file. Or a list of points.",
                FileOrGroups{text(navigation.points_file, Text::Use::path), groups(navigation.points, 1)}),
          field("drift_per_m", "", "How fast the errors grow with the length flown.",
                Group{.open = [&navigation] { return describe_drift(navigation); }}),
          required(field("alpha", "units", "Most vertical and most horizontal error on arrival at a vertical point.",
                         numbers(navigation.alpha, at_least(0)))),
          required(field("beta", "units", "Most vertical and most horizontal error on arrival at a horizontal point.",
                         numbers(navigation.beta, at_least(0)))),
          required(
              field("theta", "units", "At the goal both errors must be below it.", number(navigation.theta, above(0)))),
          field("success", "", "Chance that a correction works at a point that may fail.",
                number(navigation.success, from_to(0, 1))),
          field("residual", "units", "A correction that fails leaves this error, or what there was if that is less.",
                number(navigation.residual, at_least(0))),
          field("turn_radius_m", "m", "Radius of the turns between points; needed by turn_model.",
                number(navigation.turn_radius_m, above(0))),
          field(
              "turn_model", "",
              "none: straight legs. arc_tangent: at each point turn until the next one lies ahead, then fly straight. "
              "free_heading: the headings at the points are chosen, too.",
              choice(navigation.turn_model, {"none", "arc_tangent", "free_heading"}))}};
}

Description describe(PlannerSpec& planner) {
  return {
      .fields = {required(field("name", "", "As `alate planners` lists them.", text(planner.name))),
                 field("preset", "", "Set of parameters of that planner. Not given: its first.", text(planner.preset)),
                 field("parameters", "", "Single parameters, over those of the preset.", Words{&planner.parameters})}};
}

}  // namespace

Description describe(Scenario& scenario) {
  return {
      .fields = {
          field("frame", "", "The one metric frame the route is planned in.", group(scenario.frame)),
          field("terrain", "", "The ground and the band above it.", group(scenario.terrain)),
          field("grid", "",
                "Free and blocked cells in place of terrain, in a local frame with (0, 0) at the lower left corner; "
                "cells cut from dem lie on Earth. Start and goal are cells, and routes lie at z = 0 or at the flight "
                "level. A blocked cell is ground of endless height for the rule terrain_clearance: a leg may run along "
                "one side of it, but neither enter it nor cut its corner. A voxel map fills the air: x east, y north "
                "and z "
                "up, all from 0, and routes lie where cells are free; a leg may run along one face of a blocked cell, "
                "but neither enter it nor cut its edge or corner.",
                group(scenario.grid)),
          written_if(scenario.start.place.given(),
                     required_unless("navigation",
                                     field("start", "",
                                           "Where the flight begins. If the points of `navigation` have a start, it "
                                           "may be left out, or must lie within 1 m of that.",
                                           group(scenario.start)))),
          written_if(scenario.goal.place.given(),
                     required_unless("navigation",
                                     field("goal", "",
                                           "Where it ends. If the points of `navigation` have an end, it may be left "
                                           "out, or must lie within 1 m of that.",
                                           group(scenario.goal)))),
          field("vehicle", "",
                "Limits of the aircraft; what is not given is not checked. A planner on the attitude lattice "
                "needs step_m and all three lists of angles.",
                group(scenario.vehicle)),
          field("threats", "", "Spheres and cylinders to be avoided.", groups(scenario.threats)),
          field("objective", "", "What a good route is.", group(scenario.objective)),
          field("navigation", "",
                "Navigation errors, in units, that grow on the way and are reset at correction points (Zhou et al. "
                "2020).",
                group(scenario.navigation)),
          field("planner", "", "The planner, unless the command line names one. Not given: chosen for the scenario.",
                group(scenario.planner))}};
}

std::string text_of(const std::vector<std::vector<std::string>>& one_of) {
  std::vector<std::string> sets;
  for (const auto& keys : one_of) sets.push_back(keys.empty() ? "none" : fmt::format("{}", fmt::join(keys, ", ")));
  return fmt::format("{}", fmt::join(sets, " | "));
}

std::string Range::text() const {
  const char* mark = open ? "" : "=";
  const std::string lower = min > -kMaxMagnitude ? fmt::format(">{} {}", mark, min) : "";
  const std::string upper = max < kMaxMagnitude ? fmt::format("<{} {}", mark, max) : "";
  if (lower.empty() || upper.empty()) return lower + upper;
  return open ? lower + " and " + upper : fmt::format("{} to {}", min, max);
}

}  // namespace alate
