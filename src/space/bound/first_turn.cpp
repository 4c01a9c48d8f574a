#include "space/bound/first_turn.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace alate {

namespace {

constexpr int kLines = 32;
/// Pieces of a line, each looked at on its own.
constexpr int kPieces = 32;
/// Part of the radius by which rounding may tighten a turn.
constexpr double kSpare = 1e-6;

struct Line {
  Vec2 middle;
  Vec2 aside;  ///< From the middle to an end.
};

/// The hull of the altitudes in `reached` that are open somewhere on the line.
Altitudes open_on(const OpenAir& air, const Line& line, const Altitudes& reached) {
  Altitudes hull{.low = std::numeric_limits<double>::infinity(), .high = -std::numeric_limits<double>::infinity()};
  for (int k = 0; k < kPieces; ++k) {
    const Vec2 a = line.middle + (2.0 * k / kPieces - 1) * line.aside;
    const Vec2 b = line.middle + (2.0 * (k + 1) / kPieces - 1) * line.aside;
    const Altitudes open = air.along(a, b);
    if (!open.any() || !open.overlap(reached)) continue;
    hull.low = std::min(hull.low, std::max(open.low, reached.low));
    hull.high = std::max(hull.high, std::min(open.high, reached.high));
  }
  return hull;
}

}  // namespace

std::optional<Dead> dead_ahead(const Problem& problem, Voids voids) {
  const Mission& mission = problem.mission;
  if (!mission.heading_given || !problem.vehicle.turn_radius_m) return std::nullopt;
  const double radius = *problem.vehicle.turn_radius_m * (1 - kSpare);
  const OpenAir air(problem.world.site(), voids);
  const SlopeLimits slopes = optimistic_slopes(problem.vehicle);
  const Vec2 ahead = direction_of(mission.heading_rad).head<2>();
  const Vec2 aside(-ahead.y(), ahead.x());
  const double to_goal = (mission.goal - mission.start).head<2>().norm() - mission.tolerance_m;
  Altitudes reached{.low = mission.start.z(), .high = mission.start.z()};
  double flown = 0;
  for (int k = 1; k <= kLines; ++k) {
    const double x = radius * k / kLines;
    const double most = radius * std::asin(static_cast<double>(k) / kLines);
    if (most >= to_goal) return std::nullopt;  // It may have arrived.
    reached.low -= (most - flown) * slopes.descent;
    reached.high += (most - flown) * slopes.climb;
    flown = most;
    const Line line{.middle = mission.start.head<2>() + x * ahead,
                    .aside = (radius - std::sqrt(std::max(0.0, radius * radius - x * x))) * aside};
    reached = open_on(air, line, reached);
    if (!reached.any()) return Dead{.where = line.middle, .ahead_m = x};
  }
  return std::nullopt;
}

}  // namespace alate
