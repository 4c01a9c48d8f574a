// A scenario with the files it names read and every place brought into one metric frame. Plain data: what both
// the planners' World and the independent check start from.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "alate/core/frame.hpp"
#include "alate/core/scenario.hpp"
#include "alate/data/height_grid.hpp"
#include "alate/data/height_raster.hpp"
#include "alate/data/peaks.hpp"
#include "alate/data/voxel_grid.hpp"

namespace alate {

/// Where a leg may be above the ground. Unlimited upwards where no ceiling is given.
struct Band {
  double clearance_m = 0;
  std::optional<double> ceiling_agl_m;
  std::optional<double> ceiling_amsl_m;
};

struct Threat {
  enum class Shape { sphere, cylinder };
  std::string name;
  Shape shape = Shape::sphere;
  Vec3 center;  ///< Of a cylinder: x and y of the axis, z = floor.
  double radius_m = 0;
  double level = 1;
  double core_m = 0;   ///< Must not be entered; 0: none.
  double floor_m = 0;  ///< Cylinder only, above mean sea level.
  double top_m = 0;
};

/// Where the flight begins and ends.
struct Mission {
  Vec3 start = Vec3::Zero();
  double heading_rad = 0;  ///< Clockwise from +y.
  bool heading_given = false;
  Vec3 goal = Vec3::Zero();
  double tolerance_m = 0;
};

/// Limits of the aircraft in SI units and radians; absent limits are not checked.
struct Vehicle {
  std::optional<double> speed_mps;
  std::optional<double> turn_radius_m;
  std::optional<double> climb_rad;
  std::optional<double> descent_rad;  ///< Positive.
  std::optional<double> range_m;
  std::optional<double> step_m;
  std::vector<double> roll_rad;
  std::vector<double> pitch_rad;
  std::vector<double> yaw_rad;

  /// Has a step and at least one angle of each kind: can be flown on the attitude lattice.
  bool has_attitude_steps() const;
};

/// Where a navigation error is reset, in the frame.
struct CorrectionPoint {
  int id = 0;  ///< As the user numbers it.
  Vec3 position = Vec3::Zero();
  PointKind kind = PointKind::vertical;  ///< vertical or horizontal.
  double success = 1;                    ///< Chance that the correction works, each time and independently.
};

/// Drift and reset of the navigation error (Zhou et al. 2020, problems 1 to 3). Errors in units. Both are 0 at the
/// start and grow with the length flown. A point may be used only if the errors on arrival keep its limits.
struct Navigation {
  static constexpr int kNoId = -1;

  struct Limits {
    double vertical = 0;
    double horizontal = 0;
  };
  std::vector<CorrectionPoint> points;  ///< In the order of the file; neither start nor goal.
  double drift_vertical = 0;            ///< Units a metre.
  double drift_horizontal = 0;
  Limits at_vertical;    ///< alpha1, alpha2: at most.
  Limits at_horizontal;  ///< beta1, beta2: at most.
  double theta = 0;      ///< At the goal: below.
  double residual = 0;   ///< A failed correction leaves min(error, residual).
  TurnModel turn_model = TurnModel::none;
  double turn_radius_m = 0;  ///< 0: none.
  int start_id = kNoId;      ///< Ids of the ends, where the points have them.
  int goal_id = kNoId;
};

struct Site {
  Scenario scenario;
  Frame frame = Frame::local();
  std::variant<std::monostate, HeightRaster, PeakGround> ground;
  std::optional<HeightGrid> grid;
  std::optional<VoxelGrid> voxels;  ///< In place of `grid`; never beside ground.
  Band band;
  Mission mission;
  Vehicle vehicle;
  std::vector<Threat> threats;
  std::optional<Navigation> navigation;
  std::vector<std::string> warnings;

  bool has_ground() const { return !std::holds_alternative<std::monostate>(ground); }
  /// Nothing without ground or outside it; NaN on unknown ground.
  std::optional<double> ground_height(const Vec2& xy) const;
};

/// Reads what the scenario names. Throws InputError with all faults: unreadable terrain, start or goal outside
/// the terrain, on unknown ground or under it, in a threat core, above a ceiling, places without a height.
Site load_site(const Scenario& scenario);

}  // namespace alate
