// Routes at any angle before `check`, whatever the size of cells and wherever the grid lies.
#include <gtest/gtest.h>

#include <random>

#include "alate/check/check.hpp"
#include "alate/plan/registry.hpp"
#include "data/scen_file.hpp"
#include "support/fly.hpp"
#include "support/grid_sites.hpp"
#include "support/shared_data.hpp"

namespace alate {
namespace {

Plan plan_on(const Site& site, const std::string& planner) { return test::fly(World(site), {.name = planner}); }

/// A site on random cells; the ends are free.
Site random_site(double cell_m, std::mt19937_64& random) {
  const auto columns = static_cast<int>(2 + random() % 60);
  const auto rows = static_cast<int>(2 + random() % 60);
  HeightGrid grid{.columns = columns,
                  .rows = rows,
                  .cell_m = cell_m,
                  .origin = Vec2(500'000.25, 4'000'000.75),
                  .blocked = {},
                  .height_m = {}};
  const std::uint64_t percent = random() % 45;
  for (int i = 0; i < columns * rows; ++i) grid.blocked.push_back(random() % 100 < percent ? 1 : 0);
  grid.blocked[grid.index(0, rows - 1)] = 0;
  grid.blocked[grid.index(columns - 1, 0)] = 0;
  return test::grid_site(std::move(grid));
}

TEST(AnyAngle, RoutesPassCheckAndTheirBoundsAreClose) {
  std::mt19937_64 random(5);
  for (const double cell_m : {0.01, 1.0, 37.5, 10'000.0}) {
    int found = 0;
    for (int map = 0; map < 150; ++map) {
      const Site site = random_site(cell_m, random);
      const Plan plan = plan_on(site, "theta-star");
      const Plan by_cells = plan_on(site, "jps");
      ASSERT_EQ(plan.outcome, by_cells.outcome) << cell_m << ' ' << map;
      if (plan.outcome != Outcome::optimal) continue;
      ++found;
      const Verdict verdict = check(site, plan.route);
      EXPECT_TRUE(verdict.ok()) << cell_m << ' ' << map;
      for (const Violation& broken : verdict.violations) ADD_FAILURE() << broken.rule << " on leg " << broken.leg;
      EXPECT_LE(plan.cost, by_cells.cost + 1e-5 * static_cast<double>(plan.route.states.size()));
      EXPECT_GE(plan.cost, plan.lower_bound);
      EXPECT_LE(plan.cost - plan.lower_bound, 6e-6 * static_cast<double>(plan.route.states.size()) + 1e-9 * plan.cost);
    }
    EXPECT_GT(found, 50);
  }
}

/// Straight past corners on one side and on both, and along walls.
TEST(AnyAngle, StraightLinesPastCornersPassCheck) {
  for (const std::vector<std::string>& lines :
       std::vector<std::vector<std::string>>{{"....", "....", "#...", "..#."},
                                             {"...", ".#.", "#.."},
                                             {"..#", "...", "#.."},
                                             {"#...", "..#.", ".#..", "...#"},
                                             {"..#....", "......#"},
                                             {".####.", "......", "......", ".####."}}) {
    const HeightGrid grid = test::grid_of(lines);
    for (int start = 0; start < grid.columns * grid.rows; ++start) {
      for (int goal = 0; goal < grid.columns * grid.rows; ++goal) {
        Site site = test::grid_site(grid);
        if (grid.blocked[static_cast<std::size_t>(start)] + grid.blocked[static_cast<std::size_t>(goal)] > 0) continue;
        site.mission.start = grid.center(start % grid.columns, start / grid.columns);
        site.mission.goal = grid.center(goal % grid.columns, goal / grid.columns);
        const Plan plan = plan_on(site, "theta-star");
        EXPECT_EQ(plan.outcome, plan_on(site, "astar").outcome);
        EXPECT_TRUE(plan.route.empty() || check(site, plan.route).ok()) << start << ' ' << goal;
      }
    }
  }
}

TEST(AnyAngle, NoWayIsProven) {
  const Plan plan = plan_on(test::grid_site(test::grid_of({"..#.", "..#.", "..#."})), "theta-star");
  EXPECT_EQ(plan.outcome, Outcome::infeasible_proven);
  EXPECT_NE(plan.why.find("[1, 0]"), std::string::npos) << plan.why;
}

TEST(AnyAngle, StartAndGoalMayBeOne) {
  Site site = test::grid_site(test::grid_of({"..", ".."}));
  site.mission.goal = site.mission.start;
  const Plan plan = plan_on(site, "theta-star");
  EXPECT_EQ(plan.outcome, Outcome::optimal);
  EXPECT_EQ(plan.route.states.size(), 1U);
  EXPECT_EQ(plan.cost, 0);
}

TEST(AnyAngle, BenchmarkRoutesPassCheck) {
  ALATE_NEEDS_SHARED_DATA("movingai/2d");
  for (const std::string name :
       {"arena", "den312d", "lak303d", "Boston_0_256", "brc202d", "Berlin_1_512", "Paris_1_1024"}) {
    std::vector<Fault> faults;
    const auto scen = read_scen_file(test::shared_data("movingai/2d/" + name + ".map.scen").string(), faults);
    ASSERT_TRUE(scen.has_value()) << to_string(faults.front());
    Site site = test::grid_site(scen->grid);
    const auto set_ends = [&](const ScenRow& row) {
      site.mission.start = site.grid->center(row.start_column, row.start_row);
      site.mission.goal = site.grid->center(row.goal_column, row.goal_row);
    };
    set_ends(scen->rows.front());
    const World world(site);
    Executor executor(1);
    const ChosenPlanner chosen = choose_planner(builtin_planners(), Problem(world), {.name = "theta-star"});
    for (std::size_t i = 0; i < scen->rows.size(); i += 17) {
      const ScenRow& row = scen->rows[i];
      set_ends(row);
      RunContext run(executor, {});
      const Plan plan = chosen.planner.plan(Problem(world, site.mission), run);
      EXPECT_EQ(plan.outcome, Outcome::optimal) << name << " row " << i;
      EXPECT_TRUE(check(site, plan.route).ok()) << name << " row " << i;
      EXPECT_LE(plan.cost, row.optimum * (1 + 1e-6) + scen_tolerance(row.optimum)) << name << " row " << i;
    }
  }
}

}  // namespace
}  // namespace alate
