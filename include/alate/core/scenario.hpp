// What was asked: plain data in the units of the file, comparable, written back as it was read.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "alate/core/frame.hpp"

namespace alate {

struct FrameSpec {
  std::string crs = "auto";  ///< "auto": UTM zone of the midpoint of start and goal.
  std::optional<GeoPoint> origin;
  bool local = false;

  bool operator==(const FrameSpec&) const = default;
};

/// One Gaussian hill, h exp(-((x-cx)/sx)^2 - ((y-cy)/sy)^2) (Mai et al. 2023, eq. 1).
struct PeakSpec {
  std::array<double, 2> center_m{};
  double height_m = 0;
  std::array<double, 2> slope_m{};

  bool operator==(const PeakSpec&) const = default;
};

enum class PeakCombination { sum, max };

struct TerrainSpec {
  std::string dem;  ///< Raster file, already resolved against the scenario's folder; empty if peaks are given.
  std::vector<PeakSpec> peaks;
  PeakCombination combine = PeakCombination::sum;
  std::optional<std::array<double, 2>> extent_m;  ///< Of the peaks: [0, w] x [0, h].
  double clearance_m = 0;                         ///< Least height of a leg above ground.
  std::optional<double> ceiling_agl_m;
  std::optional<double> ceiling_amsl_m;

  bool operator==(const TerrainSpec&) const = default;
};

/// Cells drawn at random: each is blocked with probability `obstacles`, start and goal never.
struct RandomGridSpec {
  std::array<int, 2> size{};  ///< Columns, rows.
  double obstacles = 0.2;
  int seed = 1;

  bool operator==(const RandomGridSpec&) const = default;
};

enum class GridHeights {
  flat,
  peaks  ///< |MATLAB's peaks|, rotated by 90 degrees (Yin et al. 2021).
};

/// Free and blocked cells in the plane or in space, from a file, drawn, or cut from a raster of heights.
struct GridSpec {
  std::string map;  ///< Moving AI map (.map, .3dmap), resolved against the scenario's folder; empty if there is none.
  std::optional<RandomGridSpec> random;
  std::string dem;                     ///< Raster file, resolved in the same way; empty if there is none.
  std::optional<double> level_amsl_m;  ///< Flight level; with `dem` only.
  double clearance_m = 0;              ///< Least height of the flight level above ground; with `dem` only.
  GridHeights heights = GridHeights::flat;
  double cell_m = 1;

  bool operator==(const GridSpec&) const = default;
};

/// A place given in the frame (`position_m`), as a cell of the grid, or in WGS 84 with a height above sea level or
/// ground.
struct PlaceSpec {
  std::optional<std::array<double, 3>> position_m;
  std::optional<std::array<int, 2>> cell;  ///< Column, row, (0, 0) is the upper left; or x and y of a voxel.
  std::optional<int> layer;                ///< z of a voxel, the third number of `cell`.
  std::optional<double> lat_deg;
  std::optional<double> lon_deg;
  std::optional<double> amsl_m;
  std::optional<double> agl_m;

  bool given() const { return position_m || cell || lat_deg; }
  bool operator==(const PlaceSpec&) const = default;
};

struct StartSpec {
  PlaceSpec place;
  std::optional<double> heading_deg;  ///< Clockwise from grid north; none: towards the goal.

  bool operator==(const StartSpec&) const = default;
};

struct GoalSpec {
  PlaceSpec place;
  double tolerance_m = 0;

  bool operator==(const GoalSpec&) const = default;
};

/// Limits of the aircraft. What is not given is not checked.
struct VehicleSpec {
  std::optional<double> speed_mps;
  std::optional<double> turn_radius_m;
  std::optional<double> climb_deg;
  std::optional<double> descent_deg;
  std::optional<double> range_m;
  std::optional<double> step_m;  ///< Length of one move on the attitude lattice.
  std::vector<double> roll_deg;  ///< Rotations per move; right wing down, nose up, nose right are positive.
  std::vector<double> pitch_deg;
  std::vector<double> yaw_deg;

  bool operator==(const VehicleSpec&) const = default;
};

struct CylinderSpec {
  std::optional<std::array<double, 2>> center_m;
  std::optional<double> lat_deg;
  std::optional<double> lon_deg;
  double floor_m = 0;  ///< Above mean sea level.
  double top_m = 0;

