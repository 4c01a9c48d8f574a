// The planner that finds the shortest way at any angle, and proves it.
#include <algorithm>

#include "plan/grid/grid_exact.hpp"
#include "plan/grid/grid_planners.hpp"
#include "search/grid/anya.hpp"
#include "search/grid/keep_clear.hpp"

namespace alate {

namespace {

/// Legs at any angle, which turn at corners of blocked cells.
struct AnyAngle : GridLegs {
  static double least_length(const Problem& problem) {
    return (problem.mission.goal - problem.mission.start).head<2>().norm();
  }
  /// `check` lets a leg pass a corner through the free cells beside it, not through the corner itself, and takes places
  /// a thousandth of a millimetre apart for one: so the route keeps a hair of twice that from corners.
  static std::vector<Vec3> places(const Problem& problem, const BitGrid& cells, const AnyAngleWay& way) {
    const HeightGrid& grid = *problem.world.site().grid;
    constexpr double kHair_m = 2e-6;
    std::vector<Vec3> places;
    for (const GridPoint& point : kept_clear(cells, way.points, kHair_m / grid.cell_m)) {
      const Vec2 place = grid.origin + Vec2(point.x - 1, grid.rows + 1 - point.y) * grid.cell_m;
      places.emplace_back(place.x(), place.y(), grid.level_m);
    }
    return places;
  }
  /// The way that touches corners: the length that routes come close to as hairs get finer. Between two turns it is a
  /// cell long or more, so what ties may hide (Anya::kTie a turn) is less than this share of it.
  static double proven_cost(const Problem& problem, const AnyAngleWay& way, double cost) {
    const double ties = way.points.size() > 2 ? 4 * Anya::kTie : 0;
    const double length_m = way.length * problem.world.site().grid->cell_m;
    return std::min(cost, problem.objective.length * length_m * (1 - ties));
  }
};

}  // namespace

PlannerEntry theta_star_entry() {
  PlannerEntry entry = grid_exact_entry<Anya, AnyAngle>(
      {.name = "theta-star",
       .help =
           "The shortest way at any angle over a grid, proven: it turns at corners of blocked cells, by a hair, and "
           "no way from cell to cell is shorter. In the place of Theta* (Nash et al. 2007), whose ways are short "
           "but not the shortest, stands Anya (Harabor, Grastien, Oez and Aksakalli 2016).",
       .preset = {.name = "default", .help = "Anya over a grid, Lazy Theta* elsewhere.", .values = {}},
       .fits = ""});
  entry.can.space = "height grid at any angle";  // what it proves is no optimum from cell to cell
  return entry;
}

}  // namespace alate