  bool operator==(const CylinderSpec&) const = default;
};

/// A sphere, or an upright cylinder, that should be avoided (radius) or must not be entered (core).
struct ThreatSpec {
  std::string name;
  std::optional<std::array<double, 3>> center_m;
  std::optional<double> lat_deg;
  std::optional<double> lon_deg;
  std::optional<double> amsl_m;
  std::optional<double> agl_m;
  std::optional<CylinderSpec> cylinder;
  double radius_m = 0;
  double level = 1;
  double core_m = 0;

  bool operator==(const ThreatSpec&) const = default;
};

enum class CostModel {
  physical,        ///< metres: length*L + threat*integral + climb*ascent
  konatowski2019,  ///< sum over nodes of fuel*distance-to-goal + threat*sum(level*(r-d)+)
};

struct ObjectiveSpec {
  CostModel model = CostModel::physical;
  double length = 1;
  double threat = 20;  ///< Weight of exposure in either model (0.5 by default under konatowski2019).
  double climb = 2;
  double fuel = 0.5;  ///< konatowski2019 only; fuel + threat = 1.

  bool operator==(const ObjectiveSpec&) const = default;
};

/// What a correction point resets, or which end of the flight it is (Zhou et al. 2020).
enum class PointKind { start, end, vertical, horizontal };

enum class TurnModel {
  none,         ///< Straight legs.
  arc_tangent,  ///< Each leg turns on a circle until it heads for the next point, then is straight.
  free_heading  ///< Each leg is arc, straight, arc; headings at the points are free.
};

/// One point of an inline list. Its id is `id`, or its place in the list from 0.
struct CorrectionPointSpec {
  std::optional<int> id;
  std::optional<std::array<double, 3>> position_m;
  std::optional<double> lat_deg;
  std::optional<double> lon_deg;
  std::optional<double> amsl_m;
  PointKind kind = PointKind::vertical;
  bool may_fail = false;

  bool operator==(const CorrectionPointSpec&) const = default;
};

/// Navigation error that grows as the aircraft flies and is reset at correction points. Errors in units.
struct NavigationSpec {
  std::string points_file;  ///< CSV, already resolved against the scenario's folder; empty if points are listed.
  std::vector<CorrectionPointSpec> points;
  double drift_vertical_per_m = 0.001;
  double drift_horizontal_per_m = 0.001;
  std::array<double, 2> alpha{};  ///< Most vertical, horizontal error on arrival at a vertical point.
  std::array<double, 2> beta{};   ///< Most vertical, horizontal error on arrival at a horizontal point.
  double theta = 0;               ///< At the goal both errors must be below it.
  double success = 0.8;           ///< Chance that a correction works at a point that may fail.
  double residual = 5;            ///< A failed correction leaves min(error, residual).
  std::optional<double> turn_radius_m;
  TurnModel turn_model = TurnModel::none;

  bool operator==(const NavigationSpec&) const = default;
};

/// Planner as named in the file; parameter values stay text until the planner's ParamTable reads them.
struct PlannerSpec {
  std::string name;
  std::string preset;
  std::map<std::string, std::string> parameters;

  bool operator==(const PlannerSpec&) const = default;
};

/// Where a field stood in the text, for faults found after reading.
struct Mark {
  std::string file;
  int line = 0;
  int column = 0;
};

struct Scenario {
  FrameSpec frame;
  std::optional<TerrainSpec> terrain;
  std::optional<GridSpec> grid;
  StartSpec start;
  GoalSpec goal;
  VehicleSpec vehicle;
  std::vector<ThreatSpec> threats;
  ObjectiveSpec objective;
  std::optional<NavigationSpec> navigation;
  std::optional<PlannerSpec> planner;

  std::string file;                    ///< As the user named it; "-" for standard input. Not compared.
  std::vector<std::string> overrides;  ///< `key.path=VALUE` as given, in order. Not compared.
  std::map<std::string, Mark> marks;   ///< Dotted path -> place in the text. Not compared.

  /// Compares what was asked, not where it stood.
  bool operator==(const Scenario& other) const;
};

/// Where `field` (a dotted path) stands in the text, or the nearest group around it that has a mark; else the
/// scenario's file without a line. For faults found after reading.
Mark mark_of(const Scenario& scenario, const std::string& field);

}  // namespace alate
